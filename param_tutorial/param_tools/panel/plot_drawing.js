/* Draws curves over time on a canvas: data in, strokes out. Our own, since uPlot wants one column of times for all curves,
   and its 50 kB would have to be in git: a learner's clone works without npm. */

/**
 * Times in seconds, and the values at these times; null where a gap begins.
 * @typedef {{times: number[], values: (number | null)[]}} Samples
 *
 * A change of a parameter: when, of which node and parameter, from what to what, and whether it was asked for here.
 * @typedef {{time: number, node: string, name: string, old: string, new: string, isOwn: boolean}} Mark
 *
 * What to draw: curves with their names, the marks with their words, the time that is 0 on the axis, and from where to
 * where the axis reaches, in seconds from there. A curve that `holds` keeps each value until the next one.
 * @typedef {{curves: {name: string, samples: Samples, holds: boolean, isAlive: boolean, style: number}[],
 *   marks: {time: number, words: string, isOwn: boolean}[], now: number, from: number, to: number, isScaledEach: boolean,
 *   pointer?: number, pressed?: number}} Scene
 *
 * @typedef {{ink: string, paper: string, font: string}} Look
 */

// Each has a contrast of 3 and more with white, and with the gray of JupyterLab's dark theme.
const COLORS = ['#2a7fc9', '#d1552b', '#2a8f5b', '#b0509f', '#a3720e', '#5f7385', '#8a63d2', '#1d8d99'];
const DASHES = [[], [7, 3], [2, 2], [10, 3, 2, 3]];
// A line of one pixel takes a browser without a graphics card a fifth of the time of a wider one.
const WIDE_LINES = 6;
const LEFT = 58;
const RIGHT = 10;
const TOP = 18;
const BOTTOM = 20;

/** @param {number} style */
export const colorOf = style => COLORS[style % COLORS.length];
/** @param {number} style */
export const dashOf = style => DASHES[Math.floor(style / COLORS.length) % DASHES.length];

/**
 * Return the index of the last time that is not after a time; -1 if all are.
 * @param {number[]} times
 * @param {number} time
 */
export function indexAt(times, time) {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/** @param {number} value */
export const format = value => String(Number(value.toPrecision(6))).replace('-', '\u2212');

/**
 * Return a step of 1, 2 or 5 times a power of ten that divides a width into at most so many parts.
 * @param {number} width
 * @param {number} parts
 */
function niceStep(width, parts) {
  const power = 10 ** Math.floor(Math.log10(width / parts));
  return [1, 2, 5, 10].map(factor => factor * power).find(step => step * parts >= width * (1 - 1e-9)) ?? width;
}

/**
 * Return the time that stands at a place of a canvas.
 * @param {Scene} scene
 * @param {number} width
 * @param {number} x
 */
export function timeAt({from, to}, width, x) {
  const share = (x - LEFT) / (width - LEFT - RIGHT);
  return from + (to - from) * Math.min(1, Math.max(0, share));
}

/** @param {Scene['curves'][number]} curve @param {number} from @param {number} to */
function reach({samples: {times, values}, holds}, from, to) {
  let [low, high] = [Infinity, -Infinity];
  const before = indexAt(times, from);
  for (let index = Math.max(0, holds ? before : before + 1); index < times.length && times[index] <= to; index += 1) {
    const value = values[index];
    if (value === null) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return [low, high];
}

/**
 * Return the axis on which values of a range have room.
 * @param {number[]} range
 * @param {number} parts
 */
function axisOf([low, high], parts) {
  if (low > high) [low, high] = [0, 1];
  // A curve that stands still is in the middle.
  if (high - low <= 1e-9 * Math.max(Math.abs(low), Math.abs(high))) {
    const room = Math.abs(low) / 10 || 1;
    [low, high] = [low - room, high + room];
  }
  const step = niceStep(high - low, parts);
  return {step, begin: Math.floor(low / step + 1e-9) * step, end: Math.ceil(high / step - 1e-9) * step};
}

/**
 * Draw a scene.
 * @param {CanvasRenderingContext2D} context
 * @param {number} width
 * @param {number} height
 * @param {Scene} scene
 * @param {Look} look
 */
export function paint(context, width, height, scene, look) {
  const [right, bottom] = [width - RIGHT, height - BOTTOM];
  const [from, to] = [scene.now + scene.from, scene.now + scene.to];
  const scale = (right - LEFT) / (to - from);
  /** @param {number} time */
  const xOf = time => LEFT + (time - from) * scale;
  const ranges = scene.curves.map(curve => reach(curve, from, to));
  const all = [Math.min(Infinity, ...ranges.map(each => each[0])), Math.max(-Infinity, ...ranges.map(each => each[1]))];
  const parts = Math.max(2, Math.floor((bottom - TOP) / 28));
  const axis = axisOf(all, parts);

  context.font = look.font;
  context.lineWidth = 1;
  context.fillStyle = look.paper;
  context.fillRect(0, 0, width, height);
  context.fillStyle = look.ink;
  context.strokeStyle = look.ink;
  /** @param {number} x1 @param {number} y1 @param {number} x2 @param {number} y2 */
  const line = (x1, y1, x2, y2) => {
    context.beginPath();
    context.moveTo(x1, y1);
    context.lineTo(x2, y2);
    context.stroke();
  };

  context.textAlign = 'right';
  context.textBaseline = 'middle';
  const count = Math.round((axis.end - axis.begin) / axis.step);
  for (let index = 0; index <= count; index += 1) {
    const y = Math.round(bottom - ((bottom - TOP) * index) / count) + 0.5;
    context.globalAlpha = index ? 0.15 : 0.6;
    line(LEFT, y, right, y);
    context.globalAlpha = 1;
    if (!scene.isScaledEach) context.fillText(format(axis.begin + index * axis.step), LEFT - 6, y, LEFT - 8);
  }
  context.textAlign = 'center';
  context.textBaseline = 'top';
  const step = niceStep(scene.to - scene.from, Math.max(2, Math.floor((right - LEFT) / 70)));
  for (let at = Math.ceil(scene.from / step - 1e-9) * step; at <= scene.to + 1e-9; at += step) {
    const x = xOf(scene.now + at);
    line(x, bottom, x, bottom + 4);
    context.fillText(`${format(at || 0)} s`, Math.min(x, right - 12), bottom + 6);
  }

  drawMarks(context, scene, look, {xOf, line, from, to, right, bottom});
  context.save();
  context.beginPath();
  context.rect(LEFT, TOP - 2, right - LEFT, bottom - TOP + 4);
  context.clip();
  context.lineJoin = 'bevel';
  scene.curves.forEach((curve, index) => {
    const {begin, end} = scene.isScaledEach ? axisOf(ranges[index], parts) : axis;
    const yScale = (bottom - TOP) / (end - begin);
    context.strokeStyle = colorOf(curve.style);
    context.lineWidth = scene.curves.length > WIDE_LINES ? 1 : 1.5;
    context.setLineDash(dashOf(curve.style));
    drawCurve(context, curve, {from, to, xOf, yOf: value => bottom - (value - begin) * yScale});
  });
  context.restore();
  if (scene.pointer === undefined) return;
  const x = xOf(scene.now + scene.pointer);
  context.globalAlpha = 0.3;
  line(x, TOP, x, bottom);
  context.globalAlpha = 0.15;
  if (scene.pressed !== undefined) context.fillRect(x, TOP, xOf(scene.now + scene.pressed) - x, bottom - TOP);
  context.globalAlpha = 1;
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Scene} scene
 * @param {Look} look
 * @param {{xOf: (time: number) => number, line: (x1: number, y1: number, x2: number, y2: number) => void, from: number,
 *   to: number, right: number, bottom: number}} frame
 */
function drawMarks(context, {marks}, look, {xOf, line, from, to, right, bottom}) {
  context.textBaseline = 'alphabetic';
  context.strokeStyle = look.ink;
  let free = Infinity;
  // The newest says what it is; an older one does where there is room left of it.
  for (const mark of [...marks].reverse()) {
    if (mark.time < from || mark.time > to) continue;
    const x = Math.round(xOf(mark.time)) + 0.5;
    context.setLineDash(mark.isOwn ? [] : [3, 3]);
    context.globalAlpha = 0.55;
    line(x, TOP - 4, x, bottom);
    context.globalAlpha = 1;
    const width = context.measureText(mark.words).width;
    const left = Math.max(0, Math.min(x, right - width));
    if (left + width > free) continue;
    context.textAlign = 'left';
    context.fillText(mark.words, left, TOP - 6);
    free = left - 10;
  }
  context.setLineDash([]);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Scene['curves'][number]} curve
 * @param {{from: number, to: number, xOf: (time: number) => number, yOf: (value: number) => number}} frame
 */
function drawCurve(context, {samples: {times, values}, holds, isAlive}, {from, to, xOf, yOf}) {
  context.beginPath();
  let isDrawing = false;
  let y = 0;
  for (let index = Math.max(0, indexAt(times, from)); index < times.length; index += 1) {
    const value = values[index];
    const x = xOf(times[index]);
    if (isDrawing && holds) context.lineTo(x, y);
    if (value === null) {
      isDrawing = false;
      continue;
    }
    y = yOf(value);
    if (isDrawing) context.lineTo(x, y);
    else context.moveTo(x, y);
    isDrawing = true;
    if (times[index] > to) break;
  }
  if (isDrawing && holds && isAlive) context.lineTo(xOf(to), y);
  context.stroke();
}
