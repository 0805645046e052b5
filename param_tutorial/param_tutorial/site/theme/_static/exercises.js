/* The forms in which a reader answers an exercise. What is filled in is looked up among the answers that the exercise's
   check gave when the page was made; the script judges nothing itself. */
'use strict';

class RecordedExercise {
  constructor(form, facts) {
    Object.assign(this, {form, facts, number: form.dataset.number, list: form.querySelector('.rec-lines')});
    this.controls = [...form.querySelectorAll('.rec-field :is(input, select)')];
    this.verdict = form.querySelector('.rec-verdict');
    form.querySelector('fieldset').disabled = false;
    if (this.list) this.letMove();
    form.addEventListener('input', () => this.leave());
    form.addEventListener('submit', event => {
      event.preventDefault();
      this.check();
    });
    this.comeBack();
    // What is kept may not have been read yet, or comes from another window.
    addEventListener('lesson-progress', () => { if (!this.isTouched) this.comeBack(); });
  }

  /** What is filled in: a text for each blank, a number for each setting, or the lines' numbers in their order. */
  get answer() {
    if (this.list) return [...this.list.children].map(line => line.dataset.line);
    return this.controls.map(each => this.facts.form === 'settings' ? String(each.selectedIndex) : each.value.trim());
  }

  fill(answer) {
    if (this.list) this.list.append(...answer.map(number => this.list.querySelector(`[data-line="${number}"]`)));
    else if (this.facts.form === 'settings') this.controls.forEach((each, at) => { each.selectedIndex = answer[at]; });
    else this.controls.forEach((each, at) => { each.value = answer[at]; });
    this.markEnds();
  }

  /** Fill in what the browser has kept, and say what the check said to it. */
  comeBack() {
    let kept;
    try {
      kept = JSON.parse(LessonProgress.answer(this.number) ?? LessonProgress.draft(this.number) ?? 'null');
    } catch { /* it is not ours */ }
    // The exercise may have other lines or fields today.
    const now = this.answer;
    if (!Array.isArray(kept) || kept.length !== now.length || kept.some(each => typeof each !== 'string')) return;
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
    LessonProgress.keepExercise(this.number, JSON.stringify(answer), isDone);
  }

  /** Show what the check said to an answer, and return whether it was content. */
  show(answer) {
    const {facts} = this;
    const said = facts.form === 'blanks' ? answer.map((text, at) => this.findBlank(facts.fields[at], text))
      : facts.answers[answer.join('.')].map(number => facts.items[number]);
    const findings = said.filter(([word]) => word !== 'picture');
    const count = findings.filter(([word]) => word === 'done').length;
    const isDone = count === findings.length;
    const find = name => this.verdict.querySelector(name);
    find('.param-findings').innerHTML = findings.map(([, item]) => item).join('');
    find('.rec-picture').innerHTML = said.filter(([word]) => word === 'picture').map(([, picture]) => picture).join('');
    find('.rec-next').textContent = isDone ? 'A worked solution, to compare, stands below.' : 'Hints stand below.';
    this.verdict.hidden = false;
    find('.rec-score').innerHTML = `<b>Exercise ${this.number}: ${isDone ? 'done' : 'not yet'}</b>, ${count} of ${facts.total} done`;
    return isDone;
  }

  /** Give what the check said to one blank. */
  findBlank(field, typed) {
    const {facts} = this;
    const told = (name, words) => {
      const item = document.createElement('li');
      item.className = `param-${name.replace(' ', '-')}`;
      item.innerHTML = `<b>${name}</b> · <span></span><dl><dt>happened</dt><dd></dd></dl>`;
      item.querySelector('span').replaceChildren(...this.controls[facts.fields.indexOf(field)].labels[0].cloneNode(true).childNodes);
      item.querySelector('dd').textContent = words;
      return [name, item.outerHTML];
    };
    const given = facts.choices.length ? {text: typed} : facts.is_text ? {text: typed.replace(/\s+/g, ' ')} : PythonValue.read(typed);
    if (given === null) {
      return told('not yet', `“${typed}” is no Python value that this form knows. Words stand in quotes, as in 'old'.`);
    }
    let {text} = given;
    if (facts.word && given.type === 'str' && given.value.replace(/^[ .]+|[ .]+$/g, '').toLowerCase() === facts.word) text = `'${facts.word}'`;
    if (Object.hasOwn(field.answers, text)) return facts.items[field.answers[text]];
    if (given.type && Object.hasOwn(field.others, given.type)) {
      const [word, item] = facts.items[field.others[given.type]];
      const escaped = Object.assign(document.createElement('span'), {textContent: text}).innerHTML;
      return [word, item.replaceAll('{given}', () => escaped)];
    }
    return told('not tried', 'The check was not asked for this when the page was made. Run the notebook to try it.');
  }

  /** Let the arrows move the lines; the focus stays on the arrow. */
  letMove() {
    this.list.addEventListener('click', event => {
      const arrow = event.target.closest('button');
      if (!arrow) return;
      const line = arrow.closest('li');
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
    for (const arrow of this.list?.querySelectorAll('button') || []) {
      const line = arrow.closest('li');
      arrow.setAttribute('aria-disabled', !(arrow.dataset.by === '-1' ? line.previousElementSibling : line.nextElementSibling));
    }
  }
}

/** Reads what a Python value looks like, as far as the exercises have them. */
const PythonValue = {
  /** Give the value as Python shows it, and its type; null if it is none. */
  read(text) {
    text = text.trim();
    if (text === '' || text === '...') return {text: '', type: ''};
    if (['True', 'False'].includes(text)) return {text, type: 'bool'};
    if (text === 'None') return {text, type: 'NoneType'};
    if (/^[-+]?\d+(_\d+)*$/.test(text)) return /^[-+]?0+[1-9]/.test(text) ? null : {text: String(BigInt(text.replace(/[+_]/g, ''))), type: 'int'};
    if (/^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(text)) {
      const number = Number(text);
      const shown = Object.is(number, -0) ? '-0.0' : Number.isInteger(number) && Math.abs(number) < 1e16 ? number.toFixed(1) : String(number);
      return {text: shown, type: 'float'};
    }
    const quoted = /^(['"])((?:(?!\1|\\).)*)\1$/.exec(text);
    if (quoted) {
      const mark = quoted[2].includes("'") && !quoted[2].includes('"') ? '"' : "'";
      return {text: `${mark}${quoted[2]}${mark}`, type: 'str', value: quoted[2]};
    }
    const listed = /^\[(.*)\]$|^\((.*)\)$/s.exec(text);
    if (!listed) return null;
    const inner = (listed[1] ?? listed[2]).trim().replace(/,$/, '');
    const parts = inner === '' ? [] : inner.match(/(?:"[^"]*"|'[^']*'|[^,"'])+/g).map(part => PythonValue.read(part));
    return parts.some(part => !part || !part.type) ? null : {text: `[${parts.map(part => part.text).join(', ')}]`, type: 'list'};
  },
};
