/* A lesson's page: its predictions, what the reader has answered, and buttons that copy code. */

import {all, make, one} from '../../../param_tools/panel/dom.js';
import {copy} from './clipboard.js';
import {askForPredictionOf, hideAnswers} from './predictions.js';
import {beginProgress} from './progress.js';
import {reachPictures, wrapSentences} from './wide.js';

/** Put a button beside each cell's code that copies it. */
function offerCopies() {
  for (const cell of all(document, 'div.cell_input')) {
    const code = (one(cell, 'pre').textContent ?? '').trimEnd();
    const button = make('button', {type: 'button', className: 'lesson-copy'}, 'Copy');
    button.setAttribute('aria-label', 'Copy the code of this cell');
    button.addEventListener('click', async () => {
      button.dataset.said = (await copy(code)) ? 'Copied' : 'Not copied';
      button.textContent = button.dataset.said;
      setTimeout(() => {
        button.textContent = 'Copy';
        delete button.dataset.said;
      }, 2000);
    });
    cell.append(button);
  }
}

/** Bring the page to life. */
export async function beginLesson() {
  arriving.disconnect();
  layOut();
  reachPictures(document);
  offerCopies();
  const remembered = beginProgress();
  all(document, '.lesson-prediction').forEach(askForPredictionOf);
  await remembered;
  document.documentElement.dataset.lesson = 'ready';
}

/** Lay out what has arrived of the page, before it is drawn. */
function layOut() {
  wrapSentences(document);
  hideAnswers();
}

const arriving = new MutationObserver(layOut);
arriving.observe(document, {childList: true, subtree: true});
