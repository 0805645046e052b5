/* The plots of a panel: each stands below the row of its parameter, and shows the numbers that the kernel sends.

   Which plots are open, and with which curves, is the kernel's: `plot.py` is the other end. `plot.js` is one of them. */

import {all, make, uniqueName} from './dom.js';
import {Plot, SPAN} from './plot.js';
import {indexAt} from './plot_drawing.js';

/**
 * @import {Mark, Samples} from './plot_drawing.js'
 *
 * @typedef {{row: string, curves: string[]}} OpenPlot
 * @typedef {{open?: OpenPlot[], words?: Record<string, string>}} PlotState
 * @typedef {{parameters: string[], topics: [string, string][], fields: Record<string, string[] | null>}} Offer
 */

// Seconds. The kernel sends something each second; without it, the time stands still.
const SILENCE = 2;
const isStill = matchMedia('(prefers-reduced-motion: reduce)');

/** All plots of a panel. */
export class Plots {
  /** @type {PlotState} */
  state = {};
  /** @type {Map<string, Plot>} */
  plots = new Map();
  /** @type {Map<string, Samples>} */
  curves = new Map();
  /** @type {Mark[]} */
  marks = [];
  /** What can be added. @type {string[]} */
  choices = [];
  client = uniqueName();
  /** The row whose plot was asked for here, and is not there yet. @type {string | undefined} */
  wanted;
  last = 0;
  heard = 0;
  isFilled = false;

  /** The node whose changes need not be named in full. */
  node = '';

  /** @param {(content: Record<string, unknown>) => void} send */
  constructor(send) {
    this.send = (/** @type {Record<string, unknown>} */ content) => send({do: 'plot', client: this.client, ...content});
  }

  /**
   * Stand in a panel that was drawn, or drawn anew.
   * @param {HTMLElement} root
   * @param {string} [node]
   */
  settle(root, node = '') {
    this.root = root;
    this.node = node;
    for (const button of all(root, '.param-plot-open', HTMLButtonElement)) {
      const row = /** @type {HTMLElement} */ (button.closest('.param-row')).dataset.name ?? '';
      button.hidden = false;
      button.addEventListener('click', () => this.toggle(row));
    }
    this.place();
  }

  /** @param {string} row */
  rowOf(row) {
    return row
      ? this.root?.querySelector(`.param-row[data-name="${CSS.escape(row)}"]`)
      : this.root?.querySelector('.param-plots');
  }

  place() {
    for (const [row, plot] of this.plots) {
      const stands = this.rowOf(row);
      if (stands && plot.element.parentElement !== stands) stands.append(plot.element);
    }
    for (const button of all(this.root ?? make('div'), '.param-plot-open')) {
      const row = /** @type {HTMLElement} */ (button.closest('.param-row')).dataset.name ?? '';
      button.ariaExpanded = String(this.plots.has(row));
    }
  }

  /** @param {string} row */
  isOpen(row) {
    return this.plots.has(row);
  }

  /** @param {string} row */
  toggle(row) {
    if (this.isOpen(row)) {
      this.close(row);
      return;
    }
    this.wanted = row;
    this.send({act: 'open', row});
  }

  /** @param {string} row */
  close(row) {
    const opener = this.rowOf(row)?.querySelector('.param-plot-open');
    if (opener instanceof HTMLElement) opener.focus();
    this.send({act: 'close', row});
  }

  /** True if an element is in one of them. @param {Element | null} element */
  has(element) {
    return [...this.plots.values()].some(each => each.element.contains(element));
  }

  /** Show what is open now. @param {PlotState} state */
  show(state) {
    this.state = state;
    const open = new Map((state.open ?? []).map(each => [each.row, each.curves]));
    for (const [row, plot] of this.plots) {
      if (open.has(row)) continue;
      plot.element.remove();
      this.plots.delete(row);
    }
    for (const [row, curves] of open) {
      const plot = this.plots.get(row) ?? new Plot(this, row);
      this.plots.set(row, plot);
      if (JSON.stringify(plot.curves) !== JSON.stringify(curves)) plot.show(curves);
    }
    for (const name of this.curves.keys()) {
      if (![...open.values()].some(each => each.includes(name))) this.curves.delete(name);
    }
    this.place();
    const wanted = this.wanted !== undefined && this.plots.get(this.wanted);
    if (wanted) {
      // A plot without curves is opened to add some.
      if (!wanted.curves.length) wanted.input.focus();
      this.wanted = undefined;
    }
    clearInterval(this.timer);
    if (!open.size) return;
    this.timer = setInterval(() => this.draw(), isStill.matches ? 1000 : 100);
  }

  end() {
    clearInterval(this.timer);
  }

  draw() {
    if (document.hidden) return;
    for (const plot of this.plots.values()) if (!plot.still && plot.isSeen) plot.drawSoon();
  }

  /** What time it is for the kernel; its clock may be another. */
  now() {
    return this.last + Math.min(SILENCE, (performance.now() - this.heard) / 1000);
  }

  /** Take a message of the kernel's. @param {any} message */
  take(message) {
    if (message.client && message.client !== this.client) return;
    if (message.plot === 'offer') this.takeOffer(message);
    else if (message.plot === 'said') this.plots.get(message.row)?.answer(message.said);
    else this.takeData(message);
  }

  /** @param {Offer} offer */
  takeOffer({parameters, topics, fields}) {
    this.choices = [
      ...parameters,
      ...topics.flatMap(([topic, kind]) =>
        fields[kind] ? fields[kind].map(field => `${topic}.${field.replaceAll('[]', '[0]')}`) : [topic],
      ),
    ];
    for (const plot of this.plots.values()) plot.offer();
  }

  /** @param {{now: number, client?: string, curves: Record<string, [number[], (number | null)[]]>, marks: any[]}} data */
  takeData({now, client, curves, marks}) {
    this.last = now;
    this.heard = performance.now();
    // What came before this view was there is asked for until it has come.
    if (client) this.isFilled = true;
    else if (!this.isFilled) this.send({act: 'all'});
    for (const [name, [times, values]] of Object.entries(curves)) {
      const all = client ? {times: [], values: []} : (this.curves.get(name) ?? {times: [], values: []});
      this.curves.set(name, all);
      for (let index = 0; index < times.length; index += 1) {
        // All may have come before what was new then.
        if (times[index] < (all.times.at(-1) ?? 0)) continue;
        all.times.push(times[index]);
        all.values.push(values[index]);
      }
      const old = indexAt(all.times, (all.times.at(-1) ?? 0) - SPAN);
      if (old > 0) {
        all.times.splice(0, old);
        all.values.splice(0, old);
      }
    }
    const told = marks.map(([time, node, name, old, value, isOwn]) => ({time, node, name, old, new: value, isOwn}));
    this.marks = [...(client ? [] : this.marks), ...told].filter(mark => mark.time > now - 2 * SPAN);
  }

  /**
   * Return a change in words.
   * @param {Mark} mark
   * @param {boolean} [isFull] With the node's name, and from where it came.
   */
  wordsOf(mark, isFull) {
    const node = isFull || mark.node !== this.node ? mark.node : '';
    if (!mark.name) return `${mark.node} is gone`;
    const words = `${node} ${mark.name} ${mark.old} \u2192 ${mark.new}`.trim();
    return isFull ? `${words} (${mark.isOwn ? 'from here' : 'from elsewhere'})` : words;
  }
}
