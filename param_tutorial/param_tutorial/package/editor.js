/* An editor for one file: a text field over its own text in colors, with numbers of lines, and a button that saves. */

import {make, uniqueName} from '../../param_tools/panel/dom.js';
import {initialize} from '../../param_tools/panel/front.js';

const INDENT = '    ';
const WORDS =
  'and|as|assert|async|await|break|class|continue|def|del|elif|else|except|finally|for|from|global|if|import|in|is|lambda|' +
  'nonlocal|not|or|pass|raise|return|try|while|with|yield|True|False|None';
const TOKENS = new RegExp(
  [
    '(?<comment>#.*)',
    `(?<string>[rfb]{0,2}(?:'''[^]*?(?:'''|$)|"""[^]*?(?:"""|$)|'(?:\\\\.|[^'\\\\\\n])*'?|"(?:\\\\.|[^"\\\\\\n])*"?))`,
    `(?<keyword>\\b(?:${WORDS})\\b)`,
    '(?<number>\\b\\d[\\d_.]*)',
    '(?<name>(?<=\\b(?:def|class)\\s+)\\w+)',
  ].join('|'),
  'g',
);

/** Return a text in colors; only Python has keywords. @param {string} text @param {boolean} isPython */
function paint(text, isPython) {
  const parts = [];
  let at = 0;
  for (const found of text.matchAll(TOKENS)) {
    const [kind] = Object.entries(found.groups ?? {}).find(([, part]) => part !== undefined) ?? [''];
    const isPlain = kind === 'keyword' && !isPython;
    parts.push(text.slice(at, found.index), isPlain ? found[0] : make('span', {className: `file-${kind}`}, found[0]));
    at = found.index + found[0].length;
  }
  // A last empty line has its height, too.
  return [...parts, `${text.slice(at)}\n`];
}

/**
 * Put a text in the place of what is selected; the browser can undo it.
 * @param {HTMLTextAreaElement} area
 * @param {string} text
 */
function insert(area, text) {
  if (!document.execCommand('insertText', false, text))
    area.setRangeText(text, area.selectionStart, area.selectionEnd, 'end');
}

/**
 * Indent the selected lines, or take their indentation back.
 * @param {HTMLTextAreaElement} area
 * @param {boolean} back
 */
function indent(area, back) {
  const {value, selectionStart: from, selectionEnd: to} = area;
  if (from === to && !back) {
    insert(area, INDENT);
    return;
  }
  const start = value.lastIndexOf('\n', from - 1) + 1;
  const lines = value.slice(start, to).split('\n');
  const changed = lines.map(line => (back ? line.replace(/^ {1,4}/, '') : line && INDENT + line)).join('\n');
  area.setSelectionRange(start, to);
  insert(area, changed);
  const end = start + changed.length;
  area.setSelectionRange(from === to ? end : start, end);
}

/**
 * Begin a new line, as far in as the one before, or further after a colon.
 * @param {HTMLTextAreaElement} area
 */
function breakLine(area) {
  const line = area.value.slice(area.value.lastIndexOf('\n', area.selectionStart - 1) + 1, area.selectionStart);
  const [spaces] = /^ */.exec(line) ?? [''];
  insert(area, `\n${spaces}${line.trimEnd().endsWith(':') ? INDENT : ''}`);
}

/** @param {import('@anywidget/types').RenderProps<any>} props */
function render({model, el}) {
  const hint = uniqueName();
  const area = make('textarea', {className: 'file-text', spellcheck: false, value: model.get('text')});
  area.setAttribute('aria-label', model.get('name'));
  area.setAttribute('aria-describedby', hint);
  for (const each of ['autocapitalize', 'autocomplete', 'autocorrect']) area.setAttribute(each, 'off');
  // No <pre>: the site makes each one that scrolls a stop of the Tab key.
  const colors = make('div', {className: 'file-colors', ariaHidden: 'true'});
  const numbers = make('div', {className: 'file-numbers', ariaHidden: 'true'});
  const save = make('button', {type: 'button', className: 'file-save'}, 'Save');
  const status = make('p', {className: 'file-status'});
  status.setAttribute('role', 'status');
  const keys = make('span', {id: hint, className: 'file-keys'}, 'Ctrl+S saves. Esc and then Tab leaves the editor.');
  el.classList.add('file-front');
  el.append(
    make('div', {className: 'file-head'}, make('b', {}, model.get('name')), keys, save),
    make('div', {className: 'file-code', tabIndex: -1}, numbers, make('div', {className: 'file-both'}, colors, area)),
    status,
  );
  // What the reader has typed is not in the file yet.
  let base = area.value;
  let leaves = false;
  const draw = () => {
    const isDraft = area.value !== base;
    const hasRun = !isDraft && base === model.get('text');
    const line = hasRun ? model.get('line') : 0;
    colors.replaceChildren(...paint(area.value, model.get('name').endsWith('.py')));
    const count = area.value.split('\n').length;
    numbers.replaceChildren(
      ...Array.from({length: count}, (_, at) =>
        make('span', {className: at + 1 === line ? 'file-wrong' : ''}, `${at + 1}\n`),
      ),
    );
    save.disabled = !isDraft;
    status.innerHTML = hasRun ? model.get('status') : isDraft ? 'Not saved yet.' : 'Saving …';
    status.classList.toggle('file-error', hasRun && model.get('is_error'));
  };
  const send = () => {
    // The kernel says what is in the file from then on; a page may have to wake it first.
    model.send({do: 'save', text: area.value, base});
    base = area.value;
    draw();
  };
  const hear = () => {
    if (area.value === base && base !== model.get('text')) area.value = model.get('text');
    if (area.value === model.get('text')) base = area.value;
    draw();
  };
  area.addEventListener('input', draw);
  area.addEventListener('keydown', event => {
    event.stopPropagation(); // JupyterLab has meanings of its own for keys
    const hasControl = event.ctrlKey || event.metaKey;
    if ((hasControl && event.key === 's') || (event.key === 'Enter' && (hasControl || event.shiftKey))) send();
    else if (event.key === 'Tab' && !leaves) indent(area, event.shiftKey);
    else if (event.key === 'Enter') breakLine(area);
    else {
      leaves = event.key === 'Escape' || (leaves && event.key === 'Shift');
      return;
    }
    leaves = false;
    event.preventDefault();
    draw();
  });
  save.addEventListener('click', send);
  model.on('change', hear);
  draw();
  return () => model.off('change', hear);
}

export default {initialize, render};
