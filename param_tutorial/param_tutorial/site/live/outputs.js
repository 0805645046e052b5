/* What a cell puts out, as Sphinx draws the stored outputs. */

import {make} from '../../../param_tools/panel/dom.js';

const COLORS = ['Black', 'Red', 'Green', 'Yellow', 'Blue', 'Magenta', 'Cyan', 'White'];
// Escape itself may stand in no regular expression that is written out.
const CODE = new RegExp(`${String.fromCharCode(27)}\\[([\\d;]*)m`);

/**
 * Return a text in the colors that its escape sequences say.
 * @param {string} text
 */
function colored(text) {
  const made = document.createDocumentFragment();
  let color = '';
  let isBold = false;
  text.split(CODE).forEach((part, at) => {
    if (at % 2) {
      for (const code of part.split(';').map(Number)) {
        if (code === 1) isBold = true;
        else if (code === 0 || code === 39) [color, isBold] = ['', isBold && code === 39];
        else if (code === 22) isBold = false;
        else if (code >= 30 && code <= 37) color = COLORS[code - 30];
      }
    } else if (part) {
      const classes = [color && `-Color-${color}`, isBold && '-Color-Bold', (color || isBold) && '-Color'];
      made.append(make('span', {className: classes.filter(Boolean).join(' ')}, part));
    }
  });
  return made;
}

/**
 * @param {string} kind
 * @param {string} text
 */
function block(kind, text) {
  const pre = make('pre', {tabIndex: 0}, colored(text));
  return make('div', {className: `output ${kind}`}, make('div', {className: 'highlight'}, pre));
}

/**
 * Return the element for an output that is no widget.
 * @param {any} output
 */
export function draw(output) {
  if (output.output_type === 'stream') return block(output.name === 'stderr' ? 'stderr' : 'stream', output.text);
  if (output.output_type === 'error') return block('traceback', output.traceback.join('\n'));
  const html = output.data['text/html'];
  if (html === undefined) return block('text_plain', output.data['text/plain'] ?? '');
  return make('div', {className: 'output text_html', innerHTML: html});
}

/**
 * Add an output to those before it; what is written to a stream piece by piece is one text.
 * @param {any[]} outputs
 * @param {any} output
 */
export function add(outputs, output) {
  const last = outputs.at(-1);
  if (output.output_type === 'stream' && last?.output_type === 'stream' && last.name === output.name) {
    last.text += output.text;
  } else outputs.push({...output});
}
