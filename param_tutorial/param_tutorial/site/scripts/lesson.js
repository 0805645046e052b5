/* Brings a lesson's page to life: its predictions, its exercises and its recorded views. */

import {all, make, one} from '../../../param_tools/panel/dom.js';
import {copy} from './clipboard.js';
import {RecordedExercise} from './exercises.js';
import {askForPrediction, foldAnswers} from './predictions.js';
import {beginProgress} from './progress.js';
import {unpack} from './recordings.js';
import {LINK, panels, RecordedPanel, RecordedRobot, robots} from './replay.js';

/**
 * Bring all views of a kind to life; where that fails, a view says so, and the others live on.
 * @template {HTMLElement} T
 * @param {T[]} sections
 * @param {(section: T, facts: any) => void} live
 */
async function enliven(sections, live) {
  for (const section of sections) {
    try {
      live(section, await unpack(one(section, '.rec-data').textContent ?? ''));
    } catch (error) {
      const isOld = typeof DecompressionStream === 'undefined';
      const words = isOld
        ? 'This browser is too old to unpack the recordings, so the controls do not answer: it has no DecompressionStream.'
        : 'The recording of this view is damaged, so its controls do not answer. Load the page again.';
      const note = make('p', {className: 'rec-note rec-dead'}, words);
      note.setAttribute('role', 'status');
      section.append(note);
      for (const control of all(section, 'input, textarea, select, button')) control.setAttribute('disabled', '');
      console.warn(error);
    }
  }
}

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

/** Bring the settings back that the page's address names, if it names any. */
function followLink() {
  if (!location.hash.startsWith(LINK)) return;
  const [id, query] = location.hash.slice(LINK.length).split(/\?(.*)/s);
  const panel = panels.find(each => each.section.id === id);
  if (panel) {
    panel.followLink([...new URLSearchParams(query)]);
    return;
  }
  const note = document.querySelector('.lesson-no-link') ?? make('p', {className: 'lesson-download lesson-no-link'});
  note.setAttribute('role', 'status');
  note.textContent =
    'The link that brought you here asks for settings of a panel that is not on this page. It was ignored.';
  one(document, '.bd-article h1').after(note);
  scrollTo(0, 0);
}

/** Bring the page to life. */
export async function beginLesson() {
  arriving.disconnect();
  foldAnswers();
  offerCopies();
  const remembered = beginProgress();
  await enliven(all(document, '.rec-prediction', HTMLFormElement), askForPrediction);
  await enliven(all(document, '.rec-exercise'), (form, facts) => new RecordedExercise(form, facts));
  await enliven(all(document, '.rec-robot'), (section, facts) => robots.push(new RecordedRobot(section, facts)));
  await enliven(all(document, '.rec-panel'), (section, facts) => panels.push(new RecordedPanel(section, facts)));
  followLink();
  addEventListener('hashchange', followLink);
  // The first page begins with a drive, if nothing else is wanted.
  const [first] = robots;
  const isStill = matchMedia('(prefers-reduced-motion: reduce)').matches;
  if (first?.section.closest('.front-robot') && !isStill) first.drive();
  await remembered;
  document.documentElement.dataset.lesson = 'ready';
}

const arriving = new MutationObserver(foldAnswers);
arriving.observe(document, {childList: true, subtree: true});
