/* The form below a panel's head: write a parameter file, or load one after a look at what that would change.

   The kernel reads and writes the files, and says what to show: `file_form.py`. */

class FileForm {
  /** `id` is one that nothing else on the page has.
      `ask` takes what the kernel is to do: {do: 'look' or 'act', is_save, path, changed_only, number}. */
  constructor(id, ask) {
    Object.assign(this, {ask, number: 0, isActing: false, isSave: false, can: false, hasLook: false, buttons: {}});
    this.element = document.createElement('form');
    this.element.className = 'param-file';
    this.element.hidden = true;
    this.element.innerHTML = `<div class="param-file-line"><label for="${id}">File</label>
      <input type="text" id="${id}" list="${id}-offered" autocomplete="off" spellcheck="false"
        aria-describedby="${id}-look"><datalist id="${id}-offered"></datalist>
      <label class="param-file-changed"><input type="checkbox"> only what has changed</label>
      <button type="submit" class="param-file-do" disabled></button>
      <button type="button" class="param-file-close">Close</button></div>
      <div class="param-file-look" id="${id}-look" role="status"></div>`;
    this.path = this.element.querySelector('input');
    this.changedOnly = this.element.querySelector('[type="checkbox"]');
    this.button = this.element.querySelector('.param-file-do');
    this.shown = this.element.querySelector('.param-file-look');
    this.path.addEventListener('input', () => this.lookSoon());
    this.changedOnly.addEventListener('change', () => this.look());
    this.element.querySelector('.param-file-close').addEventListener('click', () => this.close());
    this.element.addEventListener('submit', event => { event.preventDefault(); this.act(); });
    this.element.addEventListener('keydown', event => {
      // JupyterLab has meanings of its own for keys.
      event.stopPropagation();
      if (event.key === 'Escape') this.close();
    });
  }

  /** Stand below the head of a panel, whose buttons open it. */
  settle(root) {
    root.querySelector('.param-head').after(this.element);
    this.buttons = {true: root.querySelector('.param-save'), false: root.querySelector('.param-load')};
    for (const isSave of [true, false]) {
      this.buttons[isSave].addEventListener('click', () => {
        if (!this.element.hidden && this.isSave === isSave) this.close(); else this.open(isSave);
      });
    }
    this.draw();
  }

  draw() {
    for (const isSave of [true, false]) {
      this.buttons[isSave].setAttribute('aria-expanded', String(!this.element.hidden && this.isSave === isSave));
    }
    this.button.disabled = !this.can || this.isActing || (!this.isSave && this.isLocked);
  }

  /** Take note that the panel shows something new, and whether the node can be changed: only loading needs that. */
  update(isLocked) {
    this.isLocked = isLocked;
    this.draw();
    if (this.hasLook && !this.element.hidden) {
      clearTimeout(this.timer);
      this.timer = setTimeout(() => this.look(), 300);
    }
  }

  open(isSave) {
    Object.assign(this, {isSave, can: false});
    this.element.hidden = false;
    this.element.querySelector('.param-file-changed').hidden = !isSave;
    this.button.textContent = isSave ? 'Save' : 'Load';
    this.shown.replaceChildren();
    this.look();
    this.path.focus();
  }

  close() {
    this.element.hidden = true;
    this.draw();
    this.buttons[this.isSave].focus();
  }

  send(action) {
    this.number += 1;
    this.ask({do: action, is_save: this.isSave, path: this.path.value, changed_only: this.changedOnly.checked,
      number: this.number});
  }

  lookSoon() {
    // What is typed now is another file than the one that was looked at.
    this.can = false;
    this.draw();
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.look(), 200);
  }

  look() {
    clearTimeout(this.timer);
    this.send('look');
  }

  act() {
    if (this.button.disabled) return;
    clearTimeout(this.timer);
    // What changes from here on is what was asked for.
    Object.assign(this, {isActing: true, hasLook: false});
    this.send('act');
    this.draw();
  }

  /** Show the kernel's answer, unless something newer has been asked. */
  answer({form, offered, markup, button, can, said}) {
    if (form !== this.number) return;
    this.hasLook = said === undefined;
    if (!this.hasLook) {
      Object.assign(this, {isActing: false, can: false});
      this.shown.innerHTML = said;
      this.markup = said;
    } else {
      this.element.querySelector('datalist').replaceChildren(...offered.map(each => new Option('', each)));
      if (this.markup !== markup || !this.shown.firstChild) this.shown.innerHTML = markup;
      this.markup = markup;
      this.button.textContent = button;
      this.can = can;
    }
    this.draw();
  }
}

