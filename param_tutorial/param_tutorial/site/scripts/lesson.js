/* A lesson's page: its predictions, and what the reader has answered. */

import {all} from '../../../param_tools/panel/dom.js';
import {askForPredictionOf, hideAnswers} from './predictions.js';
import {beginProgress} from './progress.js';
import {followReading} from './sidebar.js';
import {reachPictures, wrapSentences} from './wide.js';

/** Bring the page to life. */
export async function beginLesson() {
  arriving.disconnect();
  layOut();
  reachPictures(document);
  followReading();
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
