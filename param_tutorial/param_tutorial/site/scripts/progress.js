/* What a reader has predicted and solved, kept in the browser, and the marks that show it: ✓ beside a lesson all of whose
   questions are answered and exercises solved, 2/6 beside one with some. A browser that keeps nothing shows the lessons
   without it. */

import {all, make} from '../../../param_tools/panel/dom.js';

/** @typedef {{of: number, answers: Record<string, string>, drafts: Record<string, string>}} Lesson */

const NAME = 'ros2-parameters-lessons';
const here = page(location.pathname);
// Not localStorage: of pages on a disk, Chromium 156 loads about one in twenty with a localStorage that reads nothing and
// keeps nothing (46 of 750 with no script of ours; over HTTP none of 80, and none of 350 with IndexedDB).
const opened = open();
const news = new BroadcastChannel(NAME);
/** @type {Record<string, Lesson>} */
let lessons = {};
let writes = 0;

/** @param {string} path */
function page(path) {
  const [name] = path.split('/').slice(-1);
  return decodeURIComponent(name).replace(/\.html$/, '') || 'index';
}

/**
 * Return the database, or null where this browser has none for us.
 * @returns {Promise<IDBDatabase | null>}
 */
function open() {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open(NAME, 1);
    request.onupgradeneeded = () => {
      // By lesson and number: {text, isDone}; and by lesson how many questions and exercises it has.
      for (const each of ['answers', 'sizes']) request.result.createObjectStore(each);
    };
    request.onsuccess = () => resolve(request.result);
    request.onerror = reject;
  }).catch(() => null);
}

/** Read what is kept; what this page changes meanwhile is newer. */
async function load() {
  const db = await opened;
  if (!db) return;
  try {
    let sizes, answers, before;
    do {
      before = writes;
      const transaction = db.transaction(['answers', 'sizes']);
      [sizes, answers] = await Promise.all(['sizes', 'answers'].map(each => entries(transaction.objectStore(each))));
    } while (writes !== before);
    lessons = {};
    for (const [name, of] of sizes) {
      if (Number.isInteger(of)) lessons[name] = {of, answers: {}, drafts: {}};
    }
    for (const [[name, number], kept] of answers) {
      if (typeof kept?.text !== 'string' || !lessons[name]) continue;
      lessons[name][kept.isDone ? 'answers' : 'drafts'][number] = kept.text;
    }
  } catch {
    // Nothing can be read, or what is kept is not ours.
  }
  show();
  dispatchEvent(new Event('lesson-progress'));
}

/**
 * @param {IDBObjectStore} store
 * @returns {Promise<[any, any][]>}
 */
async function entries(store) {
  const [keys, values] = await Promise.all([store.getAllKeys(), store.getAll()].map(result));
  return keys.map((key, at) => [key, values[at]]);
}

/**
 * @param {IDBRequest<any[]>} request
 * @returns {Promise<any[]>}
 */
function result(request) {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = reject;
  });
}

/**
 * Change what is kept; the page itself has changed already.
 * @param {(answers: IDBObjectStore, sizes: IDBObjectStore) => void} how
 */
async function write(how) {
  writes += 1;
  show();
  const db = await opened;
  if (!db) return;
  try {
    const transaction = db.transaction(['answers', 'sizes'], 'readwrite');
    transaction.oncomplete = () => news.postMessage('changed');
    how(transaction.objectStore('answers'), transaction.objectStore('sizes'));
    // At once, for the reader may leave the page at once.
    transaction.commit();
  } catch {
    // The page lives on without memory.
  }
}

/**
 * Keep the answer to a question or an exercise of this page.
 * @param {string} number
 * @param {string} text
 */
export function keepAnswer(number, text, isDone = true) {
  const of = document.querySelectorAll('.rec-prediction, .rec-exercise').length;
  const {answers, drafts} = lessons[here] ?? {answers: {}, drafts: {}};
  lessons[here] = {answers, drafts, of};
  delete drafts[number];
  (isDone ? answers : drafts)[number] = text;
  write((kept, sizes) => {
    kept.put({text, isDone}, [here, number]);
    sizes.put(of, here);
  });
}

/**
 * Keep what was filled in; it counts as soon as it is right, and what was right once stays so.
 * @param {string} number
 * @param {string} text
 * @param {boolean} isDone
 */
export function keepExercise(number, text, isDone) {
  if (isDone || answerTo(number) === undefined) keepAnswer(number, text, isDone);
}

/** @param {string} number */
export function forgetAnswer(number) {
  delete lessons[here]?.answers[number];
  write(kept => kept.delete([here, number]));
}

function forgetAll() {
  lessons = {};
  write((answers, sizes) => {
    answers.clear();
    sizes.clear();
  });
}

/**
 * @param {string} number
 * @returns {string | undefined}
 */
export function answerTo(number) {
  return lessons[here]?.answers[number];
}

/**
 * @param {string} number
 * @returns {string | undefined}
 */
export function draftOf(number) {
  return lessons[here]?.drafts[number];
}

/** Put the marks beside the links to the lessons. */
function show() {
  for (const link of all(document, '.bd-docs-nav a, .front-lessons a', HTMLAnchorElement)) {
    link.querySelector('.lesson-mark')?.remove();
    const lesson = lessons[page(link.pathname)];
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
  tell();
}

/** Say on the first page what is kept, and offer to forget it. */
function tell() {
  const line = /** @type {HTMLElement | null} */ (document.querySelector('.lesson-progress'));
  if (!line) return;
  const kept = Object.values(lessons);
  const count = kept.reduce((sum, {answers}) => sum + Object.keys(answers).length, 0);
  line.hidden = !count && kept.every(({drafts}) => !Object.keys(drafts).length);
  const button = make('button', {type: 'button'}, 'Forget my answers');
  button.addEventListener('click', forgetAll);
  const questions = count === 1 ? 'one question' : `${count} questions`;
  line.replaceChildren(
    `You have answered ${questions}. This browser keeps the answers; nobody else gets them.`,
    button,
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
