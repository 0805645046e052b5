/* What a cell puts out, as Sphinx draws the stored outputs. */

import {AnsiUp} from 'ansi_up';
import {marked} from 'marked';
import {make} from '../../../param_tools/panel/dom.js';
import {clean} from '../scripts/wide.js';

// Of a text, as many letters are drawn before the reader wants all.
const DRAWN = 100_000;

/** An output of a cell, as the kernel says it, and what shows it. */
export class Output {
  /** @type {HTMLElement | undefined} */
  drawn;
  /** @type {HTMLElement | undefined} */
  pre;
  /** What is not drawn yet of the text. */
  rest = '';
  left = DRAWN;
  isDue = false;
  all = make('button', {type: 'button', className: 'live-all', hidden: true});
  colors = new AnsiUp();

  /**
   * @param {any} said
   * @param {HTMLElement} [view] Of a widget.
   */
  constructor(said, view) {
    this.said = {...said};
    this.drawn = view;
    this.colors.use_classes = true;
    this.all.addEventListener('click', () => {
      this.left = Number.POSITIVE_INFINITY;
      this.write();
    });
  }

  get element() {
    this.drawn ??= this.draw();
    return this.drawn;
  }

  draw() {
    const {output_type, name, text, traceback, data} = this.said;
    if (output_type === 'stream') return this.block(name === 'stderr' ? 'stderr' : 'stream', text);
    if (output_type === 'error') return this.block('traceback', traceback.join('\n'));
    if (!Object.keys(data).length) return make('div', {hidden: true});
    const html = data['text/html'] ?? marked.parse(data['text/markdown'] ?? '', {async: false});
    if (html) return make('div', {className: 'output text_html', innerHTML: clean(html)});
    const image = Object.keys(data).find(each => each.startsWith('image/'));
    if (image) {
      // Without its page, a picture runs no script.
      const src = `data:${image}${image.endsWith('xml') ? ',' : ';base64,'}${encodeURIComponent(data[image])}`;
      return make('div', {className: 'output'}, make('img', {src, alt: data['text/plain'] ?? ''}));
    }
    const json = JSON.stringify(data['application/json'], null, 2);
    return this.block('text_plain', data['text/latex'] ?? json ?? data['text/plain'] ?? '');
  }

  /**
   * @param {string} kind
   * @param {string} text
   */
  block(kind, text) {
    this.pre = make('pre', {className: 'live-text', tabIndex: 0});
    this.rest = text;
    this.write();
    return make('div', {className: `output ${kind}`}, make('div', {className: 'highlight'}, this.pre), this.all);
  }

  /** Draw what has come since, escape sequences for colors among it; a reader at its end stays there. */
  write() {
    this.isDue = false;
    if (!this.pre) return;
    const {scrollTop, clientHeight, scrollHeight} = this.pre;
    const text = this.rest.slice(0, this.left);
    this.pre.insertAdjacentHTML('beforeend', this.colors.ansi_to_html(text));
    this.rest = this.rest.slice(text.length);
    this.left -= text.length;
    this.all.hidden = !this.rest;
    this.all.textContent = this.rest && `Show all: ${this.rest.length.toLocaleString('en')} more letters`;
    if (scrollTop && scrollTop + clientHeight > scrollHeight - 5) this.pre.scrollTop = this.pre.scrollHeight;
  }

  /**
   * Take what is written to the same stream next; return false if it is another output.
   * @param {any} said
   */
  goOn(said) {
    if (said.output_type !== 'stream' || this.said.output_type !== 'stream' || said.name !== this.said.name)
      return false;
    this.said.text += said.text;
    this.rest += said.text;
    // Prints may come faster than a page can draw.
    if (!this.isDue) requestAnimationFrame(() => this.write());
    this.isDue = true;
    return true;
  }
}
