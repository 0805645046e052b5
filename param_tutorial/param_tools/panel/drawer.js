/* The drawer: presets, and the history of the session. One of the two is open at a time, or none.

   What is chosen in a list opens below its line and says what would change; the kernel asks the nodes: `drawer.py`. */

import {all, focusedBeside, localTime, make, one, uniqueName} from './dom.js';
import {initialize} from './front.js';

/**
 * @import {RenderProps} from '@anywidget/types'
 *
 * A line of the history: when, and what happened.
 * @typedef {{time: string, whose: string, says: string}} Change
 *
 * @typedef {{folder?: string, nodes?: string[], presets?: {name: string, taken: string, holds: string}[],
 *   changes?: Change[], heard?: number, is_read_only?: boolean}} DrawerState
 *
 * What is looked at: a preset by its name, or a moment.
 * @typedef {{name?: string, time?: string}} Source
 *
 * The kernel's answer to the message of this number: what would change, as HTML, and whether anything would; or what was
 * done.
 * @typedef {{client: string, number: number, markup?: string, can?: boolean, said?: string}} Answer
 */

const TABS = {presets: 'Presets', history: 'History'};

/** Keys that do something on a page of panels. */
const KEYS = [
  ['/', 'search'],
  ['Ctrl+Z', 'undo, in the panel that has the focus; with Shift: redo'],
  ['← → PgUp PgDn', 'move a slider by a step, or by many'],
  ['Enter', 'send what was typed'],
  ['Esc', 'forget what was typed; empty the search; close what is open here'],
  ['?', 'this list'],
];

/** @param {RenderProps<{state: DrawerState}>} props */
function render({model, el}) {
  const client = uniqueName();
  const drawer = new Drawer(client, content => model.send({client, ...content}));
  el.append(drawer.element);
  const show = () => drawer.show(model.get('state'));
  /** @param {KeyboardEvent} event */
  const onKey = event => drawer.onPageKey(event);
  show();
  model.on('change:state', show);
  model.on('msg:custom', message => message.client === client && drawer.answer(message));
  document.addEventListener('keydown', onKey);
  return () => document.removeEventListener('keydown', onKey);
}

/** The form that saves a preset, with a name that it suggests until another one is typed. */
class SaveForm {
  isNamed = false;
  /** The node that was chosen, while it is there. */
  chosen = '';
  /** @type {string[]} */
  presets = [];

  /**
   * @param {string} id One that nothing else on the page has.
   * @param {(name: string, node: string) => void} save Called with an empty text for all nodes.
   */
  constructor(id, save) {
    this.element = make('form', {
      className: 'param-file-line',
      innerHTML: `<label for="${id}-name">Save as</label>
        <input type="text" id="${id}-name" autocomplete="off" spellcheck="false">
        <label for="${id}-node">of</label><select id="${id}-node"></select>
        <button type="submit">Save</button><span class="drawer-folder"></span>`,
    });
    this.name = one(this.element, 'input', HTMLInputElement);
    this.nodes = one(this.element, 'select', HTMLSelectElement);
    this.button = one(this.element, 'button', HTMLButtonElement);
    this.folder = one(this.element, '.drawer-folder');
    this.name.addEventListener('input', () => {
      this.isNamed = this.name.value !== '';
      this.drawButton();
    });
    this.nodes.addEventListener('change', () => {
      this.chosen = this.nodes.value;
      this.isNamed = false;
      this.suggest();
    });
    this.element.addEventListener('submit', event => {
      event.preventDefault();
      this.isNamed = false;
      save(this.name.value, this.nodes.value);
    });
  }

  /** @param {DrawerState} state */
  show({presets = [], nodes = [], folder = ''}) {
    this.presets = presets.map(each => each.name);
    this.folder.textContent = `in ${folder}`;
    const offered = nodes.length === 1 ? nodes : ['', ...nodes];
    if ([...this.nodes.options].map(each => each.value).join() !== offered.join()) {
      this.nodes.replaceChildren(...offered.map(each => new Option(each || 'all nodes', each)));
      this.nodes.value = offered.includes(this.chosen) ? this.chosen : offered[0];
    }
    this.suggest();
  }

  suggest() {
    if (!this.isNamed) {
      const whose = this.nodes.value.replace(/^\//, '').replaceAll('/', '__') || 'all';
      this.name.value = `${whose}_${minuteOf(Date.now()).replace(' ', '_').replace(':', '-')}`;
    }
    this.drawButton();
  }

  drawButton() {
    const isThere = this.presets.includes(this.name.value.trim().replace(/\.yaml$/, ''));
    this.button.textContent = isThere ? 'Replace' : 'Save';
    this.button.disabled = !this.name.value.trim();
  }
}

/** @param {string | number} time */
const minuteOf = time => localTime(time).slice(0, 16);

/** What opens below a line: what would change, and what can be done. */
class Look {
  markup = '';

  /** @param {(wish: {do: string, to?: string}) => void} act */
  constructor(act) {
    this.element = make('div', {
      className: 'drawer-look param-file',
      innerHTML: `<div role="status"></div><form class="param-file-line">
        <button type="button" name="apply">Apply</button><span class="drawer-file">
        <button type="button" name="delete"></button>
        <input type="text" aria-label="New name" autocomplete="off" spellcheck="false">
        <button type="submit">Rename</button></span></form>`,
    });
    this.told = one(this.element, '[role=status]');
    this.apply = one(this.element, '[name=apply]', HTMLButtonElement);
    this.file = one(this.element, '.drawer-file');
    this.remove = one(this.element, '[name=delete]', HTMLButtonElement);
    this.name = one(this.element, 'input', HTMLInputElement);
    this.apply.addEventListener('click', () => act({do: 'apply'}));
    this.remove.addEventListener('click', () => {
      if (this.remove.dataset.sure) act({do: 'delete'});
      this.remove.dataset.sure = 'yes';
      this.remove.textContent = 'Delete for good';
    });
    one(this.element, 'form', HTMLFormElement).addEventListener('submit', event => {
      event.preventDefault();
      act({do: 'rename', to: this.name.value});
    });
  }

  /**
   * Begin anew.
   * @param {string | undefined} preset The name of a preset, which has a file.
   */
  reset(preset) {
    this.told.replaceChildren();
    this.apply.disabled = true;
    this.file.hidden = preset === undefined;
    this.name.value = preset ?? '';
    this.remove.textContent = 'Delete';
    delete this.remove.dataset.sure;
  }

  /**
   * @param {string} markup
   * @param {boolean} can
   */
  tell(markup, can) {
    // What has the focus or was scrolled stays, if nothing is new.
    if (this.markup !== markup || !this.told.firstChild) this.told.innerHTML = markup;
    this.markup = markup;
    this.apply.disabled = !can;
  }
}

class Drawer {
  number = 0;
  tab = '';
  /** What the open line is about. @type {Source | undefined} */
  source;
  /** @type {DrawerState} */
  state = {};
  /** The lines of the list, by what tells them apart. @type {Map<string, HTMLElement>} */
  lines = new Map();
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  timer;
  list = make('ul', {className: 'drawer-list'});
  said = make('div', {className: 'param-file drawer-said', role: 'status'});
  keys = make('dl', {className: 'drawer-keys', hidden: true});
  keysOpener = make('button', {type: 'button', title: 'Keys (key: ?)', ariaLabel: 'Keys'}, '?');

  /**
   * @param {string} id One that nothing else on the page has.
   * @param {(content: Record<string, unknown>) => void} ask
   */
  constructor(id, ask) {
    this.ask = ask;
    this.form = new SaveForm(`drawer-${id}`, (name, node) => {
      this.choose(undefined);
      this.send({do: 'save', name, node});
    });
    this.look = new Look(wish => {
      const {source} = this;
      // It has no file of this name any more.
      if (wish.do !== 'apply') this.leaveLine();
      this.send({...wish, ...source});
    });
    for (const [key, does] of KEYS) this.keys.append(make('div', {}, make('dt', {}, key), make('dd', {}, does)));
    const parts = [this.form.element, this.said, this.list];
    this.body = make('div', {className: 'drawer-body', hidden: true, id: `drawer-${id}`}, ...parts);
    this.openers = Object.entries(TABS).map(([tab, word]) => {
      const button = make('button', {type: 'button', name: tab}, word);
      button.setAttribute('aria-controls', this.body.id);
      button.addEventListener('click', () => this.open(this.tab === tab ? '' : tab));
      return button;
    });
    this.keysOpener.addEventListener('click', () => this.toggleKeys());
    const bar = make('div', {className: 'drawer-bar'}, ...this.openers, this.keysOpener);
    const what = {className: 'drawer', ariaLabel: 'Presets and history'};
    this.element = make('section', what, bar, this.keys, this.body);
    this.element.addEventListener('keydown', event => {
      // JupyterLab has meanings of its own for keys.
      if (event.target instanceof HTMLInputElement) event.stopPropagation();
      if (event.key === 'Escape') this.close();
    });
    this.draw();
  }

  /** @param {KeyboardEvent} event */
  onPageKey(event) {
    const isTyping =
      event.target instanceof Element && event.target.matches('input:not([type=range], [type=checkbox]), textarea');
    // In a notebook these keys are JupyterLab's.
    if (isTyping || !document.body.dataset.voila) return;
    if (event.key === '?') this.toggleKeys();
    const search = document.querySelector('.param-search');
    if (event.key !== '/' || !(search instanceof HTMLElement)) return;
    event.preventDefault();
    search.focus();
  }

  toggleKeys() {
    this.keys.hidden = !this.keys.hidden;
    this.draw();
  }

  close() {
    const opener = this.openers.find(each => each.name === this.tab) ?? this.keysOpener;
    this.keys.hidden = true;
    this.open('');
    opener.focus();
  }

  /** @param {string} tab */
  open(tab) {
    this.tab = tab;
    this.choose(undefined);
    this.said.replaceChildren();
    this.list.replaceChildren();
    this.lines.clear();
    this.form.isNamed = false;
    this.send({do: 'open', tab});
    this.draw();
  }

  /** @param {Record<string, unknown>} content */
  send(content) {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.number += 1;
    this.ask({...content, number: this.number});
  }

  /** Open a line, or close the one that is open. @param {Source | undefined} source */
  choose(source) {
    this.source = source;
    this.look.element.remove();
    this.look.reset(this.state.is_read_only ? undefined : source?.name);
    if (source) {
      this.said.replaceChildren();
      this.send({do: 'look', ...source});
    }
    this.draw();
  }

  /** @param {DrawerState} state */
  show(state) {
    // What would change may be something else now.
    if (this.source && this.state.heard !== state.heard) {
      this.timer ??= setTimeout(() => this.source && this.send({do: 'look', ...this.source}), 1000);
    }
    this.state = state;
    this.draw();
  }

  /** @param {Answer} answer */
  answer({number, markup, can, said}) {
    if (number !== this.number) return;
    if (markup !== undefined) this.look.tell(markup, Boolean(can) && !this.state.is_read_only);
    if (said === undefined) return;
    this.leaveLine();
    this.said.innerHTML = said;
  }

  /** Close the open line, and don't let the focus go with it. */
  leaveLine() {
    const hadFocus = this.look.element.contains(focusedBeside(this.element));
    this.choose(undefined);
    if (hadFocus) this.openers.find(each => each.name === this.tab)?.focus();
  }

  draw() {
    for (const each of this.openers) each.ariaExpanded = String(each.name === this.tab);
    this.keysOpener.ariaExpanded = String(!this.keys.hidden);
    this.body.hidden = !this.tab;
    this.form.element.hidden = this.tab !== 'presets' || Boolean(this.state.is_read_only);
    this.form.show(this.state);
    const {presets = [], changes = []} = this.state;
    if (this.tab === 'presets') {
      const wanted = presets.map(({name, taken, holds}) => {
        return {key: name, source: {name}, words: [`${minuteOf(taken)}, ${holds}`], button: name};
      });
      this.drawLines(wanted, 'There are no presets yet.');
    } else if (this.tab === 'history') {
      const wanted = changes.map(({time, whose, says}, index) => {
        // What was set together has one moment, and so one way back.
        const isFirst = index === 0 || time !== changes[index - 1].time;
        const button = isFirst && time !== changes[0].time ? 'Back to here' : '';
        const words = [localTime(time).slice(11), whose, says, ...(index ? [] : ['now'])];
        return {key: `${time} ${whose}`, source: {time}, words, button};
      });
      this.drawLines(wanted, 'The nodes are being read\u2026');
    }
  }

  /**
   * Draw the list. Lines that stay are kept, and with them the focus.
   * @param {{key: string, source: Source, words: string[], button: string}[]} wanted The button stands before the words
   *   of a preset, and behind those of a moment, which may have none.
   * @param {string} empty
   */
  drawLines(wanted, empty) {
    const keys = new Set(wanted.map(each => each.key));
    for (const [key, line] of this.lines) {
      if (keys.has(key)) continue;
      line.remove();
      this.lines.delete(key);
    }
    for (const each of all(this.list, '.drawer-empty')) each.remove();
    if (!wanted.length) this.list.append(make('li', {className: 'drawer-empty'}, empty));
    wanted.forEach(({key, source, words, button}, index) => {
      const line = this.lines.get(key) ?? make('li');
      this.lines.set(key, line);
      if (this.list.children[index] !== line) this.list.insertBefore(line, this.list.children[index] ?? null);
      const text = JSON.stringify([words, button]);
      if (line.dataset.text !== text) {
        line.dataset.text = text;
        line.replaceChildren(this.makeLine(source, words, button));
      }
      const isOpen = Boolean(button) && isSame(source, this.source);
      line.querySelector('button')?.setAttribute('aria-expanded', String(isOpen));
      if (isOpen && this.look.element.parentElement !== line) line.append(this.look.element);
    });
  }

  /**
   * @param {Source} source
   * @param {string[]} words
   * @param {string} word
   */
  makeLine(source, words, word) {
    const isPreset = source.name !== undefined;
    const line = make('div', {className: isPreset ? 'drawer-preset' : 'drawer-moment'});
    line.append(...words.map(each => make('span', {}, each)));
    const button = make('button', {type: 'button'}, word);
    button.addEventListener('click', () => this.choose(isSame(source, this.source) ? undefined : source));
    if (isPreset) line.prepend(button);
    else if (word) line.append(button);
    return line;
  }
}

/**
 * @param {Source} source
 * @param {Source | undefined} other
 */
function isSame(source, other) {
  return Boolean(other) && source.name === other?.name && source.time === other?.time;
}

export default {initialize, render};
