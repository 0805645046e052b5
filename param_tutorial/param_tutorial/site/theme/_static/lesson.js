/* What makes a lesson's page answer: it looks up what the node said when the page was made. It works nothing out.

   A panel's controls hold the values that the node confirmed. A hand's change is looked up among the recorded answers;
   one that was rejected, or never asked for, springs back, with the reason beside the control. */
'use strict';

(() => {
  const panels = [];
  const robots = [];
  // A link to settings: this, the id of a panel, a question mark, and what was typed by the names of the parameters.
  const LINK = '#set-';
  // Who drags a slider wants to see what comes of the last value.
  const HAND_RESTS_MS = 200;

  /** Give what stands packed in a script of the page. */
  async function unpack(script) {
    const packed = Uint8Array.from(atob(script.textContent), letter => letter.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
    return JSON.parse(await new Response(stream).text());
  }

  /** Pictures or films by the keys of the parameters with which they were taken; unpacked when they are first needed. */
  class Album {
    constructor(script) { this.script = script; }

    async find(key) {
      this.content ||= unpack(this.script);
      const {parts, pictures} = await this.content;
      const whole = each => Array.isArray(each) ? each.map(whole)
        : !each || typeof each !== 'object' ? each
        : '$' in each ? each.$.map(number => parts[number]).join('') : Object.fromEntries(Object.entries(each).map(([name, part]) => [name, whole(part)]));
      return Object.hasOwn(pictures, key) ? whole(pictures[key]) : null;
    }
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
      this.names = facts.names;
      const album = (selector, root) => { const found = root.querySelector(selector); return found && new Album(found); };
      this.looks = album('.rec-looks', section);
      [this.films, this.turns] = [facts.films, facts.turns].map(name => album(`.rec-album[data-album="${name}"]`, document));
      this.turnMs = 1000 * facts.turn_sec;
      this.rows = new Map(facts.rows.map(row => [row.name, new RecordedRow(this, row)]));
      // What was typed to come to this state, in order.
      this.entered = new Map();
      this.resetButton = section.querySelector('.rec-reset');
      this.resetButton.addEventListener('click', () => this.reset());
      this.linkButton = section.querySelector('.rec-link');
      this.linkButton.addEventListener('click', () => this.copyLink());
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

    /** The name under which an album has the state of the panel; null if another parameter than those in it has changed. */
    get pictured() {
      if (Object.keys(this.changed).some(name => !this.names.includes(name))) return null;
      return key(Object.fromEntries(this.names.map(name => [name, this.rows.get(name).text])));
    }

    async find(album) {
      return album && this.pictured !== null ? album.find(this.pictured) : null;
    }

    /** Give the drive with which the panel begins. */
    async findFirst() {
      return this.films && this.films.find(key(Object.fromEntries(this.names.map(name => [name, this.rows.get(name).shown]))));
    }

    /** Give what follows if what has changed is changed at a moment of that drive. */
    async findTurn(moment) {
      return this.turns && Object.keys(this.changed).length === 1 ? this.turns.find(`${key(this.changed)}\n${moment}`) : null;
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
      this.resetButton.disabled = this.linkButton.disabled = !Object.keys(this.changed).length;
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

    /** Show the picture that belongs to the parameters; one of others is dimmed. */
    async picture(view) {
      const wanted = key(this.changed);
      const look = await this.find(this.looks);
      if (wanted !== key(this.changed)) return;
      if (look) view.querySelector('.rec-picture').innerHTML = look;
      view.classList.toggle('rec-stale', !look);
      view.querySelector('.rec-says').textContent = look ? '' : unknown('picture', this.changed);
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

    goBack() {
      for (const row of this.rows.values()) { row.text = row.shown; row.message = null; }
      this.entered.clear();
      this.say('');
      this.take({});
    }

    reset() {
      this.goBack();
      this.section.querySelector('.param-row :is(input, textarea, select):enabled').focus();
    }

    say(text) {
      this.section.querySelector('.rec-from-link').textContent = text;
    }

    async copyLink() {
      const address = `${location.href.split('#')[0]}${LINK}${this.section.id}?${new URLSearchParams([...this.entered])}`;
      this.say(await copy(address) ? 'The link is copied. It brings these settings back.' : `The link: ${address}`);
    }

    /** Do again what a link says was typed; all of it or, with a sentence, nothing. */
    followLink(entries) {
      this.goBack();
      let waiting = entries;
      // What one value needs, another one of the link may bring.
      for (let before = Infinity; waiting.length && waiting.length < before;) {
        before = waiting.length;
        waiting = waiting.filter(([name, text]) => !this.rows.get(name)?.ask(text));
      }
      if (waiting.length || !entries.length) {
        this.goBack();
        const told = waiting.map(([name, text]) => `${name} = ${text}`).join(', ') || 'nothing';
        this.say(`The link that brought you here asks for ${told}, which this panel has not recorded as accepted. It was ignored.`);
      } else {
        this.say('These settings come from the link that brought you here.');
      }
      this.section.scrollIntoView({block: 'center'});
    }
  }

  class RecordedRow {
    constructor(panel, facts) {
      Object.assign(this, {panel, name: facts.name, shown: facts.text, text: facts.text, facts, message: null});
      const words = Object.keys(facts.answers || {}).filter(text => text.trim() && !/^[-+.\d]/.test(text) && 'value' in facts.answers[text]);
      if (!facts.positions && facts.editor === 'text' && words.length > 3) this.suggest(words);
    }

    /** Let the box suggest what was recorded. */
    suggest(words) {
      const list = document.createElement('datalist');
      list.id = `${this.panel.section.id}-words-${this.panel.section.querySelectorAll('datalist').length}`;
      list.append(...words.map(word => Object.assign(document.createElement('option'), {value: word})));
      const row = [...this.panel.section.querySelectorAll('.param-row')].find(each => each.dataset.name === this.name);
      this.panel.section.append(list);
      row.querySelector('.param-box').setAttribute('list', list.id);
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

    /** Look up what the node said to a value, in the state in which the panel is.

       @return True if it accepted the value. */
    ask(typed) {
      const [answer, because] = this.lookUp(typed);
      if (!answer) {
        this.message = ['unknown', because];
        this.panel.draw();
        return false;
      }
      this.panel.say('');
      if ('reason' in answer) {
        this.message = ['rejected', answer.reason];
      } else {
        this.text = answer.value;
        this.panel.entered.delete(this.name);
        this.panel.entered.set(this.name, typed);
        const others = Object.keys(this.panel.changed).filter(name => name !== this.name);
        this.message = ['accepted', (this.same(typed, answer.value) ? ''
          : `The node has made it ${answer.value}. `)
          + (others.length && !this.inTheWay.length ? 'Recorded with the other values as first shown.' : '')];
      }
      this.panel.take(answer.also || {});
      this.tellLog(answer);
      this.panel.tell(answer.events || []);
      return 'value' in answer;
    }

    same(typed, value) {
      return typed === value || this.facts.readings[typed] === value;
    }

    /** The parameters that have been changed, and on which the answer depends. */
    get inTheWay() {
      return (this.facts.depends || []).filter(name => this.panel.rows.get(name).text !== this.panel.rows.get(name).shown);
    }

    lookUp(typed) {
      const inTheWay = this.inTheWay;
      let answers = this.facts.answers;
      if (inTheWay.length) {
        const state = key(Object.fromEntries(inTheWay.map(name => [name, this.panel.rows.get(name).text])));
        answers = (this.facts.contexts || {})[state];
        if (!answers) {
          const told = inTheWay.map(name => name === this.name ? 'the value that it has' : `${name}, which you have changed`);
          return [null, `the node's answer depends on ${told.join(' and ')}. `
            + 'Go back to the start below, or run the notebook to try it.'];
        }
      }
      const {readings} = this.facts;
      const text = [typed, Object.hasOwn(readings, typed) ? readings[typed] : typed].find(each => Object.hasOwn(answers, each));
      if (text !== undefined) return [answers[text]];
      return [null, `the node was not asked for ${typed === '' ? 'an empty text' : `“${typed}”`} when this page was made. `
        + 'Run the notebook to try it.'];
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

  /** A robot whose drives were recorded. */
  class RecordedRobot {
    constructor(section, facts) {
      Object.assign(this, {section, node: section.dataset.node, timers: [], panel: null, film: null});
      [this.first] = facts.films;
      this.shown = new DrivingPicture(section, () => this.drive());
      this.shown.button.disabled = false;
    }

    /** Is it the robot of a panel's node, and, if it has a panel beside it, of that one? */
    belongsTo(panel) {
      const beside = this.section.closest('.side-by-side');
      return this.node === panel.node && (!beside || !beside.querySelector('.rec-panel') || beside.contains(panel.section));
    }

    /** Go by the parameters of a panel from now on. */
    async follow(panel) {
      this.panel = panel;
      const wanted = key(panel.changed);
      const look = await panel.find(panel.looks);
      if (wanted !== key(panel.changed)) return;
      this.section.classList.toggle('rec-stale', !look);
      if (!look) {
        this.stop();
        this.shown.say(unknown('drive', panel.changed));
      } else if (this.timers.length) {
        this.turn();
      } else if (this.waits) {
        this.drive();
      } else {
        this.shown.draw(look.picture);
        this.shown.tell(look.scene);
      }
    }

    /** End a drive, also before its time: the picture stands as it does in the end. */
    stop() {
      if (!this.timers.length) return;
      this.timers.forEach(clearTimeout);
      this.timers = [];
      this.shown.draw(this.film.end);
      this.shown.tell(this.film.scenes.at(-1));
    }

    /** Return the drive with the parameters as they are, also if they change while it is being unpacked. */
    async findFilm() {
      for (;;) {
        const wanted = this.panel ? key(this.panel.changed) : '';
        const film = wanted ? await this.panel.find(this.panel.films) : this.first;
        if (!this.panel || wanted === key(this.panel.changed)) return film;
      }
    }

    /** Let a change take effect on the way: at the next moment at which one was recorded, as soon as the hand rests. */
    async turn() {
      const {film, begun, panel} = this;
      this.changedAt = performance.now();
      if (this.turning === begun) return;
      this.turning = begun;
      let moment;
      do {
        moment = Math.floor((performance.now() - begun) / panel.turnMs) + 1;
        await new Promise(done => setTimeout(done, begun + moment * panel.turnMs - performance.now()));
      } while (performance.now() - this.changedAt < HAND_RESTS_MS);
      const first = await panel.findFirst();
      const isFirst = first && JSON.stringify(first.scenes) === JSON.stringify(film.scenes);
      const next = isFirst ? await panel.findTurn(moment) : null;
      if (this.begun !== begun || !this.timers.length) return;
      this.turning = null;
      if (isFirst && !Object.keys(panel.changed).length) return;
      if (next) this.play(next); else this.shown.say('The next drive will show the change.');
    }

    async drive() {
      const film = await this.findFilm();
      this.stop();
      this.section.classList.toggle('rec-stale', !film);
      if (film) this.play(film); else this.shown.say(unknown('drive', this.panel.changed));
    }

    play(film) {
      this.timers.forEach(clearTimeout);
      this.film = film;
      this.begun = performance.now();
      // A robot that has not left the start pulls away as soon as it may.
      this.waits = film.scenes.length === 1 && film.scenes[0][1] === 'WAITING';
      this.shown.draw(film.picture);
      const [now, ...later] = film.scenes;
      this.shown.tell(now);
      const last = later.pop();
      this.timers = later.map(scene => setTimeout(() => this.shown.tell(scene), 1000 * scene[0]));
      if (last) this.timers.push(setTimeout(() => this.stop(), 1000 * last[0]));
    }
  }

  // For each prediction what is folded below it, and the button that shows it.
  const folds = new Map();

  /** Hide what gives the answer to a prediction away, up to the next cell, until it is committed to or the reader looks.

     Only the screen hides it: see the style sheet. Called while the page is being loaded, so that nothing is drawn that
     goes away again: what has come by then is folded. */
  function foldAnswer(form) {
    const answer = [];
    for (let each = form.closest('div.cell').nextElementSibling; each && !each.matches('section, h2, h3');
      each = each.nextElementSibling) {
      if (document.readyState === 'loading' && !each.nextSibling) break; // it may have come in part
      const isCell = each.matches('div.cell');
      if (isCell && (answer.some(part => !part.matches('.cell_output')) || each.querySelector('.rec-prediction'))) break;
      if (!isCell) answer.push(each);
      else answer.push(...each.querySelectorAll(':scope > .cell_output'));
    }
    const [first] = answer;
    if (!first?.matches('.cell_output')) return;
    const fold = folds.get(form) || offerLook(form, first);
    for (const each of answer) if (!fold.answer.has(each)) {
      fold.answer.add(each);
      each.classList.toggle('lesson-folded', !fold.isShown());
    }
  }

  /** Put the button that shows an answer before it. */
  function offerLook(form, first) {
    const line = Object.assign(document.createElement('p'), {className: 'lesson-look'});
    const button = Object.assign(document.createElement('button'), {type: 'button', textContent: 'Commit to an answer, or look'});
    button.setAttribute('aria-label', `${button.textContent} at that of question ${form.dataset.number}`);
    line.append(button);
    first.before(line);
    const fold = {answer: new Set(), isShown: () => button.getAttribute('aria-expanded') === 'true'};
    const show = isShown => {
      button.setAttribute('aria-expanded', isShown);
      for (const each of fold.answer) {
        each.classList.toggle('lesson-folded', !isShown);
        // What was hidden had no size when the theme's script let the keyboard scroll what is too wide.
        for (const box of [each, ...each.querySelectorAll('*')].filter(one => one.matches('[tabindex="-1"]'))) {
          if (box.scrollWidth > box.clientWidth || box.scrollHeight > box.clientHeight) box.tabIndex = 0;
        }
      }
    };
    button.addEventListener('click', () => show(!fold.isShown()));
    form.addEventListener('lesson-committed', () => { show(true); line.hidden = true; });
    show(false);
    folds.set(form, fold);
    return fold;
  }

  function foldAnswers() {
    document.querySelectorAll('.rec-prediction[data-decided]').forEach(foldAnswer);
  }

  /** Let a prediction be committed: it is locked then, and the page says what became of it. The browser keeps it. */
  function ask(form, facts) {
    const button = form.querySelector('.rec-commit');
    const again = form.querySelector('.rec-again');
    const given = () => (new FormData(form).get('answer') || '').trim();
    const lock = answer => {
      const number = Number(answer);
      const plain = Number.isNaN(number) ? answer.toLowerCase() : String(number);
      const verdict = Object.hasOwn(facts.choices, plain) ? facts.choices[plain] : facts.otherwise;
      form.querySelector('.rec-says').innerHTML = verdict;
      form.querySelector('fieldset').disabled = Boolean(verdict);
      button.hidden = Boolean(verdict);
      again.hidden = !verdict;
      if (verdict) form.dispatchEvent(new Event('lesson-committed'));
      return verdict;
    };
    form.addEventListener('input', () => { button.disabled = !given(); });
    form.addEventListener('submit', event => {
      event.preventDefault();
      const answer = given();
      if (answer && lock(answer)) LessonProgress.keep(form.dataset.number, answer);
    });
    again.addEventListener('click', () => {
      LessonProgress.forget(form.dataset.number);
      form.querySelector('fieldset').disabled = false;
      form.reset();
      form.querySelector('.rec-says').textContent = '';
      again.hidden = true;
      button.hidden = false;
      button.disabled = true;
      form.querySelector('input').focus();
    });
    const comeBack = () => {
      const kept = LessonProgress.answer(form.dataset.number);
      if (kept === undefined || !again.hidden) return;
      const boxes = [...form.querySelectorAll('input')];
      const box = boxes.find(each => each.type === 'text' || each.value === kept);
      // The question may have other choices today.
      if (!box || !lock(kept)) return;
      if (box.type === 'text') box.value = kept; else box.checked = true;
    };
    comeBack();
    // What is kept may not have been read yet, or comes from another window.
    addEventListener('lesson-progress', comeBack);
  }

  /** Bring one view to life; where that fails, it says so, and the others live on. */
  async function enliven(section, live) {
    try {
      live(await unpack(section.querySelector('.rec-data')));
    } catch (error) {
      const note = document.createElement('p');
      note.className = 'rec-note rec-dead';
      note.setAttribute('role', 'status');
      note.textContent = typeof DecompressionStream === 'undefined'
        ? 'This browser is too old to unpack the recordings, so the controls do not answer: it has no DecompressionStream.'
        : 'The recording of this view is damaged, so its controls do not answer. Load the page again.';
      section.append(note);
      for (const control of section.querySelectorAll('input, textarea, select, button')) control.disabled = true;
      console.warn(error);
    }
  }

  /** Put a button beside each cell's code that copies it. */
  function offerCopies() {
    for (const cell of document.querySelectorAll('div.cell_input')) {
      const code = cell.querySelector('pre').textContent.trimEnd();
      const button = Object.assign(document.createElement('button'), {type: 'button', className: 'lesson-copy', textContent: 'Copy'});
      button.setAttribute('aria-label', 'Copy the code of this cell');
      button.addEventListener('click', async () => {
        button.dataset.said = await copy(code) ? 'Copied' : 'Not copied';
        button.textContent = button.dataset.said;
        setTimeout(() => { button.textContent = 'Copy'; delete button.dataset.said; }, 2000);
      });
      cell.append(button);
    }
  }

  /** Copy a text; a page on a disk may not use the clipboard's newer way in every browser. */
  async function copy(text) {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      const area = Object.assign(document.createElement('textarea'), {value: text});
      document.body.append(area);
      area.select();
      const done = document.execCommand('copy');
      area.remove();
      return done;
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
    const note = document.querySelector('.lesson-no-link') || Object.assign(document.createElement('p'), {className: 'lesson-download lesson-no-link'});
    note.setAttribute('role', 'status');
    note.textContent = 'The link that brought you here asks for settings of a panel that is not on this page. It was ignored.';
    document.querySelector('.bd-article h1').after(note);
    scrollTo(0, 0);
  }

  async function begin() {
    arriving.disconnect();
    foldAnswers();
    offerCopies();
    const remembered = LessonProgress.begin();
    for (const form of document.querySelectorAll('.rec-prediction')) await enliven(form, facts => ask(form, facts));
    for (const form of document.querySelectorAll('.rec-exercise')) await enliven(form, facts => new RecordedExercise(form, facts));
    for (const section of document.querySelectorAll('.rec-robot')) {
      await enliven(section, facts => robots.push(new RecordedRobot(section, facts)));
    }
    for (const section of document.querySelectorAll('.rec-panel')) {
      await enliven(section, facts => panels.push(new RecordedPanel(section, facts)));
    }
    followLink();
    addEventListener('hashchange', followLink);
    // The first page begins with a drive, if nothing else is wanted.
    const [first] = robots;
    if (first && first.section.closest('.front-robot') && !matchMedia('(prefers-reduced-motion: reduce)').matches) first.drive();
    await remembered;
    document.documentElement.dataset.lesson = 'ready';
  }

  const arriving = new MutationObserver(foldAnswers);
  arriving.observe(document, {childList: true, subtree: true});
  if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', begin); else begin();
})();
