/* The predictions of a lesson: the browser keeps the answers, and what gives one away is hidden until then. */

import {all, make, one} from '../../../param_tools/panel/dom.js';
import {askForPrediction} from '../../exercises/prediction.js';
import {runBelow} from '../live/page.js';
import {answerTo, forgetAnswer, isDue, keepAnswer} from './progress.js';

/**
 * Return what gives the answer to a prediction away: texts and outputs up to the next heading, or to the next prediction.
 * In JupyterLab the same is hidden: see `notebook/veil.js`.
 * @param {HTMLElement} question
 */
function answerBelow(question) {
  /** @type {HTMLElement[]} */
  const answer = [];
  let each = question.closest('div.cell')?.nextElementSibling;
  for (; each instanceof HTMLElement && !each.matches('section, h2, h3'); each = each.nextElementSibling) {
    if (each.querySelector('[data-decided]')) break;
    if (document.readyState === 'loading' && !each.nextSibling) break; // it may have come in part
    answer.push(...(each.matches('div.cell') ? all(each, ':scope > .cell_output') : [each]));
  }
  return answer.filter(part => !part.matches('.lesson-look'));
}

/**
 * Hide the answers, each behind a button. Called while the page is being loaded, so that nothing is drawn that goes away
 * again: what has come by then is hidden.
 */
export function hideAnswers() {
  for (const question of all(document, '[data-decided]:not([data-shown])')) {
    const answer = answerBelow(question);
    for (const part of answer) part.classList.add('lesson-folded');
    if (!answer.length || answer[0].previousElementSibling?.matches('.lesson-look')) continue;
    const look = make('button', {type: 'button'}, 'Commit to an answer, or look');
    look.setAttribute('aria-label', `${look.textContent} at that of question ${question.dataset.number}`);
    look.addEventListener('click', () => showAnswer(question));
    answer[0].before(make('p', {className: 'lesson-look'}, look));
  }
}

/** @param {HTMLElement} question */
function showAnswer(question) {
  question.dataset.shown = '';
  const answer = answerBelow(question);
  const look = answer[0]?.previousElementSibling;
  if (look?.matches('.lesson-look')) look.remove();
  for (const part of answer) {
    part.classList.remove('lesson-folded');
    // What was hidden had no size when the theme's script let the keyboard scroll what is too wide.
    for (const box of [part, ...all(part, '*')].filter(element => element.matches('[tabindex="-1"]'))) {
      if (box.scrollWidth > box.clientWidth || box.scrollHeight > box.clientHeight) box.tabIndex = 0;
    }
  }
}

/**
 * Let the reader commit to an answer; then the cell runs that decides it.
 * @param {HTMLElement} question
 */
export function askForPredictionOf(question) {
  const {number = '', decided} = question.dataset;
  const form = one(question, 'form', HTMLFormElement);
  let isRunning = false;
  const show = askForPrediction(form, {
    async commit(answer, _, isRight) {
      isRunning = decided !== undefined;
      keepAnswer(number, answer, isRight);
      if (isRunning) {
        show(answer, false);
        await runBelow(question);
      }
      isRunning = false;
      comeBack();
    },
    forget() {
      forgetAnswer(number);
      show('');
      one(form, 'input').focus();
    },
  });

  function comeBack() {
    const kept = isDue(number) ? undefined : answerTo(number);
    if (kept === undefined || isRunning) return;
    show(kept);
    if (decided !== undefined) showAnswer(question);
  }
  comeBack();
  // What is kept may not have been read yet, or comes from another window.
  addEventListener('lesson-progress', comeBack);
}
