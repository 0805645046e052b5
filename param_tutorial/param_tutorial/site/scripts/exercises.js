/* The forms in which a reader answers an exercise. What is filled in is looked up among the answers that the exercise's
   check gave when the page was made; the script judges nothing itself. */

import {all, make, one} from '../../../param_tools/panel/dom.js';
import {answerTo, draftOf, keepExercise} from './progress.js';
import {readPythonValue} from './python_value.js';

/**
 * What the check said to a requirement: a word such as 'done', and the finding as HTML.
 * @typedef {[word: string, item: string]} Finding
 *
 * What it said to the answers that were tried in a blank, as numbers of findings: by the value as Python shows it, and by
 * the type of any other.
 * @typedef {{answers: Record<string, number>, others: Record<string, number>}} Field
 *
 * All that it said; `answers` is for what is no blank, by the whole answer. See `pages/forms.py`.
 * @typedef {{form: 'blanks' | 'settings' | 'order', total: number, items: Finding[], answers: Record<string, number[]>,
 *   fields: Field[], choices: string[], is_text: boolean, word?: string}} Facts
 */

export class RecordedExercise {
  isTouched = false;

  /**
   * @param {HTMLElement} form
   * @param {Facts} facts
   */
  constructor(form, facts) {
    this.facts = facts;
    this.number = form.dataset.number ?? '';
    this.list = /** @type {HTMLElement | null} */ (form.querySelector('.rec-lines'));
    this.controls = /** @type {(HTMLInputElement | HTMLSelectElement)[]} */ (
      all(form, '.rec-field :is(input, select)')
    );
    this.verdict = one(form, '.rec-verdict');
    one(form, 'fieldset', HTMLFieldSetElement).disabled = false;
    if (this.list) this.letMove(this.list);
    form.addEventListener('input', () => this.leave());
    form.addEventListener('submit', event => {
      event.preventDefault();
      this.check();
    });
    this.comeBack();
    // What is kept may not have been read yet, or comes from another window.
    addEventListener('lesson-progress', () => {
      if (!this.isTouched) this.comeBack();
    });
  }

  /** The lines to put in order. */
  get lines() {
    return this.list ? all(this.list, ':scope > *') : [];
  }

  /** What is filled in: a text for each blank, a number for each setting, or the lines' numbers in their order. */
  get answer() {
    if (this.list) return this.lines.map(line => line.dataset.line ?? '');
    return this.controls.map(each =>
      each instanceof HTMLSelectElement && this.facts.form === 'settings'
        ? String(each.selectedIndex)
        : each.value.trim(),
    );
  }

  /** @param {string[]} answer */
  fill(answer) {
    if (this.list) {
      const lines = new Map(this.lines.map(line => [line.dataset.line, line]));
      this.list.append(...answer.map(number => lines.get(number) ?? ''));
      this.markEnds();
    }
    this.controls.forEach((each, at) => {
      if (each instanceof HTMLSelectElement && this.facts.form === 'settings') each.selectedIndex = Number(answer[at]);
      else each.value = answer[at];
    });
  }

  /** Fill in what the browser has kept, and say what the check said to it. */
  comeBack() {
    let kept;
    try {
      kept = JSON.parse(answerTo(this.number) ?? draftOf(this.number) ?? 'null');
    } catch {
      // It is not ours.
    }
    // The exercise may have other lines or fields today.
    if (!Array.isArray(kept) || kept.length !== this.answer.length) return;
    if (kept.some(each => typeof each !== 'string')) return;
    if (this.facts.answers && !Object.hasOwn(this.facts.answers, kept.join('.'))) return;
    this.fill(kept);
    this.show(kept);
  }

  /** Leave what was said: it is about other answers. */
  leave() {
    this.isTouched = true;
    this.verdict.hidden = true;
  }

  check() {
    const answer = this.answer;
    const isDone = this.show(answer);
    keepExercise(this.number, JSON.stringify(answer), isDone);
  }

  /**
   * Show what the check said to an answer, and return whether it was content.
   * @param {string[]} answer
   */
  show(answer) {
    const {facts} = this;
    const said =
      facts.form === 'blanks'
        ? answer.map((text, at) => this.findBlank(at, text))
        : facts.answers[answer.join('.')].map(number => facts.items[number]);
    const findings = said.filter(([word]) => word !== 'picture');
    const pictures = said.filter(([word]) => word === 'picture');
    const count = findings.filter(([word]) => word === 'done').length;
    const isDone = count === findings.length;
    const text = (/** @type {Finding[]} */ parts) => parts.map(([, item]) => item).join('');
    one(this.verdict, '.param-findings').innerHTML = text(findings);
    one(this.verdict, '.rec-picture').innerHTML = text(pictures);
    one(this.verdict, '.rec-next').textContent = isDone
      ? 'A worked solution, to compare, stands below.'
      : 'Hints stand below.';
    this.verdict.hidden = false;
    const title = make('b', {}, `Exercise ${this.number}: ${isDone ? 'done' : 'not yet'}`);
    one(this.verdict, '.rec-score').replaceChildren(title, `, ${count} of ${facts.total} done`);
    return isDone;
  }

  /**
   * Return what the check said to one blank.
   * @param {number} at
   * @param {string} typed
   * @returns {Finding}
   */
  findBlank(at, typed) {
    const {facts} = this;
    const field = facts.fields[at];
    const given = this.read(typed);
    if (!given) {
      const reason = `“${typed}” is no Python value that this form knows. Words stand in quotes, as in 'old'.`;
      return this.tell(at, 'not yet', reason);
    }
    let {text} = given;
    if (facts.word && given.value?.replace(/^[ .]+|[ .]+$/g, '').toLowerCase() === facts.word) text = `'${facts.word}'`;
    if (Object.hasOwn(field.answers, text)) return facts.items[field.answers[text]];
    if (given.type && Object.hasOwn(field.others, given.type)) {
      const [word, item] = facts.items[field.others[given.type]];
      const escaped = make('span', {}, text).innerHTML;
      return [word, item.replaceAll('{given}', () => escaped)];
    }
    const reason = 'The check was not asked for this when the page was made. Run the notebook to try it.';
    return this.tell(at, 'not tried', reason);
  }

  /**
   * Return what is typed in a blank as the check's answers name it; null if it is no value.
   * @param {string} typed
   * @returns {{text: string, type?: string, value?: string} | null}
   */
  read(typed) {
    if (this.facts.choices.length) return {text: typed};
    return this.facts.is_text ? {text: typed.replace(/\s+/g, ' ')} : readPythonValue(typed);
  }

  /**
   * Return the script's own finding about a blank.
   * @param {number} at
   * @param {string} word
   * @param {string} reason
   * @returns {Finding}
   */
  tell(at, word, reason) {
    const question = make('span');
    question.append(...(this.controls[at].labels?.[0].cloneNode(true).childNodes ?? []));
    const happened = make('dl', {}, make('dt', {}, 'happened'), make('dd', {}, reason));
    const className = `param-${word.replace(' ', '-')}`;
    return [word, make('li', {className}, make('b', {}, word), ' · ', question, happened).outerHTML];
  }

  /**
   * Let the arrows move the lines; the focus stays on the arrow.
   * @param {HTMLElement} list
   */
  letMove(list) {
    list.addEventListener('click', event => {
      const arrow = /** @type {Element} */ (event.target).closest('button');
      const line = arrow?.closest('li');
      if (!arrow || !line) return;
      if (arrow.dataset.by === '-1') line.previousElementSibling?.before(line);
      else line.nextElementSibling?.after(line);
      arrow.focus();
      this.markEnds();
      this.leave();
    });
    this.markEnds();
  }

  /** The first line can't move up, nor the last one down; a button that is disabled would lose the focus. */
  markEnds() {
    for (const line of this.lines) {
      for (const arrow of all(line, 'button')) {
        const beyond = arrow.dataset.by === '-1' ? line.previousElementSibling : line.nextElementSibling;
        arrow.setAttribute('aria-disabled', String(!beyond));
      }
    }
  }
}
