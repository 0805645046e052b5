/* What a cell puts out, as Sphinx draws the stored outputs. */

import {AnsiUp} from 'ansi_up';
import {make} from '../../../param_tools/panel/dom.js';

/** An output of a cell, as the kernel says it, and what shows it. */
export class Output {
  /** @type {HTMLElement | undefined} */
  drawn;
  /** @type {HTMLElement | undefined} */
  pre;
  colors = new AnsiUp();

  /**
   * @param {any} said
   * @param {HTMLElement} [view] Of a widget.
   */
  constructor(said, view) {
    this.said = {...said};
    this.drawn = view;
    this.colors.use_classes = true;
  }

  get element() {
    this.drawn ??= this.draw();
    return this.drawn;
  }

  draw() {
    const {output_type, name, text, traceback, data} = this.said;
    if (output_type === 'stream') return this.block(name === 'stderr' ? 'stderr' : 'stream', text);
    if (output_type === 'error') return this.block('traceback', traceback.join('\n'));
    const html = data['text/html'];
    if (html === undefined) return this.block('text_plain', data['text/plain'] ?? '');
    return make('div', {className: 'output text_html', innerHTML: html});
  }

  /**
   * @param {string} kind
   * @param {string} text
   */
  block(kind, text) {
    this.pre = make('pre', {tabIndex: 0});
    this.write(text);
    return make('div', {className: `output ${kind}`}, make('div', {className: 'highlight'}, this.pre));
  }

  /** @param {string} text With escape sequences for colors. */
  write(text) {
    this.pre?.insertAdjacentHTML('beforeend', this.colors.ansi_to_html(text));
  }

  /**
   * Take what is written to the same stream next; return false if it is another output.
   * @param {any} said
   */
  goOn(said) {
    if (said.output_type !== 'stream' || this.said.output_type !== 'stream' || said.name !== this.said.name)
      return false;
    this.said.text += said.text;
    this.write(said.text);
    return true;
  }
}
