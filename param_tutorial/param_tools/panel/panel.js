/* A parameter panel on a page: it shows what the node confirmed, and passes on what a person enters.

   `panel_widget.js` connects it with the kernel. The markup is Python's: `drawing.py`. */

import {all, focusedBeside, make, one} from './dom.js';

/**
 * What a panel shows of a parameter's value; see the class of this name in `drawing.py`.
 * @typedef {{text: string, position?: number, is_locked?: boolean, is_busy?: boolean, message?: string[] | null,
 *   first?: string, is_gathered?: boolean, items?: string[]}} RowState
 *
 * What a panel shows: why nothing can be changed now, which buttons do something, and rows by name.
 * @typedef {{status?: string, rows: Record<string, RowState>, undo?: boolean, redo?: boolean, gathered?: number,
 *   note?: string}} PanelState
 *
 * What a person entered: one of the first three. `number` counts the entries of a row, and `grip` how often the slider
 * was taken hold of.
 * @typedef {{text?: string, position?: number, items?: string[], number: number, grip: number}} Entry
 *
 * What a person does: enters something, or presses a button. Without a name, a button is for all parameters.
 * @typedef {{do: string, name?: string} & Partial<Entry>} Wish
 *
 * @typedef {HTMLElement & {value: string, disabled: boolean}} Box
 */

// What is said until an entry is taken up.
const PATIENCE = 'Waiting for the kernel, which is still running a cell\u2026';

/** The elements of an array, one box for each, below a row's text box. */
class Elements {
  isTyping = false;
  list = make('ol');

  /**
   * @param {PanelRow} row
   * @param {HTMLButtonElement} button
   */
  constructor(row, button) {
    this.row = row;
    this.button = button;
    this.add = this.makeButton('Add', `Add an element to ${row.name}`, () => {
      this.append('');
      this.boxes.at(-1)?.focus();
    });
    this.element = make('div', {className: 'param-elements', hidden: true}, this.list, this.add);
    one(row.element, '.param-line').after(this.element);
    button.hidden = false;
    button.addEventListener('click', () => this.open(Boolean(this.element.hidden)));
    this.element.addEventListener('keydown', event => {
      row.panel.keep(event);
      if (event.key === 'Enter' && event.target instanceof HTMLInputElement) this.commit();
      if (event.key === 'Escape') {
        this.isTyping = false;
        this.open(false);
        button.focus();
      }
    });
  }

  get boxes() {
    return all(this.list, 'input', HTMLInputElement);
  }

  /**
   * @param {string} text
   * @param {string} label
   * @param {() => void} onClick
   */
  makeButton(text, label, onClick) {
    const made = make('button', {type: 'button', ariaLabel: label}, text);
    made.addEventListener('click', onClick);
    return made;
  }

  /** @param {boolean} isWanted */
  open(isWanted) {
    this.element.hidden = !isWanted;
    this.button.ariaExpanded = String(isWanted);
    this.draw();
  }

  /** @param {string} text */
  append(text) {
    const number = this.list.children.length + 1;
    const label = `Element ${number} of ${this.row.name}`;
    const box = make('input', {type: 'text', value: text, autocomplete: 'off', spellcheck: false, ariaLabel: label});
    box.addEventListener('input', () => {
      this.isTyping = true;
    });
    box.addEventListener('change', () => this.commit());
    const remove = this.makeButton('Remove', `Remove element ${number} of ${this.row.name}`, () => {
      item.remove();
      this.isTyping = true;
      this.commit();
      (this.boxes.at(Math.min(number, this.boxes.length) - 1) ?? this.add).focus();
    });
    const item = make('li', {}, make('div', {}, box, remove));
    this.list.append(item);
  }

  commit() {
    if (!this.isTyping) return;
    this.isTyping = false;
    this.row.enter({items: this.boxes.map(each => each.value)});
  }

  /** Show what the node has, unless something else is being typed or on its way. */
  draw() {
    const {items} = this.row.state;
    this.button.hidden = !items;
    if (!items) this.element.hidden = true;
    if (!items || this.element.hidden || this.isTyping || this.row.isAhead) return;
    const focused = this.boxes.indexOf(/** @type {HTMLInputElement} */ (focusedBeside(this.element)));
    this.list.replaceChildren();
    for (const each of items) this.append(each);
    if (focused >= 0 && this.boxes.length) this.boxes[Math.min(focused, this.boxes.length - 1)].focus();
    for (const each of [...this.boxes, ...all(this.element, 'button', HTMLButtonElement)]) {
      each.disabled = this.row.isLocked;
    }
  }
}

/** A parameter's controls. What was entered stands in them until the answer to just that is there. */
class PanelRow {
  entered = 0;
  answered = 0;
  grip = 0;
  isTyping = false;
  /** @type {RowState} */
  state = {text: ''};
  /** @type {string | undefined} */
  drawn;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  timer;
  /** @type {Elements | undefined} */
  elements;

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
    const items = /** @type {HTMLButtonElement | null} */ (element.querySelector('.param-items'));
    if (items) this.elements = new Elements(this, items);
  }

  listen() {
    const {box, slider, panel} = this;
    if (this.editor === 'check') {
      box.addEventListener('change', () => this.enter({text: String(this.isChecked)}));
    } else if (box instanceof HTMLSelectElement) {
      box.addEventListener('change', () => {
        if (box.selectedOptions[0]?.dataset.other === undefined) this.enter({text: box.value});
        else this.typeOther(box);
      });
    } else {
      box.addEventListener('input', () => {
        this.isTyping = true;
      });
      box.addEventListener('blur', () => this.commit());
      box.addEventListener('keydown', event => {
        panel.keep(event);
        if (event.key === 'Enter' && box.tagName === 'INPUT') this.commit();
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
      slider.addEventListener('input', () => this.enter({position: Number(slider.value)}));
    }
    this.back?.addEventListener('click', () => panel.send({do: 'reset', name: this.name}));
  }

  /**
   * Take another text than those of a list, in a box that stands in the list's place until it is left.
   * @param {HTMLSelectElement} list
   */
  typeOther(list) {
    const before = this.state.text;
    const box = make('input', {type: 'text', id: list.id, className: list.className, value: before});
    Object.assign(box, {autocomplete: 'off', spellcheck: false});
    box.setAttribute('aria-describedby', list.getAttribute('aria-describedby') ?? '');
    /** @param {boolean} isWanted */
    const leave = isWanted => {
      if (this.box !== box) return;
      this.box = list;
      this.isTyping = false;
      if (isWanted && box.value !== before) {
        const typed = new Option(box.value);
        typed.dataset.typed = '';
        list.add(typed);
        list.value = box.value;
        this.enter({text: box.value});
      } else {
        this.drawValue();
      }
      const hadFocus = box === focusedBeside(box);
      box.replaceWith(list);
      if (hadFocus) list.focus();
    };
    box.addEventListener('blur', () => leave(true));
    box.addEventListener('keydown', event => {
      this.panel.keep(event);
      if (event.key === 'Enter' || event.key === 'Escape') leave(event.key === 'Enter');
    });
    this.box = box;
    this.isTyping = true;
    list.replaceWith(box);
    box.focus();
    box.select();
  }

  commit() {
    if (!this.isTyping) return;
    this.isTyping = false;
    this.enter({text: this.box.value});
  }

  /**
   * Pass on what was entered; the kernel answers with the number as soon as that has been taken up.
   * @param {Partial<Entry>} entry
   */
  enter(entry) {
    this.entered += 1;
    this.panel.send({do: 'enter', name: this.name, ...entry, number: this.entered, grip: this.grip});
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.drawMessage(), 1000);
  }

  /** @param {number} number */
  answer(number) {
    this.answered = number;
    this.draw();
  }

  /** @param {RowState} state */
  show(state) {
    const text = JSON.stringify([state, this.panel.isLocked]);
    if (text === this.drawn) return;
    this.drawn = text;
    this.state = state;
    this.draw();
  }

  get isAhead() {
    return this.entered !== this.answered || this.state.is_busy;
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
    if (!this.isAhead) this.drawValue();
    this.element.classList.toggle('param-changed', this.state.first !== undefined);
    this.element.classList.toggle('param-is-gathered', Boolean(this.state.is_gathered));
    this.drawBack();
    this.elements?.draw();
    this.drawMessage();
  }

  drawValue() {
    const {box, slider} = this;
    const {text, position} = this.state;
    if (this.editor === 'check') {
      /** @type {HTMLInputElement} */ (box).checked = text === 'true';
    } else if (!this.isTyping) {
      if (box instanceof HTMLSelectElement) for (const typed of all(box, '[data-typed]')) typed.remove();
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
    const isWaiting = this.entered !== this.answered;
    const [kind, words] = isWaiting ? ['waiting', PATIENCE] : (this.state.message ?? ['', '']);
    if (this.said.dataset.said === `${kind} ${words}`) return;
    this.said.dataset.said = `${kind} ${words}`;
    this.said.replaceChildren();
    if (!kind) return;
    // An alert is read out when it comes onto the page.
    const role = kind === 'rejected' || kind === 'failed' ? 'alert' : 'status';
    const told = make('span', {className: `param-message param-${kind}`, role});
    if (kind === 'rejected') told.append(make('b', {}, 'Rejected:'), ' ');
    told.append(words);
    this.said.append(told);
  }
}

/** A node's parameters as controls. */
export class ParameterPanel {
  isLocked = false;
  /** @type {Map<string, PanelRow>} */
  rows = new Map();

  /**
   * @param {HTMLElement} root
   * @param {(wish: Wish) => void} send
   */
  constructor(root, send) {
    this.root = root;
    this.send = send;
    for (const element of all(root, '.param-row')) {
      const row = new PanelRow(this, element);
      this.rows.set(row.name, row);
    }
    this.status = one(root, '.param-status');
    this.search = /** @type {HTMLInputElement | null} */ (root.querySelector('.param-search'));
    this.search?.addEventListener('input', () => this.find());
    this.search?.addEventListener('keydown', event => {
      event.stopPropagation();
      if (event.key === 'Escape') this.find('');
    });
    this.tools = this.findTools();
  }

  /** Return the buttons by which changes are made together, undone and taken back, and the bar of gathered changes. */
  findTools() {
    const {root} = this;
    const bar = one(root, '.param-bar');
    /** @param {string} name */
    const button = name => {
      const found = one(root, `.param-${name}`, HTMLButtonElement);
      found.addEventListener('click', () => this.send({do: name === 'gather' && !bar.hidden ? 'discard' : name}));
      return found;
    };
    root.addEventListener('keydown', event => this.onKey(event));
    return {
      bar,
      gathered: one(bar, '.param-gathered'),
      gather: button('gather'),
      undo: button('undo'),
      redo: button('redo'),
      reset: button('reset'),
      apply: button('apply'),
      discard: button('discard'),
    };
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
    const isUndo = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === 'z';
    // In a text that is being typed these keys are the browser's.
    if (!isUndo || [...this.rows.values()].some(row => row.isTyping || row.elements?.isTyping)) return;
    event.preventDefault();
    this.send({do: event.shiftKey ? 'redo' : 'undo'});
  }

  /** @param {PanelState} state */
  show(state) {
    const {status} = state;
    this.isLocked = Boolean(status);
    this.status.textContent = status || (this.status.dataset.count ?? '');
    this.status.classList.toggle('param-status-bad', Boolean(status));
    for (const [name, row] of this.rows) if (state.rows[name]) row.show(state.rows[name]);
    this.showTools(state);
  }

  /** @param {PanelState} state */
  showTools({gathered, note = '', undo, redo}) {
    const {tools} = this;
    const isGathering = gathered !== undefined;
    tools.gather.disabled = this.isLocked;
    tools.gather.ariaPressed = String(isGathering);
    tools.bar.hidden = !isGathering;
    tools.apply.disabled = this.isLocked || !gathered;
    tools.gathered.textContent = note;
    tools.undo.disabled = this.isLocked || !undo;
    tools.redo.disabled = this.isLocked || !redo;
    tools.reset.disabled = this.isLocked || ![...this.rows.values()].some(row => 'first' in row.state);
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
   * Take over from a panel in whose place this one stands: what was folded, searched and being typed.
   * @param {ParameterPanel} old
   */
  takeOver(old) {
    /** @type {(panel: ParameterPanel) => [string | null, HTMLDetailsElement][]} */
    const groups = panel =>
      all(panel.root, '.param-group', HTMLDetailsElement).map(each => [one(each, 'summary').textContent, each]);
    const before = new Map(groups(old));
    for (const [title, group] of groups(this)) group.open = before.get(title)?.open ?? group.open;
    if (old.search && this.search) this.search.value = old.search.value;
    for (const [name, row] of old.rows) {
      const heir = this.rows.get(name);
      if (!heir) continue;
      heir.state = row.state;
      if (row.elements?.element.hidden === false) heir.elements?.open(true);
      heir.entered = row.entered;
      heir.answered = row.answered;
      heir.grip = row.grip;
      if (row.isTyping && heir.box.tagName === row.box.tagName) {
        heir.isTyping = true;
        heir.box.value = row.box.value;
      }
    }
  }
}
