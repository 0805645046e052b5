/* What makes a lesson's page answer: it looks up what the node said when the page was made. It works nothing out.

   A panel's controls hold the values that the node confirmed. A hand's change is looked up among the recorded answers;
   one that was rejected, or never asked for, springs back, with the reason beside the control. */
'use strict';

(() => {
  // A page on a disk may not fetch another one, which the search would do to quote it.
  if (location.protocol === 'file:' && typeof DOCUMENTATION_OPTIONS === 'object') {
    DOCUMENTATION_OPTIONS.SHOW_SEARCH_SUMMARY = false;
  }

  const panels = [];
  const robots = [];

  /** Give what stands packed beside a recorded view. */
  async function unpack(section) {
    const packed = Uint8Array.from(atob(section.querySelector('.rec-data').textContent), letter => letter.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
    return JSON.parse(await new Response(stream).text());
  }

  /** Give a name for a set of changed parameters, as the recorder does. */
  function key(changed) {
    return Object.keys(changed).sort().map(name => `${name}=${changed[name]}`).join('\n');
  }

  /** Say that something was not recorded for a set of changed parameters. */
  function unknown(what, changed) {
    const values = Object.entries(changed).map(([name, text]) => `${name} = ${text}`).join(', ');
    return `Not recorded: no ${what} with ${values}. Run the notebook to see it.`;
  }

  /** A panel whose answers were recorded. */
  class RecordedPanel {
    constructor(section, facts) {
      this.section = section;
      this.node = facts.node;
      this.films = new Map(facts.films.map(film => [key(film.changed), film]));
      this.pictures = new Map(facts.pictures.map(picture => [key(picture.changed), picture]));
      this.rows = new Map(facts.rows.map(row => [row.name, new RecordedRow(this, row)]));
      this.resetButton = section.querySelector('.rec-reset');
      this.resetButton.addEventListener('click', () => this.reset());
      this.shown = new ParameterPanel(section.querySelector('.param-panel'), {
        patience: '',
        enter: (name, entry) => this.enter(name, entry),
        bringBack: name => this.rows.get(name).ask(this.rows.get(name).shown),
      });
      this.draw();
    }

    /** What differs from the state in which the lesson shows the node. */
    get changed() {
      const changed = {};
      for (const row of this.rows.values()) if (row.text !== row.shown) changed[row.name] = row.text;
      return changed;
    }

    enter(name, entry) {
      const row = this.rows.get(name);
      row.ask('text' in entry ? entry.text : row.facts.positions[entry.position]);
      this.shown.answer(name, entry.number);
    }

    draw() {
      const rows = {};
      for (const row of this.rows.values()) rows[row.name] = row.state;
      this.shown.show({rows});
      this.resetButton.disabled = !Object.keys(this.changed).length;
    }

    /** Take over what the node did to its parameters. */
    take(texts) {
      for (const [name, text] of Object.entries(texts)) {
        const row = this.rows.get(name);
        if (row) row.text = text;
      }
      this.draw();
      for (const robot of robots) if (robot.belongsTo(this)) robot.follow(this);
      for (const view of document.querySelectorAll('.rec-steps')) if (view.dataset.node === this.node) this.picture(view);
    }

    /** Show the picture that belongs to the parameters, if there is one. */
    picture(view) {
      const picture = this.pictures.get(key(this.changed));
      if (picture) view.querySelector('.rec-picture').innerHTML = picture.look;
      view.querySelector('.rec-says').textContent = picture ? '' : unknown('picture', this.changed);
    }

    log(lines) {
      for (const view of document.querySelectorAll('.rec-log')) {
        if (!['all nodes', this.node].includes(view.dataset.node)) continue;
        const list = view.querySelector('pre');
        list.append(lines.map(line => `${line}\n`).join(''));
        list.scrollTop = list.scrollHeight;
      }
    }

    /** Put what the node told on /parameter_events into the tables, the newest on top. */
    tell(events) {
      for (const view of document.querySelectorAll('.rec-events')) {
        if (!['all nodes', this.node].includes(view.dataset.node)) continue;
        for (const event of events) {
          const line = view.querySelector('tbody').insertRow(0);
          for (const text of [this.node, ...event]) line.insertCell().textContent = text;
        }
      }
    }

    reset() {
      for (const row of this.rows.values()) { row.text = row.shown; row.message = null; }
      this.take({});
      this.section.querySelector('.param-row :is(input, textarea, select):enabled').focus();
    }
  }

  class RecordedRow {
    constructor(panel, facts) {
      Object.assign(this, {panel, name: facts.name, shown: facts.text, text: facts.text, facts, message: null});
    }

    /** How the panel shows it. */
    get state() {
      const state = {text: this.text, message: this.message};
      if (this.facts.positions) state.position = this.position(this.text);
      if (this.text !== this.shown) state.first = this.shown;
      return state;
    }

    position(text) {
      const exact = this.facts.positions.indexOf(text);
      if (exact >= 0) return exact;
      const distance = index => Math.abs(Number(this.facts.positions[index]) - Number(text));
      return this.facts.positions.reduce((best, _, index) => distance(index) < distance(best) ? index : best, 0);
    }

    /** Look up what the node said to a value, in the state in which the panel is. */
    ask(typed) {
      const [answer, because] = this.lookUp(typed);
      if (!answer) {
        this.message = ['unknown', because];
        this.panel.draw();
        return;
      }
      if ('reason' in answer) {
        this.message = ['rejected', answer.reason];
      } else {
        this.text = answer.value;
        const others = Object.keys(this.panel.changed).filter(name => name !== this.name);
        this.message = ['accepted', (this.same(typed, answer.value) ? ''
          : `The node has made it ${answer.value}. `)
          + (others.length && !this.inTheWay.length ? 'Recorded with the other values as first shown.' : '')];
      }
      this.panel.take(answer.also || {});
      this.tellLog(answer);
      this.panel.tell(answer.events || []);
    }

    same(typed, value) {
      return typed.trim() === value || (typed.trim() !== '' && Number(typed) === Number(value));
    }

    /** The parameters that have been changed, and on which the answer depends. */
    get inTheWay() {
      return (this.facts.depends || []).filter(name => this.panel.rows.get(name).text !== this.panel.rows.get(name).shown);
    }

    lookUp(typed) {
      const inTheWay = this.inTheWay;
      let answers = this.facts.answers;
      if (inTheWay.length) {
        const told = inTheWay.map(name => name === this.name ? 'the value that it has' : `${name}, which you have changed`);
        const [other] = inTheWay;
        answers = inTheWay.length === 1 && ((this.facts.contexts || {})[other] || {})[this.panel.rows.get(other).text];
        if (!answers) {
          return [null, `the node's answer depends on ${told.join(' and ')}. `
            + 'Go back to the start below, or run the notebook to try it.'];
        }
      }
      const text = Object.hasOwn(answers, typed) ? typed : Object.keys(answers).find(each => this.means(typed, each));
      if (text !== undefined) return [answers[text]];
      return [null, `the node was not asked for ${typed === '' ? 'an empty text' : `“${typed}”`} when this page was made. `
        + 'Run the notebook to try it.'];
    }

    /** Did a hand write a recorded value with other signs? 7.50 is 7.5, but 7 and 7.0 may differ in type. */
    means(typed, text) {
      const tidy = each => each.trim().replace(/^(-?\d+\.\d*?)0+$/, '$1');
      return /^\s*-?\d+\.\d+\s*$/.test(typed) ? tidy(typed) === tidy(text) : typed.trim() !== '' && typed.trim() === text;
    }

    tellLog(answer) {
      const elsewhere = Object.keys(this.panel.changed).some(name => name !== this.name);
      if (answer.log === null) return;
      if (this.facts.log_depends && elsewhere) {
        this.panel.log(['(not recorded: what the node logs with these values together)']);
      } else {
        this.panel.log(answer.log);
      }
    }
  }

  class Robot {
    constructor(section, facts, number) {
      Object.assign(this, {section, number, node: section.dataset.node, drives: 0, timers: []});
      this.films = new Map(facts.films.map(film => [key(film.changed), film]));
      this.changed = {};
      this.picture = section.querySelector('.rec-picture');
      this.status = section.querySelector('.rec-says');
      this.button = section.querySelector('.rec-drive');
      this.button.disabled = false;
      this.button.addEventListener('click', () => this.drive());
    }

    /** Is it the robot of a panel's node, and, if it has a panel beside it, of that one? */
    belongsTo(panel) {
      const beside = this.section.closest('.side-by-side');
      return this.node === panel.node && (!beside || !beside.querySelector('.rec-panel') || beside.contains(panel.section));
    }

    /** Go by the parameters of a panel from now on. */
    follow(panel) {
      this.films = panel.films;
      this.changed = panel.changed;
      const film = this.films.get(key(this.changed));
      if (this.timers.length) {
        this.status.textContent = 'The next drive will show the change.';
      } else if (film) {
        this.picture.innerHTML = film.look.picture;
        this.status.textContent = film.look.sentence;
      } else {
        this.status.textContent = unknown('drive', this.changed);
      }
    }

    drive() {
      const film = this.films.get(key(this.changed));
      this.timers.forEach(clearTimeout);
      this.timers = [];
      if (!film) {
        this.status.textContent = unknown('drive', this.changed);
        return;
      }
      this.drives += 1;
      const last = film.scenes.length - 1;
      const end = () => {
        this.timers = [];
        this.picture.innerHTML = film.end;
        this.status.textContent = film.scenes[last][3];
      };
      if (matchMedia('(prefers-reduced-motion: reduce)').matches) {
        end();
        this.status.textContent = film.scenes.map(scene => scene[3]).join(' ');
        return;
      }
      this.picture.innerHTML = film.picture.replaceAll('robot-NAME', `robot-${this.number}-${this.drives}`);
      film.scenes.forEach(([at, word, text, sentence], index) => {
        this.timers.push(setTimeout(() => {
          if (index === last) { end(); return; }
          this.picture.querySelector('.robot-word').textContent = word;
          this.picture.querySelector('.robot-scene').setAttribute('aria-label', text);
          this.status.textContent = sentence;
        }, 1000 * at));
      });
    }
  }

  /** Let a prediction be committed: it is locked then, and the page says what became of it. */
  async function ask(form) {
    const facts = await unpack(form);
    const button = form.querySelector('.rec-commit');
    const given = () => (new FormData(form).get('answer') || '').trim();
    form.addEventListener('input', () => { button.disabled = !given(); });
    form.addEventListener('submit', event => {
      event.preventDefault();
      const answer = given();
      if (!answer) return;
      const number = Number(answer);
      const plain = Number.isNaN(number) ? answer.toLowerCase() : String(number);
      form.querySelector('.rec-says').innerHTML = facts.choices[plain] || facts.otherwise;
      form.querySelector('fieldset').disabled = true;
      button.hidden = true;
    });
  }

  async function begin() {
    for (const form of document.querySelectorAll('.rec-prediction')) await ask(form);
    const views = [...document.querySelectorAll('.rec-robot')];
    for (const [number, section] of views.entries()) robots.push(new Robot(section, await unpack(section), number));
    for (const section of document.querySelectorAll('.rec-panel')) {
      const panel = new RecordedPanel(section, await unpack(section));
      panels.push(panel);
      for (const robot of robots) {
        // The first panel of a node speaks for its robot, until a hand moves another one.
        if (robot.belongsTo(panel) && robot.films.size === 1) robot.films = panel.films.size ? panel.films : robot.films;
      }
    }
    // The first page begins with a drive, if nothing else is wanted.
    const [first] = robots;
    if (first && first.section.closest('.front-robot') && !matchMedia('(prefers-reduced-motion: reduce)').matches) first.drive();
    document.documentElement.dataset.lesson = 'ready';
  }

  if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', begin); else begin();
})();
