/* The form below a panel's head: write a parameter file, or load one after a look at what that would change.

   The kernel reads and writes the files, and says what to show: `file_form.py`. */

import {make, one} from './dom.js';

/**
 * What the kernel is to do. `number` counts the wishes.
 * @typedef {{do: 'look' | 'act', is_save: boolean, path: string, changed_only: boolean, number: number}} Wish
 *
 * The answer to the wish whose number is `form`: what was done, as HTML; or which files there are, what would be done, as
 * HTML, the word on the button, and whether it can be done.
 * @typedef {{form: number, said?: string, offered: string[], suggested: string, markup: string, button: string, can: boolean}} Answer
 */

export class FileForm {
  number = 0;
  isActing = false;
  isSave = false;
  isLocked = false;
  /** Whether what was looked at can be done. */
  can = false;
  hasLook = false;
  /** Whether a name has been suggested or typed. */
  isNamed = false;
  markup = '';
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  timer;
  /** The panel's buttons. @type {{save: HTMLButtonElement, load: HTMLButtonElement} | undefined} */
  openers;

  /**
   * @param {string} id One that nothing else on the page has.
   * @param {(wish: Wish) => void} ask
   */
  constructor(id, ask) {
    this.ask = ask;
    this.element = make('form', {
      className: 'param-file',
      hidden: true,
      innerHTML: `<div class="param-file-line"><label for="${id}">File</label>
        <input type="text" id="${id}" list="${id}-offered" autocomplete="off" spellcheck="false"
          aria-describedby="${id}-look"><datalist id="${id}-offered"></datalist>
        <label class="param-file-changed"><input type="checkbox"> only what has changed</label>
        <button type="submit" class="param-file-do" disabled></button>
        <button type="button" class="param-file-close">Close</button></div>
        <div class="param-file-look" id="${id}-look" role="status"></div>`,
    });
    this.path = one(this.element, '[type=text]', HTMLInputElement);
    this.offered = one(this.element, 'datalist');
    this.changedOnly = one(this.element, '[type=checkbox]', HTMLInputElement);
    this.button = one(this.element, '.param-file-do', HTMLButtonElement);
    this.shown = one(this.element, '.param-file-look');
    this.path.addEventListener('input', () => {
      this.isNamed = true;
      // What is typed now is another file than the one that was looked at.
      this.can = false;
      this.draw();
      this.lookAfter(200);
    });
    this.changedOnly.addEventListener('change', () => this.send('look'));
    one(this.element, '.param-file-close').addEventListener('click', () => this.close());
    this.element.addEventListener('submit', event => {
      event.preventDefault();
      this.act();
    });
    this.element.addEventListener('keydown', event => {
      // JupyterLab has meanings of its own for keys.
      event.stopPropagation();
      if (event.key === 'Escape') this.close();
    });
  }

  /**
   * Stand below the head of a panel, whose buttons open it.
   * @param {HTMLElement} root
   */
  settle(root) {
    one(root, '.param-head').after(this.element);
    this.openers = {
      save: one(root, '.param-save', HTMLButtonElement),
      load: one(root, '.param-load', HTMLButtonElement),
    };
    this.openers.save.addEventListener('click', () => this.toggle(true));
    this.openers.load.addEventListener('click', () => this.toggle(false));
    this.draw();
  }

  /** @param {boolean} isSave */
  toggle(isSave) {
    if (!this.element.hidden && this.isSave === isSave) this.close();
    else this.open(isSave);
  }

  draw() {
    const isOpen = !this.element.hidden;
    this.openers?.save.setAttribute('aria-expanded', String(isOpen && this.isSave));
    this.openers?.load.setAttribute('aria-expanded', String(isOpen && !this.isSave));
    this.button.disabled = !this.can || this.isActing || (!this.isSave && this.isLocked);
  }

  /**
   * Take note that the panel shows something new, and whether the node can be changed: only loading needs that.
   * @param {boolean} isLocked
   */
  update(isLocked) {
    this.isLocked = isLocked;
    this.draw();
    if (this.hasLook && !this.element.hidden) this.lookAfter(300);
  }

  /** @param {boolean} isSave */
  open(isSave) {
    this.isSave = isSave;
    this.can = false;
    this.element.hidden = false;
    one(this.element, '.param-file-changed').hidden = !isSave;
    this.button.textContent = isSave ? 'Save' : 'Load';
    this.shown.replaceChildren();
    this.send('look');
    this.path.focus();
  }

  close() {
    this.element.hidden = true;
    this.draw();
    this.openers?.[this.isSave ? 'save' : 'load'].focus();
  }

  /** @param {Wish['do']} action */
  send(action) {
    clearTimeout(this.timer);
    this.number += 1;
    this.ask({
      do: action,
      is_save: this.isSave,
      path: this.path.value,
      changed_only: this.changedOnly.checked,
      number: this.number,
    });
  }

  /** @param {number} milliseconds */
  lookAfter(milliseconds) {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.send('look'), milliseconds);
  }

  act() {
    if (this.button.disabled) return;
    // What changes from here on is what was asked for.
    this.isActing = true;
    this.hasLook = false;
    this.send('act');
    this.draw();
  }

  /**
   * Show the kernel's answer, unless something newer has been asked.
   * @param {Answer} answer
   */
  answer({form, said, offered, suggested, markup, button, can}) {
    if (form !== this.number) return;
    this.hasLook = said === undefined;
    if (said !== undefined) {
      this.isActing = false;
      this.can = false;
      this.shown.innerHTML = said;
      this.markup = said;
    } else {
      if (this.isSave && !this.isNamed) {
        this.isNamed = true;
        this.path.value = suggested;
        this.path.select();
        this.send('look');
        return;
      }
      this.offered.replaceChildren(...offered.map(each => new Option('', each)));
      if (this.markup !== markup || !this.shown.firstChild) this.shown.innerHTML = markup;
      this.markup = markup;
      this.button.textContent = button;
      this.can = can;
    }
    this.draw();
  }
}
