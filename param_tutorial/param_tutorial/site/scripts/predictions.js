/* The predictions of a lesson: a reader commits to an answer before the page shows what happens. */

import {all, make, one} from '../../../param_tools/panel/dom.js';
import {markChoices} from '../../exercises/marks.js';
import {choiceOf, parseNumber} from './answers.js';
import {answerTo, forgetAnswer, isDue, keepAnswer} from './progress.js';

/** @import {Facts} from './answers.js' */

/** For each prediction what is folded below it. @type {Map<HTMLElement, Fold>} */
const folds = new Map();

/** What gives the answer to a prediction away, and the button that shows it. */
class Fold {
  /** @type {Set<HTMLElement>} */
  answer = new Set();
  button = make('button', {type: 'button'}, 'Commit to an answer, or look');

  /**
   * @param {HTMLElement} form
   * @param {HTMLElement} first What the button is put before.
   */
  constructor(form, first) {
    this.button.setAttribute('aria-label', `${this.button.textContent} at that of question ${form.dataset.number}`);
    const line = make('p', {className: 'lesson-look'}, this.button);
    first.before(line);
    this.button.addEventListener('click', () => this.show(!this.isShown));
    form.addEventListener('lesson-committed', () => {
      this.show(true);
      line.hidden = true;
    });
    this.show(false);
  }

  get isShown() {
    return this.button.getAttribute('aria-expanded') === 'true';
  }

  /** @param {HTMLElement} element */
  add(element) {
    if (this.answer.has(element)) return;
    this.answer.add(element);
    element.classList.add('lesson-answer');
    element.classList.toggle('lesson-folded', !this.isShown);
  }

  /** @param {boolean} isShown */
  show(isShown) {
    this.button.setAttribute('aria-expanded', String(isShown));
    for (const each of this.answer) {
      each.classList.toggle('lesson-folded', !isShown);
      // What was hidden had no size when the theme's script let the keyboard scroll what is too wide.
      for (const box of [each, ...all(each, '*')].filter(element => element.matches('[tabindex="-1"]'))) {
        if (box.scrollWidth > box.clientWidth || box.scrollHeight > box.clientHeight) box.tabIndex = 0;
      }
    }
  }
}

/**
 * Hide what gives the answer to a prediction away, up to the next cell, until it is committed to or the reader looks.
 *
 * On paper it stays hidden: see the style sheet. Called while the page is being loaded, so that nothing is drawn that
 * goes away again: what has come by then is folded.
 * @param {HTMLElement} form
 */
function foldAnswer(form) {
  /** @type {HTMLElement[]} */
  const answer = [];
  let each = form.closest('div.cell')?.nextElementSibling;
  for (; each instanceof HTMLElement && !each.matches('section, h2, h3'); each = each.nextElementSibling) {
    if (document.readyState === 'loading' && !each.nextSibling) break; // it may have come in part
    const isCell = each.matches('div.cell');
    if (isCell && (answer.some(part => !part.matches('.cell_output')) || each.querySelector('.lesson-prediction')))
      break;
    answer.push(...(isCell ? all(each, ':scope > .cell_output') : [each]));
  }
  const [first] = answer;
  if (!first?.matches('.cell_output')) return;
  const fold = folds.get(form) ?? new Fold(form, first);
  folds.set(form, fold);
  for (const part of answer) fold.add(part);
}

export function foldAnswers() {
  all(document, '.lesson-prediction[data-decided]').forEach(foldAnswer);
}

/**
 * Let a prediction be committed: it is locked then, and the page says what became of it. The browser keeps it.
 * @param {HTMLFormElement} form
 * @param {Facts} facts
 */
export function askForPrediction(form, facts) {
  const number = form.dataset.number ?? '';
  const fields = one(form, 'fieldset', HTMLFieldSetElement);
  const said = one(form, '.lesson-says');
  const button = one(form, '.lesson-commit', HTMLButtonElement);
  const again = one(form, '.lesson-again');
  const boxes = all(form, 'input', HTMLInputElement);
  const given = () => String(new FormData(form).get('answer') ?? '').trim();

  /**
   * Return what is said to an answer that is none of the choices.
   * @param {string} answer
   */
  function other(answer) {
    return facts.typed && !Number.isNaN(parseNumber(answer, facts.typed.number)) ? facts.typed.otherwise : '';
  }

  /** @param {string} answer */
  function lock(answer) {
    const choice = choiceOf(answer, facts);
    const verdict = choice === undefined ? other(answer) : facts.choices[choice];
    said.innerHTML = verdict;
    // What has the keyboard goes, and the button that comes in its place takes over.
    const isHere = form.contains(document.activeElement);
    fields.disabled = Boolean(verdict);
    button.hidden = Boolean(verdict);
    again.hidden = !verdict;
    if (verdict && isHere) again.focus();
    if (verdict) form.dispatchEvent(new Event('lesson-committed'));
    return Boolean(verdict);
  }

  /** Mark the choices once there is a verdict. */
  function mark() {
    const right = boxes.find(each => facts.right.includes(choiceOf(each.value, facts) ?? ''));
    markChoices(form, fields.disabled && right ? right.value : '');
  }

  function comeBack() {
    const kept = answerTo(number);
    if (kept === undefined || isDue(number) || !again.hidden) return;
    const box = boxes.find(each => each.type === 'text' || each.value === kept);
    // The question may have other choices today.
    if (!box || !lock(kept)) return;
    if (box.type === 'text') box.value = kept;
    else box.checked = true;
    mark();
  }

  form.addEventListener('input', () => {
    button.disabled = !given();
  });
  form.addEventListener('submit', event => {
    event.preventDefault();
    const answer = given();
    if (!answer) return;
    if (lock(answer)) keepAnswer(number, answer, facts.right.includes(choiceOf(answer, facts) ?? ''));
    else said.innerHTML = facts.typed?.askAgain ?? '';
    mark();
  });
  again.addEventListener('click', () => {
    forgetAnswer(number);
    fields.disabled = false;
    form.reset();
    mark();
    said.textContent = '';
    again.hidden = true;
    button.hidden = false;
    button.disabled = true;
    boxes[0].focus();
  });
  comeBack();
  // What is kept may not have been read yet, or comes from another window.
  addEventListener('lesson-progress', comeBack);
}
