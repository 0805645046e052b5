/* A parameter panel on a page: it shows what the node confirmed, and passes on what a person enters.

   The same in JupyterLab, where a kernel answers (see `render` at the end), and on a page of the website, where a
   recording answers (see `lesson.js`). The markup is Python's: `pictures/panel.py`. */

/** The elements of an array, one box for each, below a row's text box. */
class Elements {
  constructor(row, button) {
    Object.assign(this, {row, button, isTyping: false});
    this.element = document.createElement('div');
    this.element.className = 'param-elements';
    this.element.hidden = true;
    this.list = document.createElement('ol');
    this.add = this.makeButton('Add', `Add an element to ${row.name}`, () => {
      this.append('');
      this.boxes.at(-1).focus();
    });
    this.element.append(this.list, this.add);
    row.element.querySelector('.param-line').after(this.element);
    button.hidden = false;
    button.addEventListener('click', () => this.open(this.element.hidden));
    this.element.addEventListener('keydown', event => {
      row.panel.keep(event);
      if (event.key === 'Enter' && event.target.tagName === 'INPUT') this.commit();
      if (event.key === 'Escape') { this.isTyping = false; this.open(false); button.focus(); }
    });
  }

  get boxes() {
    return [...this.list.querySelectorAll('input')];
  }

  makeButton(text, label, onClick) {
    const made = document.createElement('button');
    made.type = 'button';
    made.textContent = text;
    made.setAttribute('aria-label', label);
    made.addEventListener('click', onClick);
    return made;
  }

  open(isWanted) {
    this.element.hidden = !isWanted;
    this.button.setAttribute('aria-expanded', String(isWanted));
    this.draw();
  }

  append(text) {
    const item = document.createElement('li');
    const line = document.createElement('div');
    const box = document.createElement('input');
    const number = this.list.children.length + 1;
    Object.assign(box, {type: 'text', value: text, autocomplete: 'off', spellcheck: false});
    box.setAttribute('aria-label', `Element ${number} of ${this.row.name}`);
    box.addEventListener('input', () => { this.isTyping = true; });
    box.addEventListener('change', () => this.commit());
    line.append(box, this.makeButton('Remove', `Remove element ${number} of ${this.row.name}`, () => {
      item.remove();
      this.isTyping = true;
      this.commit();
      (this.boxes.at(Math.min(number, this.boxes.length) - 1) || this.add).focus();
    }));
    item.append(line);
    this.list.append(item);
  }

  commit() {
    if (!this.isTyping) return;
    this.isTyping = false;
    this.row.enter('items', this.boxes.map(each => each.value));
  }

  /** Show what the node has, unless something else is being typed or on its way. */
  draw() {
    const items = this.row.state.items;
    this.button.hidden = !items;
    if (!items) this.element.hidden = true;
    if (this.element.hidden || this.isTyping || this.row.isAhead) return;
    const focused = this.boxes.indexOf(this.element.getRootNode().activeElement);
    this.list.replaceChildren();
    for (const each of items) this.append(each);
    if (focused >= 0 && this.boxes.length) this.boxes[Math.min(focused, this.boxes.length - 1)].focus();
    const isLocked = this.row.state.is_locked || this.row.panel.isLocked;
    for (const each of this.element.querySelectorAll('input, button')) each.disabled = isLocked;
  }
}

/** A parameter's controls. What was entered stands in them until the answer to just that is there. */
class PanelRow {
  constructor(panel, element) {
    Object.assign(this, {panel, element, name: element.dataset.name, state: {}, entered: 0, answered: 0, grip: 0});
    this.box = element.querySelector('.param-box');
    this.slider = element.querySelector('.param-slider');
    this.back = element.querySelector('.param-back');
    this.said = element.lastElementChild;
    this.isTyping = false;
    if (element.dataset.editor === 'check') {
      this.box.addEventListener('change', () => this.enter('text', String(this.box.checked)));
    } else if (element.dataset.editor === 'choice') {
      this.box.addEventListener('change', () => this.enter('text', this.box.value));
    } else {
      this.box.addEventListener('input', () => { this.isTyping = true; });
      this.box.addEventListener('blur', () => this.commit());
      this.box.addEventListener('keydown', event => {
        panel.keep(event);
        if (event.key === 'Enter' && this.box.tagName === 'INPUT') this.commit();
        if (event.key === 'Escape') { this.isTyping = false; this.draw(); }
      });
    }
    if (this.slider) {
      for (const kind of ['pointerdown', 'keydown', 'focus']) {
        this.slider.addEventListener(kind, () => { this.grip += 1; });
      }
      this.slider.addEventListener('keydown', event => panel.keep(event));
      this.slider.addEventListener('input', () => this.enter('position', Number(this.slider.value)));
    }
    const items = element.querySelector('.param-items');
    if (items) this.elements = new Elements(this, items);
    if (this.back) this.back.addEventListener('click', () => panel.wire.bringBack(this.name));
  }

  commit() {
    if (!this.isTyping) return;
    this.isTyping = false;
    this.enter('text', this.box.value);
  }

  /** Pass on what was entered; the wire calls `answer` with the number as soon as that has been taken up. */
  enter(kind, entry) {
    this.entered += 1;
    this.panel.wire.enter(this.name, {[kind]: entry, number: this.entered, grip: this.grip});
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.drawMessage(), 1000);
  }

  answer(number) {
    this.answered = number;
    this.draw();
  }

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

  draw() {
    const {text, position = null, first = null} = this.state;
    const isLocked = this.state.is_locked || this.panel.isLocked;
    this.box.disabled = isLocked;
    if (this.slider) this.slider.disabled = isLocked;
    if (!this.isAhead) {
      if (this.element.dataset.editor === 'check') {
        this.box.checked = text === 'true';
      } else if (!this.isTyping) {
        if (this.box.tagName === 'SELECT' && ![...this.box.options].some(each => each.value === text)) {
          this.box.add(new Option(text));
        }
        this.box.value = text;
      }
      if (this.slider && position !== null) this.slider.value = position;
      if (this.slider) this.slider.setAttribute('aria-valuetext', text);
    }
    const isChanged = first !== null;
    this.element.classList.toggle('param-changed', isChanged);
    this.element.classList.toggle('param-is-gathered', Boolean(this.state.is_gathered));
    if (this.back) {
      // A button that goes while it has the focus takes the focus with it.
      if (this.back === this.back.getRootNode().activeElement && !isChanged) this.box.focus();
      this.back.hidden = !isChanged;
      this.back.disabled = isLocked;
      const words = `Back to ${first === '' ? 'an empty value' : first}`;
      if (isChanged && this.back.title !== words) {
        this.back.textContent = `\u21ba ${first}`;
        this.back.title = words;
        this.back.setAttribute('aria-label', `${words}: ${this.name}`);
      }
    }
    if (this.elements) this.elements.draw();
    this.drawMessage();
  }

  drawMessage() {
    let message = this.state.message;
    if (this.entered !== this.answered) {
      message = ['waiting', this.panel.wire.patience];
    }
    const [kind, words] = message || ['', ''];
    if (this.said.dataset.said === `${kind} ${words}`) return;
    this.said.dataset.said = `${kind} ${words}`;
    this.said.replaceChildren();
    if (!kind) return;
    const told = document.createElement('span');
    told.className = `param-message param-${kind}`;
    // An alert is read out when it comes onto the page.
    told.setAttribute('role', kind === 'rejected' || kind === 'failed' ? 'alert' : 'status');
    const word = {rejected: 'Rejected:', accepted: 'Accepted.', unknown: 'Not recorded:'}[kind];
    if (word) {
      const strong = document.createElement('b');
      strong.textContent = word;
      told.append(strong, ' ');
    }
    told.append(words);
    this.said.append(told);
  }
}

/** A node's parameters as controls.

    `wire` takes what is entered: `enter(name, entry)`, `bringBack(name)` with null for all, and what the buttons do:
    `undo()`, `redo()`, `gather(isWanted)`, `apply()`;
    `patience` is what to say while it does not even take it up. */
class ParameterPanel {
  constructor(root, wire) {
    Object.assign(this, {root, wire, isLocked: false});
    this.rows = new Map();
    for (const element of root.querySelectorAll('.param-row')) {
      this.rows.set(element.dataset.name, new PanelRow(this, element));
    }
    this.status = root.querySelector('.param-status');
    this.search = root.querySelector('.param-search');
    this.bar = root.querySelector('.param-bar');
    this.buttons = Object.fromEntries(['gather', 'undo', 'redo', 'reset', 'apply', 'discard'].map(each => [each, root.querySelector(`.param-${each}`)]));
    if (this.search) {
      this.search.addEventListener('input', () => this.find());
      this.search.addEventListener('keydown', event => {
        event.stopPropagation();
        if (event.key === 'Escape') { this.search.value = ''; this.find(); }
      });
    }
    if (this.buttons.undo) {
      this.buttons.undo.addEventListener('click', () => wire.undo());
      this.buttons.redo.addEventListener('click', () => wire.redo());
      this.buttons.reset.addEventListener('click', () => wire.bringBack(null));
      this.buttons.gather.addEventListener('click', () => wire.gather(this.bar.hidden));
      this.buttons.apply.addEventListener('click', () => wire.apply());
      this.buttons.discard.addEventListener('click', () => wire.gather(false));
      root.addEventListener('keydown', event => this.onKey(event));
    }
  }

  /** Keep a key in the panel: JupyterLab has meanings of its own for keys. */
  keep(event) {
    event.stopPropagation();
    if (this.buttons.undo) this.onKey(event);
  }

  onKey(event) {
    const isUndo = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === 'z';
    // In a text that is being typed these keys are the browser's.
    if (!isUndo || [...this.rows.values()].some(row => row.isTyping || row.elements?.isTyping)) return;
    event.preventDefault();
    if (event.shiftKey) this.wire.redo(); else this.wire.undo();
  }

  /** Show what is known: a status, which buttons do something, and rows by name, of which each has at least a text. */
  show(state) {
    this.isLocked = Boolean(state.status);
    this.status.textContent = state.status || this.status.dataset.count;
    this.status.classList.toggle('param-status-bad', this.isLocked);
    for (const [name, row] of this.rows) if (state.rows[name]) row.show(state.rows[name]);
    if (this.buttons.undo) {
      const isGathering = 'gathered' in state;
      this.buttons.gather.disabled = this.isLocked;
      this.buttons.gather.setAttribute('aria-pressed', String(isGathering));
      this.bar.hidden = !isGathering;
      this.buttons.apply.disabled = this.isLocked || !(state.gathered > 0);
      this.bar.querySelector('.param-gathered').textContent = isGathering ? state.note : '';
      this.buttons.undo.disabled = this.isLocked || !state.undo;
      this.buttons.redo.disabled = this.isLocked || !state.redo;
      this.buttons.reset.disabled = this.isLocked || ![...this.rows.values()].some(row => 'first' in row.state);
    }
  }

  answer(name, number) {
    const row = this.rows.get(name);
    if (row) row.answer(number);
  }

  /** Show only rows in which all words of the search stand: in the name, the description or the value. */
  find() {
    const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    let count = 0;
    for (const row of this.rows.values()) {
      const text = `${row.name} ${row.element.querySelector('.param-help').textContent} ${row.state.text}`.toLowerCase();
      const fits = words.every(word => text.includes(word));
      row.element.hidden = !fits;
      count += fits;
    }
    const groups = [...this.root.querySelectorAll('.param-group')];
    for (const group of groups.reverse()) {
      group.hidden = ![...group.querySelectorAll('.param-row')].some(row => !row.hidden);
      if (words.length && !group.hidden) group.open = true;
    }
    this.root.querySelector('.param-found').textContent = words.length ? `${count} of ${this.rows.size} found` : '';
  }

  /** Take over from a panel in whose place this one stands: what was folded, searched and being typed. */
  takeOver(old) {
    const titles = group => group.querySelector('summary').textContent;
    const folded = new Map([...old.root.querySelectorAll('.param-group')].map(each => [titles(each), each.open]));
    for (const group of this.root.querySelectorAll('.param-group')) {
      if (folded.has(titles(group))) group.open = folded.get(titles(group));
    }
    if (old.search && this.search) this.search.value = old.search.value;
    for (const [name, row] of old.rows) {
      const heir = this.rows.get(name);
      if (!heir) continue;
      if (row.elements && heir.elements && !row.elements.element.hidden) heir.elements.open(true);
      Object.assign(heir, {entered: row.entered, answered: row.answered, grip: row.grip});
      if (row.isTyping && heir.box.tagName === row.box.tagName) {
        heir.isTyping = true;
        heir.box.value = row.box.value;
      }
    }
  }
}

/** In JupyterLab: the kernel holds the state, and takes what is entered. */
function render({model, el}) {
  // Every panel has this script for itself, so that counting would give all the same number.
  const client = Math.random().toString(36).slice(2);
  const wire = {
    patience: 'Waiting for the kernel, which is still running a cell\u2026',
    enter: (name, entry) => model.send({do: 'enter', name, client, ...entry}),
    bringBack: name => model.send({do: 'reset', name}),
    undo: () => model.send({do: 'undo'}),
    redo: () => model.send({do: 'redo'}),
    gather: isWanted => model.send({do: isWanted ? 'gather' : 'discard'}),
    apply: () => model.send({do: 'apply'}),
  };
  const root = document.createElement('div');
  el.append(root);
  const form = new FileForm(`param-file-${client}`, wish => model.send({client, ...wish}));
  let panel, search = model.get('search');

  function build() {
    // A panel that does not wait for its node is there before there is anything to show.
    if (!model.get('markup')) return;
    const focused = root.contains(root.getRootNode().activeElement) ? root.getRootNode().activeElement : null;
    const old = panel;
    const shown = document.createElement('div');
    shown.innerHTML = model.get('markup').replaceAll('id="panel-', `id="panel-${client}-`)
      .replaceAll('for="panel-', `for="panel-${client}-`)
      .replace(/aria-describedby="panel-(\d+)-help panel-(\d+)-said"/g,
        `aria-describedby="panel-${client}-$1-help panel-${client}-$2-said"`);
    panel = new ParameterPanel(shown, wire);
    if (old) panel.takeOver(old);
    // At first there may be too few parameters for a search.
    if (panel.search && search) [panel.search.value, search] = [search, ''];
    form.settle(shown);
    root.replaceChildren(shown);
    show();
    if (panel.search) panel.find();
    if (form.element.contains(focused)) {
      focused.focus();
    } else if (focused) {
      const row = focused.closest('.param-row');
      const heir = row && panel.rows.get(row.dataset.name);
      const target = heir ? heir.element.querySelector(`.${focused.className}`) : shown.querySelector(`.${focused.className}`);
      if (target) target.focus();
      if (heir && heir.isTyping && target === heir.box) {
        target.setSelectionRange(focused.selectionStart, focused.selectionEnd);
      }
    }
  }

  function show() {
    if (!panel) return;
    panel.show(model.get('state'));
    form.update(panel.isLocked);
  }

  function onMessage(message) {
    if (!panel || message.client !== client) return;
    if ('form' in message) form.answer(message); else panel.answer(message.name, message.number);
  }

  build();
  model.on('change:markup', build);
  model.on('change:state', show);
  model.on('msg:custom', onMessage);
  return () => {
    model.off('change:markup', build);
    model.off('change:state', show);
    model.off('msg:custom', onMessage);
  };
}

export default {initialize, render};
