/* Drag the marker of a number line to another value. */

import {followPointer} from '../../param_tools/panel/dom.js';

/**
 * Let a reader drag the marker in the picture above a line.
 * @param {HTMLElement} line
 * @param {(text: string) => void} ask Gets the value on which the marker is dropped.
 * @returns {() => void} Ends it.
 */
export function dragMarker(line, ask) {
  const whole = new AbortController();
  // The picture is drawn anew all the time, and may come after the line.
  document.addEventListener(
    'pointerdown',
    event => {
      const pin = /** @type {Element} */ (event.composedPath()[0]).closest?.('.motion-pin');
      if (!(pin instanceof SVGGElement) || event.button !== 0 || !line.closest('.motion-view')?.contains(pin)) return;
      event.preventDefault();
      drag(pin, event.clientX, ask);
    },
    {signal: whole.signal},
  );
  return () => whole.abort();
}

/**
 * @param {SVGGElement} pin
 * @param {number} fromX
 * @param {(text: string) => void} ask
 */
function drag(pin, fromX, ask) {
  const {ownerSVGElement, dataset} = pin;
  const [low, lowX, high, highX] = (dataset.axis ?? '').split(' ').map(Number);
  const label = pin.querySelector('text');
  if (!ownerSVGElement || !label) return;
  const [drawing, before] = [ownerSVGElement, label.textContent];
  const {width} = drawing.viewBox.baseVal;
  const xOf = (/** @type {number} */ clientX) => {
    const seen = drawing.getBoundingClientRect();
    return ((clientX - seen.left) * width) / seen.width;
  };
  // The tip, below the middle of the label, points to the value, wherever the hand holds the marker.
  const held = label.getBoundingClientRect();
  const pinX = xOf(held.left + held.width / 2);
  const heldX = xOf(fromX);
  const edge = pin.getBBox().width / 2;
  const perUnit = (high - low) / (highX - lowX);
  // Whole numbers, or as many digits as a hand can tell apart.
  const digits = dataset.whole === undefined ? Math.max(1, Math.ceil(-Math.log10(perUnit * 2))) : 0;
  let text = '';

  /** @param {PointerEvent} event */
  function move(event) {
    // Beside the picture the marker would not be seen.
    const x = Math.min(Math.max(pinX + xOf(event.clientX) - heldX, edge), width - edge);
    text = (low + (x - lowX) * perUnit).toFixed(digits);
    pin.setAttribute('transform', `translate(${x - pinX} 0)`);
    /** @type {Element} */ (label).textContent = text;
  }

  /** @param {PointerEvent} event */
  function end(event) {
    pin.removeAttribute('transform');
    /** @type {Element} */ (label).textContent = before;
    if (event.type === 'pointerup' && text) ask(text);
  }

  followPointer(move, end);
}
