/* The marker by which a reader answers a prediction in a picture: on a line in the form and, where the question is where the
   robot stops, as a second robot in the pictures of the track. Both can be dragged, and the line knows the keyboard. The
   robot itself then drives through both. */

import {all, followPointer, one} from '../../param_tools/panel/dom.js';

/** @typedef {{low: number, high: number, unit: string, tolerance: number, is_track: boolean}} Scale */

/** The one whose robot is in the pictures. @type {Marker | undefined} */
let shown;

export class Marker {
  /** True until the reader has put it somewhere. */
  isAtRest = true;
  isDecided = false;

  /**
   * @param {HTMLFormElement} form
   * @param {Scale} scale
   */
  constructor(form, scale) {
    this.form = form;
    this.scale = scale;
    this.line = one(form, 'input', HTMLInputElement);
    this.number = one(form, '.param-predict-number');
    this.truth = one(form, '.param-predict-truth');
    // A click on the place where it stands is an answer, too.
    for (const kind of ['input', 'click']) this.line.addEventListener(kind, () => this.put());
    form.addEventListener('reset', () => {
      this.isAtRest = true;
      requestAnimationFrame(() => this.draw());
    });
    if (scale.is_track) {
      const robot = one(form, '.param-predict-robot', SVGElement);
      // As `views/track.js` says.
      document.addEventListener('param-robot', event => {
        robot.style.setProperty('--place', `${/** @type {CustomEvent<number>} */ (event).detail}`);
        if (shown === this) this.showRobot();
      });
      document.addEventListener('pointerdown', drag); // once, however often it is asked for
      const look = new IntersectionObserver(entries => this.look(Boolean(entries.at(-1)?.isIntersecting)));
      look.observe(form);
    }
    this.draw();
  }

  /** Where it stands; in binary, a step of 0.1 may miss what it leads to. */
  get value() {
    return Number(Number(this.line.value).toFixed(6));
  }

  /** From 0 at the left end to 1 at the right one, where the wall is. @param {number} value */
  placeOf(value) {
    const {low, high, is_track: isTrack} = this.scale;
    return (isTrack ? high - value : value - low) / (high - low);
  }

  put() {
    if (this.line.matches(':disabled')) return;
    const isFirst = this.isAtRest;
    this.isAtRest = false;
    this.draw();
    if (isFirst) this.form.dispatchEvent(new Event('input'));
  }

  draw() {
    const words = this.isAtRest ? '?' : `${this.value} ${this.scale.unit}`.trim();
    this.number.textContent = words;
    this.line.setAttribute('aria-valuetext', this.isAtRest ? 'not answered yet' : words);
    this.number.style.setProperty('--place', `${this.placeOf(this.value)}`);
    if (shown === this) this.showRobot();
  }

  /** @param {string} kept What the reader has committed to, if anything. @param {string} truth What is right, if it is told. */
  show(kept, truth) {
    if (kept) {
      this.isAtRest = false;
      this.line.value = `${Number.parseFloat(kept)}`;
    }
    this.isDecided = truth !== '';
    this.truth.hidden = !this.isDecided;
    if (this.isDecided) this.truth.style.setProperty('--place', `${this.placeOf(Number(truth))}`);
    this.draw();
  }

  /** Those in the pictures; JupyterLab has several notebooks in one page. */
  get robots() {
    return all(this.form.closest('.jp-NotebookPanel') ?? document, '.track-ghost');
  }

  /** Show the robot while the question is open, and until a reader has read the verdict. @param {boolean} isInSight */
  look(isInSight) {
    if (isInSight && !this.isDecided) {
      shown = this;
      this.showRobot();
    } else if (!isInSight && this.isDecided && shown === this) {
      shown = undefined;
      for (const each of this.robots) each.hidden = true;
    }
  }

  showRobot() {
    for (const each of this.robots) {
      each.hidden = false;
      each.style.setProperty('--at', `${this.placeOf(this.value)}`);
    }
  }

  /** @param {number} place Of the robot in a picture, from 0 to 1. */
  moveTo(place) {
    const {low, high} = this.scale;
    this.line.value = `${high - Math.min(1, Math.max(0, place)) * (high - low)}`;
    this.line.dispatchEvent(new Event('input', {bubbles: true}));
  }
}

/**
 * Let a reader drag the robot in a picture.
 * @param {PointerEvent} event
 */
function drag(event) {
  const target = /** @type {Element} */ (event.composedPath()[0]);
  const robot = target.closest?.('.track-ghost');
  const way = robot?.closest('.track-way')?.getBoundingClientRect();
  const marker = shown;
  if (!robot || !way || !marker || marker.line.matches(':disabled') || event.button !== 0) return;
  event.preventDefault();
  const held = event.clientX - robot.getBoundingClientRect().left;
  followPointer(({clientX}) => marker.moveTo((clientX - held - way.left) / way.width));
}
