/* What a lesson's page answers with: what the node said when the page was made. It works nothing out.

   A panel's controls hold the values that the node confirmed. A hand's change is looked up among the recorded answers;
   one that was rejected, or never asked for, springs back, with the reason beside the control. */

import {all, make, one} from '../../../param_tools/panel/dom.js';
import {ParameterPanel} from '../../../param_tools/panel/panel.js';
import {DrivingPicture} from '../../views/driving.js';
import {copy} from './clipboard.js';
import {Album, key, unknown} from './recordings.js';

/**
 * @import {Scene} from '../../views/driving.js'
 * @import {Entry, RowState} from '../../../param_tools/panel/panel.js'
 *
 * What the node said to one text; see `recording/recorded.py`, which also describes the facts of a row.
 * @typedef {{value?: string, reason?: string, also?: Record<string, string>, log: string[] | null,
 *   events?: string[][]}} Answer
 *
 * @typedef {{name: string, text: string, editor: string, positions?: string[], answers?: Record<string, Answer>,
 *   readings: Record<string, string>, depends?: string[], contexts?: Record<string, Record<string, Answer>>,
 *   log_depends?: boolean}} RowFacts
 *
 * The names are those on which pictures and drives depend; `films` and `turns` name the albums of these.
 * @typedef {{node: string, rows: RowFacts[], names: string[], films: string, turns: string, turn_sec: number}} PanelFacts
 *
 * A drive: what moves, what stands in the end, and what to tell on the way.
 * @typedef {{picture: string, end: string, scenes: Scene[]}} Film
 */

/** @type {RecordedPanel[]} */
export const panels = [];
/** @type {RecordedRobot[]} */
export const robots = [];
// A link to settings: this, the id of a panel, a question mark, and what was typed by the names of the parameters.
export const LINK = '#set-';
// Who drags a slider wants to see what comes of the last value.
const HAND_RESTS_MS = 200;

/**
 * @param {ParentNode} root
 * @param {string} selector
 */
function albumIn(root, selector) {
  const found = root.querySelector(selector);
  return found && new Album(found.textContent ?? '');
}

/** A panel whose answers were recorded. */
export class RecordedPanel {
  /** What was typed to come to this state, in order. @type {Map<string, string>} */
  entered = new Map();

  /**
   * @param {HTMLElement} section
   * @param {PanelFacts} facts
   */
  constructor(section, facts) {
    this.section = section;
    this.node = facts.node;
    this.names = facts.names;
    this.looks = albumIn(section, '.rec-looks');
    this.films = albumIn(document, `.rec-album[data-album="${facts.films}"]`);
    this.turns = albumIn(document, `.rec-album[data-album="${facts.turns}"]`);
    this.turnMs = 1000 * facts.turn_sec;
    this.rows = new Map(facts.rows.map(row => [row.name, new RecordedRow(this, row)]));
    this.resetButton = one(section, '.rec-reset', HTMLButtonElement);
    this.resetButton.addEventListener('click', () => this.reset());
    this.linkButton = one(section, '.rec-link', HTMLButtonElement);
    this.linkButton.addEventListener('click', () => this.copyLink());
    this.shown = new ParameterPanel(one(section, '.param-panel'), {
      patience: '',
      enter: (name, entry) => this.enter(name, entry),
      bringBack: name => name && this.row(name).ask(this.row(name).shown),
    });
    this.draw();
  }

  /** @param {string} name */
  row(name) {
    return /** @type {RecordedRow} */ (this.rows.get(name));
  }

  /** What differs from the state in which the lesson shows the node. */
  get changed() {
    /** @type {Record<string, string>} */
    const changed = {};
    for (const row of this.rows.values()) if (row.text !== row.shown) changed[row.name] = row.text;
    return changed;
  }

  /** The name under which an album has the state of the panel; null if another parameter than those in it has changed. */
  get pictured() {
    if (Object.keys(this.changed).some(name => !this.names.includes(name))) return null;
    return key(Object.fromEntries(this.names.map(name => [name, this.row(name).text])));
  }

  /** @param {Album | null} album */
  async find(album) {
    return album && this.pictured !== null ? album.find(this.pictured) : null;
  }

  /** Give the drive with which the panel begins. */
  async findFirst() {
    return this.films?.find(key(Object.fromEntries(this.names.map(name => [name, this.row(name).shown]))));
  }

  /**
   * Give what follows if what has changed is changed at a moment of that drive.
   * @param {number} moment
   */
  async findTurn(moment) {
    return this.turns && Object.keys(this.changed).length === 1
      ? this.turns.find(`${key(this.changed)}\n${moment}`)
      : null;
  }

  /**
   * @param {string} name
   * @param {Entry} entry
   */
  enter(name, {text, position = 0, number}) {
    const row = this.row(name);
    row.ask(text ?? row.positions[position]);
    this.shown.answer(name, number);
  }

  draw() {
    /** @type {Record<string, RowState>} */
    const rows = {};
    for (const row of this.rows.values()) rows[row.name] = row.state;
    this.shown.show({rows});
    this.resetButton.disabled = !Object.keys(this.changed).length;
    this.linkButton.disabled = this.resetButton.disabled;
  }

  /**
   * Take over what the node did to its parameters.
   * @param {Record<string, string>} texts
   */
  take(texts) {
    for (const [name, text] of Object.entries(texts)) {
      const row = this.rows.get(name);
      if (row) row.text = text;
    }
    this.draw();
    for (const robot of robots) if (robot.belongsTo(this)) robot.follow(this);
    for (const view of all(document, '.rec-steps')) if (view.dataset.node === this.node) this.picture(view);
  }

  /**
   * Show the picture that belongs to the parameters; one of others is dimmed.
   * @param {HTMLElement} view
   */
  async picture(view) {
    const wanted = key(this.changed);
    const look = await this.find(this.looks);
    if (wanted !== key(this.changed)) return;
    if (look) one(view, '.rec-picture').innerHTML = look;
    view.classList.toggle('rec-stale', !look);
    one(view, '.rec-says').textContent = look ? '' : unknown('picture', this.changed);
  }

  /**
   * Return the views of a kind that show this node.
   * @param {string} selector
   */
  views(selector) {
    return all(document, selector).filter(({dataset}) => dataset.node === 'all nodes' || dataset.node === this.node);
  }

  /** @param {string[]} lines */
  log(lines) {
    for (const view of this.views('.rec-log')) {
      const list = one(view, 'pre');
      list.append(lines.map(line => `${line}\n`).join(''));
      list.scrollTop = list.scrollHeight;
    }
  }

  /**
   * Put what the node told on /parameter_events into the tables, the newest on top.
   * @param {string[][]} events
   */
  tell(events) {
    for (const view of this.views('.rec-events')) {
      for (const event of events) {
        const line = one(view, 'tbody', HTMLTableSectionElement).insertRow(0);
        for (const text of [this.node, ...event]) line.insertCell().textContent = text;
      }
    }
  }

  goBack() {
    for (const row of this.rows.values()) {
      row.text = row.shown;
      row.message = null;
    }
    this.entered.clear();
    this.say('');
    this.take({});
  }

  reset() {
    this.goBack();
    one(this.section, '.param-row :is(input, textarea, select):enabled').focus();
  }

  /** @param {string} text */
  say(text) {
    one(this.section, '.rec-from-link').textContent = text;
  }

  async copyLink() {
    const address = `${location.href.split('#')[0]}${LINK}${this.section.id}?${new URLSearchParams([...this.entered])}`;
    this.say((await copy(address)) ? 'The link is copied. It brings these settings back.' : `The link: ${address}`);
  }

  /**
   * Do again what a link says was typed; all of it or, with a sentence, nothing.
   * @param {[name: string, text: string][]} entries
   */
  followLink(entries) {
    this.goBack();
    let waiting = entries;
    // What one value needs, another one of the link may bring.
    for (let before = Infinity; waiting.length && waiting.length < before; ) {
      before = waiting.length;
      waiting = waiting.filter(([name, text]) => !this.rows.get(name)?.ask(text));
    }
    if (waiting.length || !entries.length) {
      this.goBack();
      const told = waiting.map(([name, text]) => `${name} = ${text}`).join(', ') || 'nothing';
      this.say(
        `The link that brought you here asks for ${told}, which this panel has not recorded as accepted. It was ignored.`,
      );
    } else {
      this.say('These settings come from the link that brought you here.');
    }
    this.section.scrollIntoView({block: 'center'});
  }
}

class RecordedRow {
  /** @type {string[] | null} */
  message = null;

  /**
   * @param {RecordedPanel} panel
   * @param {RowFacts} facts
   */
  constructor(panel, facts) {
    this.panel = panel;
    this.facts = facts;
    this.name = facts.name;
    this.shown = facts.text;
    this.text = facts.text;
    this.positions = facts.positions ?? [];
    const answers = Object.entries(facts.answers ?? {}).filter(([, answer]) => 'value' in answer);
    const words = answers.map(([text]) => text).filter(text => text.trim() && !/^[-+.\d]/.test(text));
    if (!facts.positions && facts.editor === 'text' && words.length > 3) this.suggest(words);
  }

  /**
   * Let the box suggest what was recorded.
   * @param {string[]} words
   */
  suggest(words) {
    const {section} = this.panel;
    const id = `${section.id}-words-${all(section, 'datalist').length}`;
    section.append(make('datalist', {id}, ...words.map(word => make('option', {value: word}))));
    const row = all(section, '.param-row').find(each => each.dataset.name === this.name);
    row?.querySelector('.param-box')?.setAttribute('list', id);
  }

  /** How the panel shows it. */
  get state() {
    /** @type {RowState} */
    const state = {text: this.text, message: this.message};
    if (this.facts.positions) state.position = this.position(this.text);
    if (this.text !== this.shown) state.first = this.shown;
    return state;
  }

  /** @param {string} text */
  position(text) {
    const exact = this.positions.indexOf(text);
    if (exact >= 0) return exact;
    const distance = (/** @type {number} */ index) => Math.abs(Number(this.positions[index]) - Number(text));
    return this.positions.reduce((best, _, index) => (distance(index) < distance(best) ? index : best), 0);
  }

  /**
   * Look up what the node said to a value, in the state in which the panel is.
   * @param {string} typed
   * @returns {boolean} True if it accepted the value.
   */
  ask(typed) {
    const answer = this.lookUp(typed);
    if (typeof answer === 'string') {
      this.message = ['unknown', answer];
      this.panel.draw();
      return false;
    }
    this.panel.say('');
    const {value = '', reason} = answer;
    if (reason !== undefined) {
      this.message = ['rejected', reason];
    } else {
      this.text = value;
      this.panel.entered.delete(this.name);
      this.panel.entered.set(this.name, typed);
      const others = Object.keys(this.panel.changed).filter(name => name !== this.name);
      this.message = [
        'accepted',
        (this.same(typed, value) ? '' : `The node has made it ${value}. `) +
          (others.length && !this.inTheWay.length ? 'Recorded with the other values as first shown.' : ''),
      ];
    }
    this.panel.take(answer.also ?? {});
    this.tellLog(answer);
    this.panel.tell(answer.events ?? []);
    return 'value' in answer;
  }

  /**
   * @param {string} typed
   * @param {string} value
   */
  same(typed, value) {
    return typed === value || this.facts.readings[typed] === value;
  }

  /** The parameters that have been changed, and on which the answer depends. */
  get inTheWay() {
    return (this.facts.depends ?? []).filter(name => this.panel.row(name).text !== this.panel.row(name).shown);
  }

  /**
   * Return what the node said to a value, or why nobody knows.
   * @param {string} typed
   * @returns {Answer | string}
   */
  lookUp(typed) {
    const inTheWay = this.inTheWay;
    let answers = this.facts.answers ?? {};
    if (inTheWay.length) {
      const state = key(Object.fromEntries(inTheWay.map(name => [name, this.panel.row(name).text])));
      const inContext = this.facts.contexts?.[state];
      if (!inContext) {
        const told = inTheWay.map(name =>
          name === this.name ? 'the value that it has' : `${name}, which you have changed`,
        );
        return (
          `the node's answer depends on ${told.join(' and ')}. ` +
          'Go back to the start below, or run the notebook to try it.'
        );
      }
      answers = inContext;
    }
    const {readings} = this.facts;
    const texts = [typed, Object.hasOwn(readings, typed) ? readings[typed] : typed];
    const text = texts.find(each => Object.hasOwn(answers, each));
    if (text !== undefined) return answers[text];
    return (
      `the node was not asked for ${typed === '' ? 'an empty text' : `“${typed}”`} when this page was made. ` +
      'Run the notebook to try it.'
    );
  }

  /** @param {Answer} answer */
  tellLog(answer) {
    const elsewhere = Object.keys(this.panel.changed).some(name => name !== this.name);
    if (!answer.log) return;
    if (this.facts.log_depends && elsewhere) {
      this.panel.log(['(not recorded: what the node logs with these values together)']);
    } else {
      this.panel.log(answer.log);
    }
  }
}

/** A robot whose drives were recorded. */
export class RecordedRobot {
  /** What is still to be told of a drive. @type {ReturnType<typeof setTimeout>[]} */
  timers = [];
  /** @type {RecordedPanel | null} */
  panel = null;
  /** The drive that is shown. @type {Film | null} */
  film = null;
  waits = false;
  begun = 0;
  changedAt = 0;
  /** The beginning of the drive that is to be turned. @type {number | null} */
  turning = null;

  /**
   * @param {HTMLElement} section
   * @param {{films: Film[]}} facts
   */
  constructor(section, facts) {
    this.section = section;
    this.node = section.dataset.node;
    this.first = facts.films[0];
    this.shown = new DrivingPicture(section, () => this.drive());
    this.shown.button.disabled = false;
  }

  /**
   * Return whether it is the robot of a panel's node, and, if it has a panel beside it, of that one.
   * @param {RecordedPanel} panel
   */
  belongsTo(panel) {
    const beside = this.section.closest('.side-by-side');
    return this.node === panel.node && (!beside?.querySelector('.rec-panel') || beside.contains(panel.section));
  }

  /**
   * Go by the parameters of a panel from now on.
   * @param {RecordedPanel} panel
   */
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
    if (!this.timers.length || !this.film) return;
    this.timers.forEach(clearTimeout);
    this.timers = [];
    this.shown.draw(this.film.end);
    this.shown.tell(this.film.scenes[this.film.scenes.length - 1]);
  }

  /** Return the drive with the parameters as they are, also if they change while it is being unpacked. */
  async findFilm() {
    for (;;) {
      const wanted = this.wanted;
      const film = this.panel && wanted ? await this.panel.find(this.panel.films) : this.first;
      if (wanted === this.wanted) return film;
    }
  }

  /** The key of what its panel has changed. */
  get wanted() {
    return this.panel ? key(this.panel.changed) : '';
  }

  /** Let a change take effect on the way: at the next moment at which one was recorded, as soon as the hand rests. */
  async turn() {
    const {film, begun, panel} = this;
    if (!film || !panel) return;
    this.changedAt = performance.now();
    if (this.turning === begun) return;
    this.turning = begun;
    let moment = 0;
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
    if (next) this.play(next);
    else this.shown.say('The next drive will show the change.');
  }

  async drive() {
    const film = await this.findFilm();
    this.stop();
    this.section.classList.toggle('rec-stale', !film);
    if (film) this.play(film);
    else this.shown.say(unknown('drive', this.panel?.changed ?? {}));
  }

  /** @param {Film} film */
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
