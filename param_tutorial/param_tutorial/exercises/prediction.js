/* The form of a prediction, in the notebook and on the website: it reads an answer, and shows the verdict.

   Its host keeps the answer, and knows when the verdict may be shown. */

import {all, one} from '../../param_tools/panel/dom.js';
import {Marker} from './marker.js';

/**
 * @typedef {object} Facts
 * @property {Record<string, string>} verdicts By the text of a choice, what is said to it, as HTML.
 * @property {string} right The text of the right choice.
 * @property {string | null} otherwise What is said to any other number; null where the reader chooses.
 * @property {import('./marker.js').Scale | null} [scale] Where the number is given by a marker.
 *
 * @typedef {object} Host
 * @property {(answer: string, meant: string, isRight: boolean) => void} commit Keeps an answer and the choice that it
 *   means, and has the next cell run.
 * @property {() => void} [skip] Shows what is hidden.
 * @property {() => void} [forget] Lets the reader answer again.
 */

// With or without a unit. The first group is a number whose commas stand between thousands; in the second, a comma is the
// decimal point.
const NUMBER =
  /^\s*(?:([+-]?[1-9][0-9]{0,2}(?:,[0-9]{3})+(?:\.[0-9]+)?)|([+-]?(?:[0-9]+[.,]?[0-9]*|[.,][0-9]+)(?:[eE][+-]?[0-9]+)?))\s*(?:[^0-9\s.,:;/()!?&+*=<>-]\S*)?\s*$/u;

/**
 * Return the number in a typed answer, such as `60`, `60 m` or `60,0`; NaN if there is none.
 * @param {string} answer
 */
export function parseNumber(answer) {
  const [, grouped, plain] = NUMBER.exec(answer) ?? [];
  return Number(grouped?.replaceAll(',', '') ?? plain?.replace(',', '.'));
}

/**
 * Return the text of the choice that an answer is, or the answer if it is none; an empty text if it can't be judged.
 * @param {string} answer
 * @param {Facts} facts
 */
export function choiceOf(answer, {verdicts, otherwise, scale}) {
  if (otherwise === null) return answer in verdicts ? answer : '';
  const number = parseNumber(answer);
  if (Number.isNaN(number)) return '';
  const near = (scale?.tolerance ?? 0) + 1e-9;
  return Object.keys(verdicts).find(each => Math.abs(Number(each) - number) <= near) ?? answer;
}

/**
 * Let a reader commit to an answer.
 * @param {HTMLFormElement} form As `predicting.py` draws it.
 * @param {Host} host
 * @returns A function that locks the form at an answer, and shows the verdict if it is decided, and a note as HTML. With
 *   an empty answer, or one that the question no longer has, it unlocks the form. Where the sentence stands below the cell
 *   that decides, the form only says whether the answer is right.
 */
export function askForPrediction(form, {commit, skip, forget}) {
  /** @type {Facts} */
  const facts = JSON.parse(form.dataset.facts ?? '');
  const {verdicts, right, otherwise, scale} = facts;
  const fields = one(form, 'fieldset', HTMLFieldSetElement);
  const boxes = all(fields, 'input', HTMLInputElement);
  const button = one(form, '.param-predict-commit', HTMLButtonElement);
  const says = one(form, '.param-predict-says');
  const marker = scale && new Marker(form, scale);
  const given = () =>
    marker ? (marker.isAtRest ? '' : `${marker.value}`) : String(new FormData(form).get('answer') ?? '').trim();

  form.addEventListener('input', () => {
    button.disabled = !given();
  });
  form.addEventListener('submit', event => {
    event.preventDefault();
    if (fields.disabled) {
      forget?.();
      return;
    }
    const answer = given();
    const choice = choiceOf(answer, facts);
    if (choice) commit(scale ? answer : choice, choice, choice === right);
    else if (answer) {
      says.innerHTML = 'Please answer with a number, such as <code>42</code> or <code>0.5</code>. A unit may follow.';
    }
  });
  fields.addEventListener('keydown', event => {
    if (event.key !== 'Enter') return;
    event.preventDefault();
    form.requestSubmit(); // JupyterLab keeps the browser from it
  });
  const skipButton = one(form, '.param-predict-skip');
  skipButton.addEventListener('click', () => skip?.());

  /** @param {string} kept */
  return function show(kept, isDecided = true, note = '', isToldBelow = false) {
    const answer = choiceOf(kept, facts);
    const isCommitted = answer !== '';
    if (fields.disabled && !isCommitted) form.reset();
    for (const box of boxes) {
      if (box.type === 'radio') box.checked = isCommitted ? box.value === answer : box.checked;
      else if (isCommitted && !scale) box.value = answer;
      const mark = isCommitted && isDecided && (box.value === right ? 'right' : box.checked && 'wrong');
      const label = /** @type {HTMLElement} */ (box.parentElement);
      if (box.type === 'radio' && mark) label.dataset.mark = mark;
      else delete label.dataset.mark;
    }
    marker?.show(isCommitted ? kept : '', isCommitted && isDecided ? right : '');
    // The button keeps the focus, from which Shift+Enter goes on to the next cell; what is disabled would lose it.
    const isHere = fields.contains(document.activeElement);
    button.disabled = !isCommitted && !given();
    if (isCommitted && isHere) button.focus();
    fields.disabled = isCommitted;
    skipButton.style.display = isCommitted ? 'none' : ''; // also where the veil shows it
    button.textContent = !isCommitted ? 'Commit' : forget ? 'Answer again' : 'Committed';
    button.classList.toggle('param-predict-committed', isCommitted && !forget);
    button.classList.toggle('param-predict-again', isCommitted && Boolean(forget));
    const verdict = verdicts[answer] ?? otherwise ?? '';
    const told = isToldBelow ? (/^<b.*?<\/b>/.exec(verdict)?.[0] ?? '') : verdict;
    const said = isDecided ? told : 'The next cell decides.';
    const shown = isCommitted ? `${said} ${note}` : '';
    if (says.innerHTML !== shown) says.innerHTML = shown;
  };
}
