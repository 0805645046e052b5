/* The robot of a reader's own driver: the kernel says where it is, and the browser moves it there. The markup is Python's. */

import {one} from '../../param_tools/panel/dom.js';
import {initialize} from '../../param_tools/panel/front.js';

/**
 * What the picture shows: variables of its style, words by the class of the element that has them, all in words.
 * @typedef {{css: Record<string, number>, says: Record<string, string>, text: string, sentence: string, hasCrashed: boolean}} Moment
 */

/** @param {import('@anywidget/types').RenderProps<{markup: string, picture: string, moment: Moment | {}}>} props */
function render({model, el}) {
  el.innerHTML = model.get('markup');
  const place = one(el, '.robot-picture');
  const said = one(el, '.robot-says');
  const button = one(el, '.robot-drive', HTMLButtonElement);
  let picture = '';

  function show() {
    if (model.get('picture') !== picture) place.innerHTML = picture = model.get('picture');
    const moment = model.get('moment');
    const isThere = 'css' in moment;
    button.disabled = !isThere;
    say(isThere ? moment.sentence : '');
    if (!isThere) return;
    const stage = one(place, '.track-stage');
    for (const [name, value] of Object.entries(moment.css)) stage.style.setProperty(name, `${value}`);
    // Where a reader has predicted a place, the form shows it as well: see `exercises/marker.js`.
    document.dispatchEvent(new CustomEvent('param-robot', {detail: moment.css['--at']}));
    for (const [name, words] of Object.entries(moment.says)) one(stage, `.${name}`, Element).textContent = words;
    const scene = one(stage, '.track-scene');
    scene.classList.toggle('robot-crashed', moment.hasCrashed);
    scene.setAttribute('aria-label', moment.text);
  }

  /** @param {string} words */
  function say(words) {
    // What is written again is read out again.
    if (said.textContent !== words) said.textContent = words;
  }

  button.addEventListener('click', () => model.send({do: 'reset'}));
  show();
  // What belongs together comes at once, and is told of one after the other.
  model.on('change:picture', show);
  model.on('change:moment', show);
}

export default {initialize, render};
