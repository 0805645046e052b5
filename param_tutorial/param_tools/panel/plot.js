/* One plot of a panel: curves over the last 30 s, with marks at changes, and what a hand does with them.

   How long a time is shown, and whether it stands still, is each view's own. `plots.js` brings the numbers and says which
   curves there are; `plot_drawing.js` draws. */

import {all, localTime, make, one, uniqueName} from './dom.js';
import {colorOf, dashOf, format, indexAt, paint, timeAt} from './plot_drawing.js';

/**
 * @import {Mark, Samples, Scene} from './plot_drawing.js'
 * @import {Plots} from './plots.js'
 *
 * @typedef {{now: number, curves: Map<string, Samples>, marks: Mark[]}} Data
 */

// Seconds.
export const SPAN = 30;
const LEAST_SPAN = 0.5;
// Changes of a parameter that follow each other sooner are one, as when a slider is pulled.
const ONE_CHANGE = 1;
const OFFERED = 60;

/** @param {string} curve */
const isParameter = curve => !curve.startsWith('/');

/** @param {string} name @param {Blob} blob */
function download(name, blob) {
  const link = make('a', {href: URL.createObjectURL(blob), download: name});
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** @param {unknown} value */
const quoted = value => (/[",\n]/.test(String(value)) ? `"${String(value).replaceAll('"', '""')}"` : String(value));

/** @param {number} count */
const countChanges = count => `${count} change${count === 1 ? '' : 's'}`;

/** One plot. */
export class Plot {
  /** @type {string[]} */
  curves = [];
  from = -SPAN;
  to = 0;
  /** What it shows while it stands still. @type {Data | undefined} */
  still;
  /** Where the mouse is, and where it was pressed, in seconds from now. @type {number | undefined} */
  pointer;
  /** @type {number | undefined} */
  pressed;
  /** @type {Data | undefined} */
  stillBefore;
  /** @type {number | undefined} */
  frame;
  isSeen = true;
  told = 0;
  drawnKey = '';

  /**
   * @param {Plots} plots
   * @param {string} row
   */
  constructor(plots, row) {
    this.plots = plots;
    this.row = row;
    const list = uniqueName();
    this.element = make('div', {
      className: 'param-plot',
      role: 'group',
      ariaLabel: row ? `Plot of ${row}` : 'Plot',
      innerHTML: `<ul class="param-plot-key"></ul>
        <canvas tabindex="0" role="img"></canvas>
        <details class="param-plot-changes" hidden><summary></summary><ol></ol></details>
        <div class="param-plot-line"><input list="${list}" autocomplete="off" spellcheck="false"
          placeholder="Add a number of a topic${row && ', or a parameter'}" aria-label="Add a curve"><datalist id="${list}"></datalist>
        <button type="button" data-act="pause" aria-pressed="false">Pause</button>
        <button type="button" data-act="in" aria-label="Show a shorter time" title="Show a shorter time (+)">+</button>
        <button type="button" data-act="out" aria-label="Show a longer time" title="Show a longer time (\u2212)">\u2212</button>
        <button type="button" data-act="each" aria-pressed="false" hidden
          title="Draw each curve as high as the plot">Own scales</button>
        <button type="button" data-act="csv" title="Save what is here as a table">CSV</button>
        <button type="button" data-act="picture" title="Save what is here as a picture">PNG</button>
        <button type="button" data-act="close">Close</button></div>
        <div class="param-plot-said param-message" role="status"></div>`,
    });
    this.key = one(this.element, '.param-plot-key');
    this.canvas = one(this.element, 'canvas', HTMLCanvasElement);
    this.changes = one(this.element, '.param-plot-changes', HTMLDetailsElement);
    this.input = one(this.element, 'input', HTMLInputElement);
    this.said = one(this.element, '.param-plot-said');
    this.listen();
  }

  /** @param {string} name */
  button(name) {
    return one(this.element, `[data-act=${name}]`, HTMLButtonElement);
  }

  listen() {
    const {canvas, input} = this;
    /** @type {Record<string, () => void>} */
    const acts = {
      pause: () => this.pause(!this.still),
      in: () => this.zoom(0.5),
      out: () => this.zoom(2),
      each: () => {
        this.button('each').ariaPressed = String(!this.isScaledEach);
        this.draw();
      },
      csv: () => this.saveTable(),
      picture: () => this.savePicture(),
      close: () => this.plots.close(this.row),
    };
    for (const [name, act] of Object.entries(acts)) this.button(name).addEventListener('click', act);
    this.element.addEventListener('keydown', event => {
      // JupyterLab has meanings of its own for keys; Ctrl+Z is the panel's, but in a text the browser's.
      if (event.target === input || !(event.ctrlKey || event.metaKey)) event.stopPropagation();
    });
    canvas.addEventListener('keydown', event => this.onKey(event));
    canvas.addEventListener('focus', () => {
      canvas.ariaLabel = this.describe();
    });
    canvas.addEventListener('wheel', event => {
      // Without a key, the wheel scrolls the page.
      if (!event.ctrlKey && !event.shiftKey) return;
      event.preventDefault();
      this.zoom(event.deltaY + event.deltaX > 0 ? 1.25 : 0.8, this.timeOf(event));
    });
    canvas.addEventListener('pointermove', event => {
      this.pointer = this.timeOf(event);
      this.drawSoon();
    });
    canvas.addEventListener('pointerdown', event => {
      this.pressed = this.timeOf(event);
      // What is being marked has to stand still.
      this.stillBefore = this.still;
      this.still ??= this.copy();
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener('pointerup', event => this.release(this.timeOf(event)));
    canvas.addEventListener('pointercancel', () => this.release(this.pressed ?? 0));
    canvas.addEventListener('pointerleave', () => {
      this.pointer = undefined;
      this.drawSoon();
    });
    canvas.addEventListener('dblclick', () => this.pause(false));
    input.addEventListener('focus', () => this.plots.send({act: 'offer'}));
    input.addEventListener('input', event => {
      this.said.textContent = '';
      // What is chosen from the list comes without keys.
      const isTyped = event instanceof InputEvent && event.inputType && event.inputType !== 'insertReplacementText';
      if (!isTyped && this.plots.choices.includes(input.value)) this.add();
      else this.offer();
    });
    input.addEventListener('keydown', event => {
      if (event.key === 'Enter') this.add();
      if (event.key === 'Escape') input.value = '';
    });
    new IntersectionObserver(entries => {
      this.isSeen = entries.some(each => each.isIntersecting);
      if (this.isSeen) this.draw();
    }).observe(canvas);
    new ResizeObserver(() => this.drawSoon()).observe(canvas);
  }

  // -- what a hand does ---------------------------------------------------------------------------------

  /** @param {MouseEvent} event */
  timeOf(event) {
    const box = this.canvas.getBoundingClientRect();
    return timeAt(this.scene(), box.width, event.clientX - box.left);
  }

  /** @param {number} time Where a drag ended. */
  release(time) {
    if (this.pressed === undefined) return;
    const [from, to] = [this.pressed, time].sort((one, other) => one - other);
    this.pressed = undefined;
    if (to - from < (this.to - this.from) / 50) {
      this.still = this.stillBefore;
      this.draw();
      return;
    }
    [this.from, this.to] = [from, Math.max(to, from + LEAST_SPAN)];
    this.pause(true);
  }

  /** @param {KeyboardEvent} event */
  onKey(event) {
    const step = (this.to - this.from) / 10;
    /** @type {Record<string, () => void>} */
    const acts = {
      ' ': () => this.pause(!this.still),
      '+': () => this.zoom(0.5),
      '-': () => this.zoom(2),
      ArrowLeft: () => this.move(-step),
      ArrowRight: () => this.move(step),
      Escape: () => this.plots.close(this.row),
    };
    if (!acts[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    acts[event.key]();
  }

  /** @param {boolean} isWanted */
  pause(isWanted) {
    if (isWanted) this.still ??= this.copy();
    else [this.still, this.from, this.to] = [undefined, -SPAN, 0];
    const button = this.button('pause');
    button.ariaPressed = String(isWanted);
    button.textContent = isWanted ? 'Go on' : 'Pause';
    this.draw();
  }

  /**
   * Show a longer or shorter time, around a moment; as long as it runs, around now.
   * @param {number} factor
   * @param {number} [around]
   */
  zoom(factor, around = (this.from + this.to) / 2) {
    const span = Math.min(SPAN, Math.max(LEAST_SPAN, (this.to - this.from) * factor));
    const fixed = this.still ? around : this.to;
    this.to = fixed + ((this.to - fixed) * span) / (this.to - this.from);
    this.from = this.to - span;
    this.move(0);
  }

  /** @param {number} seconds */
  move(seconds) {
    if (seconds && !this.still) this.pause(true);
    const shift = Math.min(Math.max(seconds, -SPAN - this.from), -this.to);
    this.from += shift;
    this.to += shift;
    this.draw();
  }

  add() {
    if (!this.input.value.trim()) return;
    this.plots.send({act: 'add', row: this.row, curve: this.input.value});
  }

  /** Take note that what was typed has been added, or why not. @param {string} said */
  answer(said) {
    this.said.textContent = said && `${said[0].toUpperCase()}${said.slice(1)}.`;
    if (!said) this.input.value = '';
  }

  offer() {
    const words = this.input.value.toLowerCase().split(/\s+/);
    const found = this.plots.choices.filter(each => words.every(word => each.toLowerCase().includes(word)));
    one(this.element, 'datalist').replaceChildren(...found.slice(0, OFFERED).map(each => new Option('', each)));
  }

  // -- what it shows ------------------------------------------------------------------------------------

  get isScaledEach() {
    return this.button('each').ariaPressed === 'true';
  }

  /** @param {string} curve */
  word(curve) {
    return this.plots.state.words?.[curve] ?? '';
  }

  /** @returns {Data} */
  get data() {
    if (this.still) return this.still;
    const {curves, marks} = this.plots;
    let now = this.plots.now();
    // Once nothing comes any more, what came last stays in sight.
    const ends = this.curves.map(each => (this.word(each) ? (curves.get(each)?.times.at(-1) ?? 0) : Infinity));
    const end = Math.max(...ends);
    if (end > 0 && end < Infinity) now = Math.min(now, end);
    return {now, curves, marks};
  }

  /** @returns {Data} */
  copy() {
    const {now, curves, marks} = this.data;
    return {
      now,
      marks: [...marks],
      curves: new Map(
        this.curves.map(each => {
          const {times, values} = curves.get(each) ?? {times: [], values: []};
          return [each, {times: [...times], values: [...values]}];
        }),
      ),
    };
  }

  /** @returns {Scene} */
  scene() {
    const {now, curves, marks} = this.data;
    return {
      now,
      from: this.from,
      to: this.to,
      pointer: this.pointer,
      pressed: this.pressed,
      isScaledEach: this.isScaledEach && this.curves.length > 1,
      marks: this.merged(marks, now).map(mark => ({...mark, words: this.plots.wordsOf(mark)})),
      curves: this.curves.map((name, style) => ({
        name,
        style,
        holds: isParameter(name),
        isAlive: !this.word(name) || Boolean(this.still),
        samples: curves.get(name) ?? {times: [], values: []},
      })),
    };
  }

  /**
   * Return the changes of the time that can be shown; those of one pull of a slider as one.
   * @param {Mark[]} marks
   * @param {number} now
   */
  merged(marks, now) {
    /** @type {Mark[]} */
    const merged = [];
    for (const mark of marks) {
      const before = merged.findLast(each => each.node === mark.node && each.name === mark.name);
      if (mark.time < now - SPAN || mark.time > now) continue;
      if (before && mark.time - before.time < ONE_CHANGE && before.isOwn === mark.isOwn) {
        [before.time, before.new] = [mark.time, mark.new];
      } else merged.push({...mark});
    }
    return merged;
  }

  /** Show other curves. @param {string[]} curves */
  show(curves) {
    this.curves = curves;
    this.button('each').hidden = curves.length < 2;
    this.key.replaceChildren(
      ...curves.map((name, style) => {
        const dash = dashOf(style).join(' ');
        const line = make('li', {
          innerHTML: `<svg width="24" height="8" aria-hidden="true"><line x1="1" x2="23" y1="4" y2="4" stroke-width="2"
            stroke="${colorOf(style)}" stroke-dasharray="${dash}"/></svg>`,
        });
        const words = `Remove ${name}`;
        const remove = make('button', {type: 'button', title: words, ariaLabel: words}, '\u00d7');
        remove.addEventListener('click', () => this.plots.send({act: 'remove', row: this.row, curve: name}));
        line.append(make('span', {className: 'param-plot-name'}, name), make('output'), remove);
        return line;
      }),
    );
    this.told = 0;
    this.canvas.ariaLabel = this.describe();
    this.draw();
  }

  drawSoon() {
    this.frame ??= requestAnimationFrame(() => this.draw());
  }

  draw() {
    if (this.frame) cancelAnimationFrame(this.frame);
    this.frame = undefined;
    const {canvas} = this;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    const context = canvas.getContext('2d');
    if (!context || !width || !this.isSeen) return;
    const ratio = Math.min(2, devicePixelRatio);
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    }
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const scene = this.scene();
    paint(context, width, height, scene, this.look());
    // Nobody reads numbers that change ten times a second, and each costs the browser a layout.
    if (performance.now() - this.told < 400 && this.pointer === undefined) return;
    this.told = performance.now();
    this.tell(scene);
  }

  look() {
    const {color, fontFamily, backgroundColor} = getComputedStyle(this.canvas);
    return {ink: color, paper: backgroundColor, font: `11px ${fontFamily}`};
  }

  /** @param {Scene} scene @param {number} index */
  valueAt({curves, now, pointer, to}, index) {
    const {samples, holds} = curves[index];
    const at = now + (pointer ?? to);
    let found = indexAt(samples.times, at);
    if (found < 0) return null;
    const next = samples.times[found + 1] ?? Infinity;
    if (!holds && next - at < at - samples.times[found]) found += 1;
    return samples.values[found] ?? null;
  }

  /** Say in words what the curves show: now, or where the mouse is. @param {Scene} scene */
  tell(scene) {
    all(this.key, 'output').forEach((output, index) => {
      const value = this.valueAt(scene, index);
      const isKnown = value !== null && (scene.pointer !== undefined || !this.word(this.curves[index]));
      const words = isKnown ? format(value) : this.word(this.curves[index]) || '\u2013';
      if (output.textContent !== words) output.textContent = words;
    });
    const {marks} = scene;
    this.changes.hidden = !marks.length;
    const key = JSON.stringify(marks);
    if (key === this.drawnKey) return;
    this.drawnKey = key;
    one(this.changes, 'summary').textContent = countChanges(marks.length);
    one(this.changes, 'ol').replaceChildren(
      ...marks.map(mark =>
        make(
          'li',
          {},
          `${localTime(1000 * mark.time).slice(11)} ${this.plots.wordsOf(/** @type {any} */ (mark), true)}`,
        ),
      ),
    );
  }

  /** Return the plot in words. */
  describe() {
    const scene = this.scene();
    const parts = scene.curves.map(({name, samples: {values}}, index) => {
      const numbers = /** @type {number[]} */ (values.filter(each => each !== null));
      const value = this.valueAt({...scene, pointer: undefined}, index);
      const now = this.word(name) || (value === null ? 'no value' : `now ${format(value)}`);
      if (!numbers.length) return `${name}: ${now}`;
      const [low, high] = [numbers.reduce((a, b) => Math.min(a, b)), numbers.reduce((a, b) => Math.max(a, b))];
      return `${name}: ${now}, from ${format(low)} to ${format(high)}`;
    });
    return `The last ${SPAN} seconds. ${parts.join('. ')}. ${countChanges(scene.marks.length)}.`;
  }

  // -- saving -------------------------------------------------------------------------------------------

  get fileName() {
    return (this.row || this.curves[0] || 'plot').replace(/[^\w.-]+/g, '_').replace(/^_/, '');
  }

  saveTable() {
    const {curves, marks} = this.still ?? this.copy();
    /** @type {Map<number, Record<string, unknown>>} */
    const rows = new Map();
    /** @param {number} time @param {string} column @param {unknown} value */
    const put = (time, column, value) => {
      rows.set(time, {...rows.get(time), [column]: value});
    };
    for (const [name, {times, values}] of curves)
      for (const [index, time] of times.entries()) put(time, name, values[index]);
    for (const mark of marks) put(mark.time, 'change', this.plots.wordsOf(mark, true));
    const columns = [...this.curves, 'change'];
    const lines = [...rows]
      .sort(([one], [other]) => one - other)
      .map(([time, row]) => [time, ...columns.map(each => row[each] ?? '')].map(quoted).join(','));
    const text = `${['time', ...columns].map(quoted).join(',')}\n${lines.join('\n')}\n`;
    download(`${this.fileName}.csv`, new Blob([text], {type: 'text/csv'}));
  }

  savePicture() {
    const [width, line] = [900, 18];
    const top = 10 + line * this.curves.length;
    const canvas = make('canvas', {width: 2 * width, height: 2 * (top + 360)});
    const context = canvas.getContext('2d');
    if (!context) return;
    const look = this.look();
    context.scale(2, 2);
    context.fillStyle = look.paper;
    context.fillRect(0, 0, width, top + 360);
    context.font = look.font;
    this.curves.forEach((name, style) => {
      const y = 14 + line * style;
      context.strokeStyle = colorOf(style);
      context.lineWidth = 2;
      context.setLineDash(dashOf(style));
      context.beginPath();
      context.moveTo(58, y - 4);
      context.lineTo(88, y - 4);
      context.stroke();
      context.fillStyle = look.ink;
      context.fillText(name, 96, y);
    });
    context.setLineDash([]);
    context.translate(0, top);
    paint(context, width, 360, {...this.scene(), pointer: undefined}, look);
    canvas.toBlob(blob => blob && download(`${this.fileName}.png`, blob));
  }
}
