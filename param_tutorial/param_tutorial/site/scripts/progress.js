/* What a reader has predicted and solved, kept in the browser, and the marks that show it: ✓ beside a lesson all of whose
   questions are answered and exercises solved, 2/6 beside one with some. A browser that keeps nothing shows the lessons
   without it. */

import {createStore, entries} from 'idb-keyval';
import {all, make} from '../../../param_tools/panel/dom.js';

/**
 * An answer to a question, or an exercise that is solved, which has no text: whether it was right, when (local time in ISO
 * 8601), and, of a recall, how often it was right in a row.
 * @typedef {{text: string, right: boolean, at: string, times: number}} Answer
 *
 * @typedef {{of: number, answers: Record<string, Answer>}} Lesson
 */

const NAME = 'ros2-parameters-progress';
/** The name of this page. */
export const here = page(location.pathname);
// Not localStorage: of pages on a disk, Chromium 156 loads about one in twenty with a localStorage that reads nothing and
// keeps nothing (46 of 750 with no script of ours; over HTTP none of 80, and none of 350 with IndexedDB).
const store = createStore(NAME, 'lessons');
const news = new BroadcastChannel(NAME);
/** By their names. @type {Record<string, Lesson>} */
let lessons = {};
/** What a lesson has to answer or to solve. */
const QUESTIONS = '.lesson-prediction, [class*="tag_live-check-"]';
const DAY_MS = 24 * 3600 * 1000;

/** @param {string} path */
function page(path) {
  const [name] = path.split('/').slice(-1);
  return decodeURIComponent(name).replace(/\.html$/, '') || 'index';
}

/** Read what is kept. */
async function load() {
  try {
    lessons = Object.fromEntries(await entries(store));
  } catch {
    // Nothing can be read.
  }
  show();
  dispatchEvent(new Event('lesson-progress'));
}

/**
 * Change what is kept; the page itself has changed already.
 * @param {(lessons: IDBObjectStore) => void} how
 */
async function write(how) {
  show();
  try {
    await store('readwrite', kept => {
      kept.transaction.oncomplete = () => {
        news.postMessage('changed');
        load(); // what was being read meanwhile is older
      };
      how(kept);
      // At once, for the reader may leave the page at once.
      kept.transaction.commit();
    });
  } catch {
    // The page lives on without memory.
  }
}

/** @param {Record<string, Answer>} answers Of this page's lesson. */
function keep(answers) {
  const lesson = {of: document.querySelectorAll(QUESTIONS).length, answers};
  lessons[here] = lesson;
  write(kept => kept.put(lesson, here));
}

/**
 * Keep the answer to a question of this page, or that an exercise of it is solved.
 * @param {string} number
 * @param {string} text
 * @param {boolean} right
 */
export function keepAnswer(number, text, right) {
  const answers = lessons[here]?.answers ?? {};
  const times = right ? (answers[number]?.times ?? 0) + 1 : 0;
  keep({...answers, [number]: {text, right, at: localTime(), times}});
}

/** Return the time as ISO 8601 has it, in whole seconds. */
export function localTime() {
  const now = new Date();
  return new Date(now.getTime() - 60_000 * now.getTimezoneOffset()).toISOString().slice(0, 19);
}

/** @param {string} number */
export function forgetAnswer(number) {
  const {[number]: _, ...others} = lessons[here]?.answers ?? {};
  keep(others);
}

function forgetAll() {
  lessons = {};
  write(kept => kept.clear());
}

/**
 * @param {string} number
 * @returns {string | undefined}
 */
export function answerTo(number) {
  return lessons[here]?.answers[number]?.text;
}

/** @param {string} number Of a prediction, a recall or an exercise: '5.2-1', '5.2-r1', '5.2b'. */
const isQuestion = number => number.includes('-');

/** Return what all lessons keep as the course writes it into a file, which `make class` reads: see `learner/progress.py`. */
export function progressFile() {
  /** @type {Record<string, string>} */
  const solved = {};
  /** @type {Record<string, {choice: string, right: boolean, at: string}>} */
  const predicted = {};
  for (const {answers} of Object.values(lessons)) {
    for (const [number, {text, right, at}] of Object.entries(answers)) {
      if (isQuestion(number)) predicted[number] = {choice: text, right, at};
      else solved[number] = at;
    }
  }
  return `${JSON.stringify({version: 1, solved, predicted}, null, 1)}\n`;
}

/**
 * Tell whether a recall comes again: a day after a wrong answer, and three, nine, 27 days after the first, second and
 * third right one in a row.
 * @param {string} number
 * @param {Answer | undefined} [answer]
 */
export function isDue(number, answer = lessons[here]?.answers[number]) {
  if (!answer || !number.includes('-r')) return false;
  return Date.now() - Date.parse(answer.at) > 3 ** answer.times * DAY_MS;
}

/** Put the marks beside the links to the lessons. */
function show() {
  for (const link of all(document, '.bd-docs-nav a, .front-lessons a', HTMLAnchorElement)) {
    link.querySelector('.lesson-mark')?.remove();
    const lesson = link.hash.length > 1 ? undefined : lessons[page(link.pathname)];
    if (!lesson) continue;
    const {of, answers} = lesson;
    const count = Math.min(Object.keys(answers).length, of);
    if (!count) continue;
    const title = `${count} of ${of} questions answered`;
    const sign = make('span', {}, count === of ? '✓' : `${count}/${of}`);
    sign.setAttribute('aria-hidden', 'true');
    const words = make('span', {className: 'visually-hidden'}, ` (${title})`);
    const mark = make('span', {className: 'lesson-mark', title}, sign, words);
    if (count === of) mark.dataset.done = '';
    link.append(mark);
  }
  const of = document.querySelectorAll(QUESTIONS).length;
  // It is in the bar, and above the lesson, where a phone shows it.
  for (const line of all(document, '.lesson-here')) {
    line.hidden = !of;
    line.textContent = `${Object.keys(lessons[here]?.answers ?? {}).length} of ${of} answered`;
  }
  tell();
}

/** Say on the first page what is kept, and offer to forget it. */
function tell() {
  const line = /** @type {HTMLElement | null} */ (document.querySelector('.lesson-progress'));
  if (!line) return;
  const kept = Object.values(lessons);
  const count = kept.reduce((sum, {answers}) => sum + Object.keys(answers).length, 0);
  line.hidden = !count;
  const save = make('a', {className: 'lesson-save', download: 'progress.json'}, 'Save as progress.json');
  save.href = `data:application/json,${encodeURIComponent(progressFile())}`;
  const forget = make('button', {type: 'button'}, 'Forget my answers');
  forget.addEventListener('click', forgetAll);
  const questions = count === 1 ? 'one question' : `${count} questions`;
  line.replaceChildren(
    `You have answered ${questions}. This browser keeps the answers; nobody else gets them.`,
    save,
    forget,
  );
  tellDue(line);
}

/**
 * Say which recalls come again today, with links to them.
 * @param {HTMLElement} line What it stands below.
 */
function tellDue(line) {
  document.querySelector('.lesson-due')?.remove();
  const due = Object.entries(lessons).flatMap(([name, {answers}]) =>
    Object.entries(answers)
      .filter(([number, answer]) => isDue(number, answer))
      .map(([number]) => make('a', {href: `${name}.html#question-${number}`}, number)),
  );
  if (!due.length) return;
  const links = due.flatMap((link, at) => (at ? [', ', link] : [link]));
  line.after(
    make('p', {className: 'lesson-due'}, make('b', {}, 'Due today'), ', to see what you remember: ', ...links),
  );
}

/** Show what is kept, from now on also what another window changes. */
export function beginProgress() {
  news.addEventListener('message', load);
  // Some browsers don't let pages on a disk hear each other.
  document.addEventListener('visibilitychange', () => {
    if (!document.hidden) load();
  });
  return load();
}
