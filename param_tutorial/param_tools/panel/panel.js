/* A parameter panel on a page: it shows what the node confirmed, and passes on what a person enters.

   The kernel holds the state: `panel.py`. The markup is Python's, too: `drawing.py`. */

import {all, focusedBeside, make, one, uniqueName} from './dom.js';
import {initialize} from './front.js';

/**
 * @import {RenderProps} from '@anywidget/types'
 *
 * What a panel shows of a parameter's value; see the class of this name in `control.py`.
 * @typedef {{text: string, position?: number, is_locked?: boolean, is_busy?: boolean, message?: string[] | null,
 *   is_changed?: boolean, first?: string}} RowState
 *
 * What a panel shows: why nothing can be changed now, whether there is something to undo, what has changed as a parameter
 * file and as commands, and rows by name; and of each script that shows it, the number of the last entry that the kernel
 * has passed on to the node.
 * @typedef {{status: string, undo: boolean, copies: string[], rows: Record<string, RowState>,
 *   passed_on: Record<string, number>}} PanelState
 *
 * What a person entered: a text or a slider's position. `grip` counts how often the slider was taken hold of.
 * @typedef {{text?: string, position?: number, grip: number}} Entry
 *
 * @typedef {HTMLElement & {value: string, disabled: boolean}} Box
 */

// What is said until an entry is passed on.
const PATIENCE = 'Waiting for the kernel, which is still running a cell\u2026';

/** A parameter's controls. What was entered stands in them until the answer to just that is there. */
class PanelRow {
  // The number of the last entry.
  entered = 0;
  grip = 0;
  isTyping = false;
  /** Where the slider stood when it was taken hold of with Shift. @type {number | undefined} */
  anchor;
  /** @type {RowState} */
  state = {text: ''};
  /** @type {string | undefined} */
  drawn;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  timer;

  /**
   * @param {ParameterPanel} panel
   * @param {HTMLElement} element
   */
  constructor(panel, element) {
    this.panel = panel;
    this.element = element;
    this.name = element.dataset.name ?? '';
    this.editor = element.dataset.editor;
    this.box = /** @type {Box} */ (one(element, '.param-box'));
    this.slider = /** @type {HTMLInputElement | null} */ (element.querySelector('.param-slider'));
    this.back = /** @type {HTMLButtonElement | null} */ (element.querySelector('.param-back'));
    this.said = one(element, '[data-role=said]');
    this.listen();
  }

  listen() {
    const {box, slider, panel} = this;
    if (this.editor === 'check') {
      box.addEventListener('change', () => this.enter({text: String(this.isChecked)}));
    } else {
      box.addEventListener('input', () => {
        this.isTyping = true;
      });
      box.addEventListener('blur', () => this.commit());
      box.addEventListener('keydown', event => {
        panel.keep(event);
        if (event.key === 'Enter' && this.editor === 'text') this.commit();
        if (event.key === 'Escape') {
          this.isTyping = false;
          this.draw();
        }
      });
    }
    if (slider) {
      for (const kind of ['pointerdown', 'keydown', 'focus']) {
        slider.addEventListener(kind, () => {
          this.grip += 1;
        });
      }
      slider.addEventListener('keydown', event => panel.keep(event));
      for (const kind of /** @type {const} */ (['pointerdown', 'keydown', 'keyup'])) {
        slider.addEventListener(kind, event => {
          slider.step = (event.shiftKey && slider.dataset.fine) || '1';
          this.anchor = kind === 'pointerdown' && event.shiftKey ? Number(slider.value) : undefined;
        });
      }
      slider.addEventListener('input', () => {
        // Held with Shift, it follows the mouse at a tenth of its speed.
        if (this.anchor !== undefined) slider.value = String(this.anchor + (Number(slider.value) - this.anchor) / 10);
        this.enter({position: Number(slider.value)});
      });
    }
    this.back?.addEventListener('click', () => panel.send({do: 'reset', name: this.name}));
  }

  commit() {
    if (!this.isTyping) return;
    this.isTyping = false;
    this.enter({text: this.box.value});
  }

  /**
   * Pass on what was entered. The state names the number of the entry when that has been passed on to the node.
   * @param {Partial<Entry>} entry
   */
  enter(entry) {
    this.entered = this.panel.nextNumber();
    this.panel.send({do: 'enter', name: this.name, ...entry, number: this.entered, grip: this.grip});
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.drawMessage(), 1000);
  }

  /** @param {RowState} state */
  show(state) {
    const text = JSON.stringify([state, this.panel.isLocked, this.isWaiting]);
    if (text === this.drawn) return;
    this.drawn = text;
    this.state = state;
    this.draw();
  }

  /** True if the kernel has not passed on the last entry. */
  get isWaiting() {
    return this.entered > this.panel.passedOn;
  }

  get isLocked() {
    return this.state.is_locked || this.panel.isLocked;
  }

  get isChecked() {
    return /** @type {HTMLInputElement} */ (this.box).checked;
  }

  draw() {
    this.box.disabled = this.isLocked;
    if (this.slider) this.slider.disabled = this.isLocked;
    if (!this.isWaiting && !this.state.is_busy) this.drawValue();
    this.element.classList.toggle('param-changed', this.state.is_changed === true);
    this.drawBack();
    this.drawMessage();
  }

  drawValue() {
    const {box, slider} = this;
    const {text, position} = this.state;
    if (this.editor === 'check') {
      /** @type {HTMLInputElement} */ (box).checked = text === 'true';
    } else if (!this.isTyping) {
      if (box instanceof HTMLSelectElement && ![...box.options].some(each => each.value === text)) {
        box.add(new Option(text));
      }
      box.value = text;
    }
    if (slider && position !== undefined) slider.value = String(position);
    if (slider) slider.ariaValueText = text;
  }

  drawBack() {
    const {back} = this;
    const {first} = this.state;
    if (!back) return;
    // A button that goes while it has the focus takes the focus with it.
    if (back === focusedBeside(back) && first === undefined) this.box.focus();
    back.hidden = first === undefined;
    back.disabled = this.isLocked;
    const words = `Back to ${first === '' ? 'an empty value' : first}`;
    if (first !== undefined && back.title !== words) {
      back.textContent = `\u21ba ${first}`;
      back.title = words;
      back.ariaLabel = `${words}: ${this.name}`;
    }
  }

  drawMessage() {
    const [kind, words] = this.isWaiting ? ['waiting', PATIENCE] : (this.state.message ?? ['', '']);
    if (this.said.dataset.said === `${kind} ${words}`) return;
    this.said.dataset.said = `${kind} ${words}`;
    this.said.replaceChildren();
    if (!kind) return;
    // An alert is read out when it comes onto the page.
    const role = kind === 'rejected' || kind === 'failed' ? 'alert' : 'status';
    const message = make('span', {className: `param-message param-${kind}`, role});
    if (kind === 'rejected') message.append(make('b', {}, 'Rejected:'), ' ');
    message.append(words);
    this.said.append(message);
  }
}

/** A node's parameters as controls. */
class ParameterPanel {
  isLocked = false;
  sent = 0;
  passedOn = 0;
  /** @type {Map<string, PanelRow>} */
  rows = new Map();

  /**
   * @param {HTMLElement} root
   * @param {(wish: Record<string, unknown>) => void} send
   */
  constructor(root, send) {
    this.root = root;
    this.send = send;
    for (const element of all(root, '.param-row')) {
      const row = new PanelRow(this, element);
      this.rows.set(row.name, row);
    }
    this.status = one(root, '.param-status');
    this.undo = /** @type {HTMLButtonElement | null} */ (root.querySelector('.param-undo'));
    this.reset = one(root, '.param-reset', HTMLButtonElement);
    this.undo?.addEventListener('click', () => send({do: 'undo'}));
    this.reset.addEventListener('click', () => send({do: 'reset'}));
    this.copy = /** @type {HTMLButtonElement | null} */ (root.querySelector('.param-copy'));
    this.copies = all(root, '.param-copies textarea', HTMLTextAreaElement);
    for (const text of this.copies) {
      text.addEventListener('keydown', event => this.keep(event));
      const button = /** @type {HTMLButtonElement} */ (text.nextElementSibling);
      button.addEventListener('click', () => {
        text.select();
        // The clipboard's own interface is missing on a page that came over plain HTTP from another machine.
        const isCopied = document.execCommand('copy');
        if (isCopied) button.focus();
        button.textContent = isCopied ? 'Copied' : 'Press Ctrl+C';
      });
    }
    root.addEventListener('keydown', event => this.onKey(event));
    this.search = /** @type {HTMLInputElement | null} */ (root.querySelector('.param-search'));
    this.search?.addEventListener('input', () => this.find());
    this.search?.addEventListener('keydown', event => {
      event.stopPropagation();
      if (event.key === 'Escape') this.find('');
    });
  }

  nextNumber() {
    this.sent += 1;
    return this.sent;
  }

  /**
   * Keep a key in the panel: JupyterLab has meanings of its own for keys.
   * @param {KeyboardEvent} event
   */
  keep(event) {
    event.stopPropagation();
    this.onKey(event);
  }

  /** @param {KeyboardEvent} event */
  onKey(event) {
    const isUndo = (event.ctrlKey || event.metaKey) && !event.shiftKey && event.key.toLowerCase() === 'z';
    // In a text that is being typed these keys are the browser's.
    if (!isUndo || [...this.rows.values()].some(row => row.isTyping)) return;
    event.preventDefault();
    this.send({do: 'undo'});
  }

  /**
   * @param {PanelState} state
   * @param {string} client Names this script in the state.
   */
  show({status, undo, copies, rows, passed_on: passedOn}, client) {
    const focused = focusedBeside(this.root);
    this.isLocked = Boolean(status);
    this.passedOn = passedOn[client] ?? 0;
    this.status.textContent = status || (this.status.dataset.count ?? '');
    this.status.classList.toggle('param-status-bad', this.isLocked);
    for (const [name, row] of this.rows) if (rows[name]) row.show(rows[name]);
    if (this.undo) this.undo.disabled = this.isLocked || !undo;
    this.reset.disabled = this.isLocked || !copies.length;
    if (this.copy) this.copy.disabled = !copies.length;
    for (const [index, text] of this.copies.entries()) text.value = copies[index] ?? '';
    // What is disabled would lose the focus to the page, where Ctrl+Z undoes nothing.
    if (this.root.contains(focused) && focused?.matches(':disabled')) Object.assign(this.root, {tabIndex: -1}).focus();
  }

  /**
   * Show only rows in which all words of the search stand: in the name, the description or the value.
   * @param {string} [sought] Put into the search field first.
   */
  find(sought) {
    if (!this.search) return;
    if (sought !== undefined) this.search.value = sought;
    const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    let count = 0;
    for (const row of this.rows.values()) {
      const text = `${row.name} ${one(row.element, '.param-help').textContent} ${row.state.text}`.toLowerCase();
      row.element.hidden = !words.every(word => text.includes(word));
      if (!row.element.hidden) count += 1;
    }
    for (const group of all(this.root, '.param-group', HTMLDetailsElement)) {
      group.hidden = all(group, '.param-row').every(row => row.hidden);
      if (words.length && !group.hidden) group.open = true;
    }
    one(this.root, '.param-found').textContent = words.length ? `${count} of ${this.rows.size} found` : '';
  }

  /**
   * Take over from a panel in whose place this one stands: what was entered, searched and being typed.
   * @param {ParameterPanel} old
   */
  takeOver(old) {
    this.sent = old.sent;
    if (old.search && this.search) this.search.value = old.search.value;
    for (const [name, row] of old.rows) {
      const heir = this.rows.get(name);
      if (!heir) continue;
      heir.state = row.state;
      heir.entered = row.entered;
      heir.grip = row.grip;
      if (row.isTyping && heir.box.tagName === row.box.tagName) {
        heir.isTyping = true;
        heir.box.value = row.box.value;
      }
    }
  }

  /**
   * Give the focus to what stands in the place of an element that had it.
   * @param {HTMLElement} focused
   */
  focusHeir(focused) {
    if (!focused.className) return;
    const name = /** @type {HTMLElement | null} */ (focused.closest('.param-row'))?.dataset.name;
    const row = this.rows.get(name ?? '');
    const heir = (row?.element ?? this.root).querySelector(`.${focused.className}`);
    if (heir instanceof HTMLElement) heir.focus();
    if (!row?.isTyping || heir !== row.box) return;
    const {selectionStart, selectionEnd} = /** @type {HTMLInputElement} */ (focused);
    /** @type {HTMLInputElement} */ (heir).setSelectionRange(selectionStart, selectionEnd);
  }
}

/** @param {RenderProps<{markup: string, state: PanelState, search: string}>} props */
function render({model, el}) {
  const client = uniqueName();
  const root = make('div');
  el.append(root);
  /** @type {ParameterPanel | undefined} */
  let panel;
  let search = model.get('search');

  function build() {
    // A panel that does not wait for its node is there before there is anything to show.
    if (!model.get('markup')) return;
    const focused = /** @type {HTMLElement | null} */ (focusedBeside(root));
    // A notebook may show a panel twice.
    const shown = make('div', {innerHTML: model.get('markup').replaceAll('panel-NAME', `panel-${client}`)});
    const old = panel;
    panel = new ParameterPanel(shown, wish => model.send({client, ...wish}));
    if (old) panel.takeOver(old);
    // At first there may be too few parameters for a search.
    if (panel.search && search) [panel.search.value, search] = [search, ''];
    root.replaceChildren(shown);
    panel.show(model.get('state'), client);
    panel.find();
    if (focused && old?.root.contains(focused)) panel.focusHeir(focused);
  }

  build();
  model.on('change:markup', build);
  model.on('change:state', () => panel?.show(model.get('state'), client));
}

export default {initialize, render};
