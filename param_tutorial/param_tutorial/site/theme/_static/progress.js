/* What a reader has predicted and solved, kept in the browser, and the marks that show it: ✓ beside a lesson all of whose
   questions are answered and exercises solved, 2/6 beside one with some. A browser that keeps nothing shows the lessons without it. */
'use strict';

const LessonProgress = (() => {
  const NAME = 'ros2-parameters-lessons';
  const page = path => decodeURIComponent(path.split('/').at(-1)).replace(/\.html$/, '') || 'index';
  const here = page(location.pathname);
  // Not localStorage: of pages on a disk, Chromium 156 loads about one in twenty with a localStorage that reads nothing and
  // keeps nothing (46 of 750 with no script of ours; over HTTP none of 80, and none of 350 with IndexedDB).
  const opened = open();
  const news = new BroadcastChannel(NAME);
  let lessons = {};
  let writes = 0;

  /** Give the database, or null where this browser has none for us. */
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
        if (typeof kept?.text === 'string' && lessons[name]) lessons[name][kept.isDone ? 'answers' : 'drafts'][number] = kept.text;
      }
    } catch { /* nothing can be read, or what is kept is not ours */ }
    show();
    dispatchEvent(new Event('lesson-progress'));
  }

  function entries(store) {
    return Promise.all([store.getAllKeys(), store.getAll()].map(request => new Promise((resolve, reject) => {
      request.onsuccess = () => resolve(request.result);
      request.onerror = reject;
    }))).then(([keys, values]) => keys.map((key, at) => [key, values[at]]));
  }

  /** Change what is kept; the page itself has changed already. */
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
    } catch { /* the page lives on without memory */ }
  }

  function keep(number, text, isDone = true) {
    const of = document.querySelectorAll('.rec-prediction, .rec-exercise').length;
    const {answers, drafts} = lessons[here] = {answers: {}, drafts: {}, ...lessons[here], of};
    delete drafts[number];
    (isDone ? answers : drafts)[number] = text;
    write((kept, sizes) => {
      kept.put({text, isDone}, [here, number]);
      sizes.put(of, here);
    });
  }

  /** Keep what was filled in; it counts as soon as it is right, and what was right once stays so. */
  function keepExercise(number, text, isDone) {
    if (isDone || answer(number) === undefined) keep(number, text, isDone);
  }

  function forget(number) {
    delete lessons[here]?.answers[number];
    write(kept => kept.delete([here, number]));
  }

  function forgetAll() {
    lessons = {};
    write((...stores) => stores.forEach(each => each.clear()));
  }

  function answer(number) {
    return lessons[here]?.answers[number];
  }

  function draft(number) {
    return lessons[here]?.drafts[number];
  }

  /** Put the marks beside the links to the lessons. */
  function show() {
    for (const link of document.querySelectorAll('.bd-docs-nav a, .front-lessons a')) {
      link.querySelector('.lesson-mark')?.remove();
      const {of, answers} = lessons[page(link.pathname)] || {};
      const count = Math.min(Object.keys(answers || {}).length, of);
      if (!count) continue;
      const mark = Object.assign(document.createElement('span'), {className: 'lesson-mark', title: `${count} of ${of} questions answered`});
      const sign = Object.assign(document.createElement('span'), {textContent: count === of ? '✓' : `${count}/${of}`});
      sign.setAttribute('aria-hidden', 'true');
      mark.append(sign, Object.assign(document.createElement('span'), {className: 'visually-hidden', textContent: ` (${mark.title})`}));
      if (count === of) mark.dataset.done = '';
      link.append(mark);
    }
    tell();
  }

  /** Say on the first page what is kept, and offer to forget it. */
  function tell() {
    const line = document.querySelector('.lesson-progress');
    if (!line) return;
    const count = Object.values(lessons).reduce((sum, {answers}) => sum + Object.keys(answers).length, 0);
    line.hidden = !count && Object.values(lessons).every(({drafts}) => !Object.keys(drafts).length);
    const button = Object.assign(document.createElement('button'), {type: 'button', textContent: 'Forget my answers'});
    button.addEventListener('click', forgetAll);
    line.replaceChildren(`You have answered ${count === 1 ? 'one question' : `${count} questions`}. This browser keeps the answers; nobody else gets them.`,
      button);
  }

  /** Show what is kept, from now on also what another window changes. */
  function begin() {
    news.addEventListener('message', load);
    // Some browsers don't let pages on a disk hear each other.
    document.addEventListener('visibilitychange', () => { if (!document.hidden) load(); });
    return load();
  }

  return {keep, keepExercise, forget, answer, draft, begin};
})();
