/* A lesson's page with a kernel: wakes it when something is touched, runs cells in it, and shows what they put out.

   What the reader touches first may be in the middle of the lesson. The kernel then runs the cells down to that one, as
   "Run All Above" does in a notebook. What they put out stands on the page already; only what differs is drawn again. */

import {all, make, one} from '../../../param_tools/panel/dom.js';
import {answerTo, keepAnswer, progressFile} from '../scripts/progress.js';
import {reachPictures, wrapSentences} from '../scripts/wide.js';
import {keepCode, keptCode} from './kept_code.js';
import {keepFiles, keptFiles} from './kept_files.js';
import {digest, WIDGET} from './kernel.js';
import {Margin} from './margin.js';
import {letDrag} from './numbers.js';
import {Output} from './outputs.js';
import {View} from './widgets.js';

// Of the lessons' own cells, none takes so long on a machine with nothing else to do.
const PATIENCE_MS = 10_000;
// What the reader waits for before the first cell runs; the worker says when the next one begins.
const STEPS = ['loading 10 MB', 'unpacking', 'starting Python', 'starting ROS'];

/**
 * What the page knows of a cell: its code in the lesson, a digest of its outputs, the names of the widgets that it shows,
 * and the states of all within them.
 * @typedef {{id: string, source: string, digest: string, roots: string[], states: Record<string, any>}} CellFacts
 */

/** A code cell of the lesson. */
class Cell {
  /** True if its outputs are to be drawn whatever they are: the reader has run it. */
  isAsked = false;
  /** What comes after its run, from a callback or a timer, is drawn at once. */
  isRunning = false;
  /** True if its outputs are those on the page. */
  isDrawn = false;
  /** @type {Output[]} */
  outputs = [];
  /** By the names of the widgets. @type {Map<string, View>} */
  views = new Map();
  /** Called once, when it has run. @type {(() => void)[]} */
  waiting = [];

  /**
   * @param {CellFacts} facts
   * @param {HTMLElement | null} element Null if the page shows nothing of it.
   */
  constructor(facts, element) {
    this.facts = facts;
    this.element = element;
    this.code = facts.source;
    // A prediction is the page's own; see scripts/predictions.js.
    this.isOwn = Boolean(element?.querySelector('.lesson-prediction'));
  }

  get place() {
    const found = this.element?.querySelector('.cell_output');
    if (found || !this.element) return found;
    const made = make('div', {className: 'cell_output docutils container'});
    this.element.append(made);
    return made;
  }

  /** Show all outputs in place of those before, unless they are there; a view that is the same goes on. */
  show() {
    if (this.isOwn || !this.place) return;
    for (const output of this.outputs) output.write();
    if (!this.isDrawn) this.place.replaceChildren(...this.outputs.map(output => output.element));
    this.isDrawn = true;
    wrapSentences(this.place);
    reachPictures(this.place);
  }

  /**
   * Take one more output; who runs a cell sees it at once.
   * @param {any} said
   * @param {View} [view]
   */
  add(said, view) {
    const before = this.outputs.at(-1);
    const output = before?.goOn(said) ? before : new Output(said, view?.element);
    if (output !== before) this.outputs.push(output);
    if (this.isRunning && (this.isOwn || !this.isAsked)) return;
    if (!this.isDrawn && !this.isOwn) this.show();
    else if (output !== before) this.place?.append(output.element);
  }

  /** Forget all outputs; those on the page stay until others come. */
  clear() {
    this.outputs = [];
    this.isDrawn = false;
  }

  get digest() {
    return digest(this.outputs.map(output => output.said));
  }
}

/** All of a lesson's page. */
export class Page {
  /** @type {Set<View>} */
  views = new Set();
  /** The kernel's widgets, by name. @type {Map<string, any>} */
  widgets = new Map();
  /** @type {Worker | undefined} */
  worker;
  /** The first cell that the kernel was not yet told to run. */
  next = 0;
  running = 0;
  /** Of the cells that it was told to run since it had nothing to do. */
  told = 0;
  step = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  timer;

  /** @param {CellFacts[]} facts */
  constructor(facts) {
    const find = (/** @type {string} */ id) => document.querySelector(`.cell.tag_live-${CSS.escape(id)}`);
    this.cells = facts.map(each => new Cell(each, /** @type {HTMLElement | null} */ (find(each.id))));
    this.byId = new Map(this.cells.map(each => [each.facts.id, each]));
    this.notice = make('div', {className: 'live-notice', hidden: true});
    this.notice.setAttribute('role', 'status');
    document.body.append(this.notice);
    this.line = make('div', {className: 'live-step', hidden: true});
    this.line.setAttribute('role', 'status');
    this.say('asleep');
    this.margin = new Margin(() => this.cells.flatMap(({views}) => [...views.values()]));
    for (const cell of this.cells) {
      for (const still of cell.element ? all(cell.element, '.live-view') : []) {
        const root = still.dataset.root ?? '';
        const view = new View(this, cell.facts.id, root, cell.facts.states);
        cell.views.set(root, view);
        // Nothing on the page moves: the first picture stays until there is another.
        Promise.all(view.loading).then(() => {
          still.replaceWith(view.element);
          this.margin.update();
        });
      }
    }
  }

  /** @param {string} state @param {string} [words] */
  say(state, words = '') {
    document.documentElement.dataset.node = state;
    this.notice.textContent = words;
    this.notice.hidden = !words;
  }

  /**
   * Say how far the node is, where the reader has touched the page last.
   * @param {Element} [place]
   */
  tellHowFar(place = this.line.parentElement ?? undefined) {
    const isLoading = this.step < STEPS.length;
    if (place && place !== this.line.parentElement) place.append(this.line);
    this.line.textContent = isLoading
      ? `Step ${this.step + 1} of ${STEPS.length}, ${STEPS[this.step]}: Python and ROS are coming into this page …`
      : `Running cell ${this.told - this.running + 1} of ${this.told} …`;
    // A single cell has its own sign.
    if (isLoading || this.told > 1) this.line.hidden = false;
  }

  /** Let the worker begin; once for the page. @param {Element} [place] What the reader has touched. */
  async begin(place) {
    if (this.worker) return;
    this.say('waking');
    this.tellHowFar(place);
    const code = /** @type {any} */ (self).lessonWorker;
    const address = URL.createObjectURL(new Blob([code], {type: 'text/javascript'}));
    this.worker = new Worker(address);
    this.worker.addEventListener('message', ({data}) => this.hear(data));
    const unpacker = new Worker(address);
    for (const each of [this.worker, unpacker]) each.addEventListener('error', event => this.die(event.message));
    try {
      await loadLater('python.js');
    } catch (error) {
      this.die(String(error));
      return;
    }
    this.hear({is: 'step'});
    const packed = new TextEncoder().encode(/** @type {any} */ (self).lessonPython.toString().slice(9, -2));
    delete (/** @type {any} */ (self).lessonPython);
    unpacker.postMessage({packed}, [packed.buffer]);
    const {data} = await new Promise(resolve => unpacker.addEventListener('message', resolve));
    unpacker.terminate();
    this.worker.postMessage({...data, progress: progressFile(), files: await keptFiles()}, data.buffers);
  }

  /** @param {string} why */
  die(why) {
    console.warn(why);
    for (const {waiting} of this.cells) for (const each of waiting.splice(0)) each();
    this.line.hidden = true;
    this.say('dead', 'Python could not be started, so this page shows what it was built with. Reload it to try again.');
  }

  /**
   * Have all cells down to one run, that one included, and the views right below it, which may show what it does: a log,
   * or a curve. A view after a text is another step of the lesson, and may change the node. Those that were told to already
   * are not told again.
   * @param {string} id
   * @param {Element} [place] What the reader has touched.
   */
  wake(id, place) {
    this.begin(place);
    let last = this.cells.findIndex(each => each.facts.id === id);
    while (this.isRightBelow(last, place)) last += 1;
    while (this.next <= last) this.tellToRun(this.cells[this.next++]);
    if (this.running) this.tellHowFar(place);
  }

  /**
   * Tell whether the next cell shows a view right below a cell, or below the paragraph that the reader has touched.
   * @param {number} at
   * @param {Element} [place] What the reader has touched.
   */
  isRightBelow(at, place) {
    const below = this.cells[at + 1];
    const before = below?.element?.previousElementSibling;
    return below?.facts.roots.length && before && [this.cells[at].element, place].includes(before);
  }

  /**
   * Run a cell with what stands in it now, after all above it.
   * @param {Cell} cell
   */
  run(cell) {
    const at = this.cells.indexOf(cell);
    const place = cell.element?.querySelector('.live-tools') ?? undefined;
    if (at > 0) this.wake(this.cells[at - 1].facts.id, place);
    this.begin(place);
    this.next = Math.max(this.next, at + 1);
    cell.isAsked = true;
    this.tellToRun(cell);
    this.tellHowFar(place);
  }

  /** @param {Cell} cell */
  tellToRun(cell) {
    this.running += 1;
    this.told += 1;
    cell.element?.setAttribute('aria-busy', 'true');
    delete cell.element?.dataset.isOld;
    this.worker?.postMessage({run: cell.facts.id, code: cell.code});
  }

  /**
   * Run code that is no cell of the lesson, after all cells above a place.
   * @param {Element} place
   * @param {string} code
   * @returns {Promise<string>} What it printed, or the error that it raised.
   */
  async ask(place, code) {
    const above = this.cells.findLast(({element}) => element && isAbove(element, place));
    const paragraph = place.closest('p') ?? undefined;
    if (above) this.wake(above.facts.id, paragraph);
    const asked = new Cell({id: `asked-${this.byId.size}`, source: code, digest: '', roots: [], states: {}}, null);
    this.byId.set(asked.facts.id, asked);
    const hasRun = new Promise(resolve => asked.waiting.push(() => resolve(undefined)));
    this.begin(paragraph);
    this.tellToRun(asked);
    await hasRun;
    this.byId.delete(asked.facts.id);
    return (
      asked.outputs.map(({said}) => said.text ?? `${said.ename}: ${said.evalue}`).join('') || 'The node did not answer.'
    );
  }

  /** Mark what was printed in a section below a place, before a change there; a view shows by itself what is now. @param {Element} place */
  age(place) {
    for (const {element, isOwn, views} of this.cells) {
      if (!element?.querySelector('.cell_output') || isOwn || views.size) continue;
      if (element.closest('section') === place.closest('section') && isAbove(place, element))
        element.dataset.isOld = '';
    }
  }

  /** @param {string} widget @param {any} data */
  tell(widget, data) {
    this.worker?.postMessage({widget, data});
  }

  /** @param {any} said */
  hear(said) {
    if (said.is === 'step') {
      this.step += 1;
      this.tellHowFar();
      return;
    }
    if (said.is === 'ready') {
      this.step = STEPS.length;
      if (this.running) this.tellHowFar();
      else this.rest();
      return;
    }
    const cell = this.byId.get(said.cell);
    if (said.is === 'begin' && cell) cell.isRunning = true;
    if (said.is === 'begin') this.timer = setTimeout(() => this.offerStop(), PATIENCE_MS);
    if (said.is === 'widget') this.hearOfWidget(said);
    else if (said.is === 'log') this.margin.say(said.time_ms, `${said.text}\n`);
    else if (said.is === 'update') this.replace(said);
    else if (said.is === 'files') keepFiles(said.changes);
    else if (said.is === 'dead') this.die(said.why);
    else if (said.is === 'solved') this.keepSolved(said.numbers);
    else if (said.is === 'begin' || said.is === 'clear') cell?.clear();
    else if (cell && said.is === 'output') this.hearOutput(cell, said.output);
    else if (cell && said.is === 'ran') this.end(cell);
  }

  /** Offer to end a cell that may never end by itself; what the reader typed is there again afterward. */
  offerStop() {
    const stop = make('button', {type: 'button'}, 'Stop it, and load the page again');
    stop.addEventListener('click', () => location.reload());
    this.say('awake', 'A cell is still running. ');
    this.notice.append(stop);
  }

  /** @param {any} said */
  hearOfWidget({does, name, state, content}) {
    if (does === 'close') this.widgets.delete(name);
    else if (does !== 'custom') this.widgets.set(name, {...this.widgets.get(name), ...state});
    for (const view of this.views) {
      const handle = view.handles.get(name);
      if (!handle?.isLive) continue;
      if (does === 'custom') handle.emit('msg:custom', content, []);
      else if (does === 'update') handle.update(state);
    }
  }

  /** @param {Cell} cell @param {any} output */
  hearOutput(cell, output) {
    const root = output.data?.[WIDGET]?.model_id;
    if (!cell.isRunning && output.output_type === 'stream') this.margin.say(Date.now(), output.text);
    if (!root || cell.isOwn) {
      cell.add(output);
      return;
    }
    const view = cell.views.get(root) ?? new View(this, cell.facts.id, root, {});
    cell.views.set(root, view);
    view.goLive();
    cell.add(output, view);
  }

  /** @param {string[]} numbers Of the exercises that the course knows as solved. */
  keepSolved(numbers) {
    for (const number of numbers) {
      const isHere = document.querySelector(`.tag_live-check-${number.replace('.', '-')}`);
      if (isHere && answerTo(number) === undefined) keepAnswer(number, '', true);
    }
  }

  /** @param {any} said */
  replace({display, output}) {
    for (const cell of this.cells) {
      const at = cell.outputs.findIndex(each => each.said.display === display && display);
      if (at >= 0) {
        const before = cell.outputs[at];
        cell.outputs[at] = new Output({...before.said, ...output});
        if (cell.isDrawn) before.element.replaceWith(cell.outputs[at].element);
        // The outputs on the page stay while a cell runs for the sake of another.
        if (!cell.isRunning || cell.isAsked) cell.show();
      }
    }
  }

  /** @param {Cell} cell */
  end(cell) {
    clearTimeout(this.timer);
    this.running -= 1;
    cell.element?.removeAttribute('aria-busy');
    if (cell.isAsked || cell.digest !== cell.facts.digest) cell.show();
    cell.isRunning = false;
    for (const each of cell.waiting.splice(0)) each();
    const shown = new Set(cell.outputs.map(output => output.drawn));
    for (const [root, view] of cell.views) {
      if (shown.has(view.element)) continue;
      cell.views.delete(root);
      this.views.delete(view);
    }
    this.margin.update();
    if (this.running) this.tellHowFar();
    else this.rest();
  }

  /** All is done that the reader has asked for. */
  rest() {
    this.told = 0;
    this.line.hidden = true;
    this.say('awake');
  }
}

/**
 * Load a script that the page does not need at once. It stands beside the page, or, in a lesson that is one file, in it.
 * @param {string} name
 */
function loadLater(name) {
  const place = one(document, `script[data-later="${name}"]`);
  const source = place.dataset.source ?? '';
  return new Promise((resolve, reject) => {
    const script = source ? make('script', {src: source, async: true}) : make('script', {}, place.textContent ?? '');
    script.addEventListener('load', () => resolve(script.remove()));
    script.addEventListener('error', () => reject(new Error(`${source} can't be loaded`)));
    document.head.append(script);
    if (!source) resolve(script.remove());
  });
}

/** @type {Promise<typeof import('./editor.js')> | undefined} */
let editors;

/** Load what makes editors, once for the page. */
function loadEditors() {
  editors ??= loadLater('editor.js').then(() => /** @type {any} */ (self).lessonEditor);
  return /** @type {Promise<typeof import('./editor.js')>} */ (editors);
}

/** @param {Element} one @param {Element} other */
function isAbove(one, other) {
  return Boolean(one.compareDocumentPosition(other) & Node.DOCUMENT_POSITION_FOLLOWING);
}

/** @type {Page | undefined} */
let page;

/**
 * Run the cell that decides a prediction.
 * @param {HTMLElement} question
 * @returns {Promise<void>} Ends when it has run; at once if the page has no such cell, or no Python.
 */
export async function runBelow(question) {
  const own = page?.cells.findIndex(({element}) => element?.contains(question)) ?? -1;
  const cell = page?.cells[own + 1];
  if (own < 0 || !cell || cell.isOwn || document.documentElement.dataset.node === 'dead') return;
  const hasRun = /** @type {Promise<void>} */ (new Promise(resolve => cell.waiting.push(resolve)));
  page?.run(cell);
  await hasRun;
}

/** Bring the page to life if it has a kernel. */
export async function beginLive() {
  const facts = document.querySelector('script.live-cells');
  if (!facts) return;
  const live = new Page(JSON.parse(facts.textContent ?? ''));
  page = live;
  letDrag(live);
  const codes = await keptCode();
  for (const cell of live.cells) {
    if (cell.element?.querySelector('.cell_input')) letEdit(live, cell, codes[cell.facts.id]);
  }
  // Python is large, and many only read. Who puts the cursor into a box, or chooses an answer, is about to need it.
  addEventListener('focusin', ({target}) => {
    const place = /** @type {Element} */ (target).closest('.live-view, .lesson-prediction');
    if (place && target instanceof HTMLInputElement) live.begin(place.matches('.live-view') ? place : undefined);
  });
}

/**
 * Put buttons beside a cell's code: run it, edit it, and bring back what the lesson says.
 * @param {Page} page
 * @param {Cell} cell
 * @param {string | undefined} code What the reader typed at an earlier visit.
 */
function letEdit(page, cell, code) {
  const input = one(/** @type {HTMLElement} */ (cell.element), '.cell_input');
  const lesson = one(input, 'div');
  // As in a notebook: click the code, and press Shift + Enter.
  one(lesson, 'pre').tabIndex = 0;
  /** @type {import('@codemirror/view').EditorView | undefined} */
  let editor;
  const button = (/** @type {string} */ words, /** @type {string} */ label, /** @type {() => void} */ onClick) => {
    const made = make('button', {type: 'button', className: 'live-button'}, words);
    made.setAttribute('aria-label', label);
    made.addEventListener('click', onClick);
    return made;
  };
  const run = () => page.run(cell);
  const runByKey = (/** @type {KeyboardEvent} */ event) => {
    if (event.key !== 'Enter' || !(event.shiftKey || event.ctrlKey)) return;
    event.preventDefault();
    run();
  };
  const show = () => {
    resetButton.hidden = cell.code === cell.facts.source && !editor;
    editButton.hidden = Boolean(editor);
  };
  const reset = () => {
    cell.code = cell.facts.source;
    editor?.dom.replaceWith(lesson);
    editor?.destroy();
    editor = undefined;
    keepCode(cell.facts.id);
    show();
    delete cell.element?.dataset.isOld;
    editButton.focus();
  };
  const keep = (/** @type {string} */ typed) => {
    cell.code = typed;
    keepCode(cell.facts.id, typed);
    show();
  };
  const edit = async () => {
    const {makeEditor} = await loadEditors();
    if (editor) return;
    editor = makeEditor(cell.code, keep, run);
    lesson.replaceWith(editor.dom);
    show();
  };
  const editHere = () => {
    page.begin(tools);
    return edit().then(() => editor?.focus());
  };
  const editButton = button('Edit', 'Edit the code of this cell', editHere);
  const resetButton = button('Reset', 'Bring back the code of the lesson', reset);
  lesson.addEventListener('keydown', runByKey);
  lesson.addEventListener('dblclick', editHere);
  const tools = make('div', {className: 'live-tools'}, button('Run', 'Run this cell', run), editButton, resetButton);
  input.append(tools);
  show();
  if (code !== undefined && code !== cell.code) {
    cell.code = code;
    input.closest('details')?.setAttribute('open', '');
    /** @type {HTMLElement} */ (cell.element).dataset.isOld = ''; // the lesson's code has put out what stands below
    edit();
  }
}
