/* What a reader has predicted and solved, kept in the browser, and the marks that show it: ✓ beside a lesson all of whose
   questions are answered and exercises solved, 2/6 beside one with some. A browser that keeps nothing shows the lessons without it. */
'use strict';

const LessonProgress = (() => {
  const NAME = 'ros2-parameters-lessons';
  const page = path => decodeURIComponent(path.split('/').at(-1)).replace(/\.html$/, '') || 'index';
  const here = page(location.pathname);

  /** Give for each lesson how many questions and exercises it has, what was answered by their numbers, and what was
     filled in for exercises that are not solved. */
  function load() {
    const lessons = {};
    try {
      for (const [name, {of, answers, drafts = {}}] of Object.entries(JSON.parse(localStorage.getItem(NAME)) || {})) {
        const texts = [...Object.values(answers), ...Object.values(drafts)];
        if (Number.isInteger(of) && texts.every(each => typeof each === 'string')) lessons[name] = {of, answers, drafts};
      }
    } catch { /* nothing is kept, or what is kept is no longer readable */ }
    return lessons;
  }

  function change(how) {
    const lessons = load();
    how(lessons);
    try {
      localStorage.setItem(NAME, JSON.stringify(lessons));
    } catch { /* the page lives on without memory */ }
    show(lessons);
  }

  function keep(number, answer) {
    change(lessons => { lesson(lessons).answers[number] = answer; });
  }

  /** Keep what was filled in; it counts as soon as it is right, and what was right once stays so. */
  function keepExercise(number, answer, isDone) {
    change(lessons => {
      const {answers, drafts} = lesson(lessons);
      if (isDone || number in answers) delete drafts[number];
      if (isDone) answers[number] = answer;
      else if (!(number in answers)) drafts[number] = answer;
    });
  }

  function lesson(lessons) {
    const of = document.querySelectorAll('.rec-prediction, .rec-exercise').length;
    return lessons[here] = {answers: {}, drafts: {}, ...lessons[here], of};
  }

  function forget(number) {
    change(lessons => {
      if (lessons[here]) delete lessons[here].answers[number];
    });
  }

  function answer(number) {
    return load()[here]?.answers[number];
  }

  function draft(number) {
    return load()[here]?.drafts[number];
  }

  /** Put the marks beside the links to the lessons. */
  function show(lessons) {
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
    tell(lessons);
  }

  /** Say on the first page what is kept, and offer to forget it. */
  function tell(lessons) {
    const line = document.querySelector('.lesson-progress');
    if (!line) return;
    const count = Object.values(lessons).reduce((sum, {answers}) => sum + Object.keys(answers).length, 0);
    line.hidden = !count && Object.values(lessons).every(({drafts}) => !Object.keys(drafts).length);
    const button = Object.assign(document.createElement('button'), {type: 'button', textContent: 'Forget my answers'});
    button.addEventListener('click', () => change(kept => { for (const name of Object.keys(kept)) delete kept[name]; }));
    line.replaceChildren(`You have answered ${count === 1 ? 'one question' : `${count} questions`}. This browser keeps the answers; nobody else gets them.`,
      button);
  }

  function begin() {
    show(load());
    // Another lesson may be open beside this one.
    addEventListener('storage', () => show(load()));
  }

  return {keep, keepExercise, forget, answer, draft, begin};
})();
