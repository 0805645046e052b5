/* Numbers in the text that are parameters: drag one, and the node in the page gets it, and answers. In a notebook they are
   plain text:

       drives at <span data-parameter="/driver max_speed_mps 0 3 0.1">0.5</span> m/s

   names the node, the parameter, and the lowest value, the highest and the step that a hand can reach. */

import {all, followPointer, make} from '../../../param_tools/panel/dom.js';

const PX_PER_STEP = 6;

/** @typedef {import('./page.js').Page} Page */

/** Let the reader drag the numbers of a page. @param {Page} page */
export function letDrag(page) {
  for (const place of all(document, '[data-parameter]')) new Handle(place, page);
}

class Handle {
  /** @param {HTMLElement} place @param {Page} page */
  constructor(place, page) {
    const [node, name, low, high, step] = (place.dataset.parameter ?? '').split(' ');
    this.place = place;
    this.page = page;
    this.node = node;
    this.name = name;
    this.low = Number(low);
    this.high = Number(high);
    this.step = Number(step);
    this.digits = step.split('.')[1]?.length ?? 0;
    /** What the node holds, as far as the page knows. */
    this.held = Number(place.textContent);
    this.value = this.held;
    this.says = make('span', {className: 'live-number-says'});
    this.says.setAttribute('role', 'status');
    const about = {
      role: 'slider',
      tabindex: '0',
      'aria-label': `${name} of ${node}`,
      title: `Drag: ${name} of ${node}`,
    };
    for (const [key, words] of Object.entries({...about, 'aria-valuemin': low, 'aria-valuemax': high})) {
      place.setAttribute(key, words);
    }
    place.classList.add('live-number');
    (place.closest('p') ?? place).append(this.says);
    place.addEventListener('pointerdown', event => this.drag(event));
    place.addEventListener('keydown', event => this.press(event));
    this.show(this.value);
  }

  /** @param {number} value */
  show(value) {
    this.value = Math.min(this.high, Math.max(this.low, value));
    const words = this.value.toFixed(this.digits);
    this.place.textContent = words;
    this.place.setAttribute('aria-valuenow', words);
  }

  /** Say something below the paragraph, in place of what was said there. @param {string} words */
  say(words) {
    for (const each of all(this.says.parentElement ?? this.says, '.live-number-says')) each.textContent = '';
    this.says.textContent = words;
  }

  /** @param {PointerEvent} event */
  drag(event) {
    if (event.button !== 0) return;
    event.preventDefault();
    this.place.focus();
    const from = this.value;
    followPointer(
      ({clientX}) => this.show(from + Math.round((clientX - event.clientX) / PX_PER_STEP) * this.step),
      () => this.send(),
    );
  }

  /** @param {KeyboardEvent} event */
  press(event) {
    const steps = {ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, Home: -Infinity, End: Infinity}[event.key];
    if (!steps) return;
    event.preventDefault();
    this.show(this.value + steps * this.step);
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.send(), 400); // a key that is held sets one value
  }

  /** Ask the node for the value, and show what it holds then: it may have rejected or trimmed this one. */
  async send() {
    const value = this.value.toFixed(this.digits);
    if (Number(value) === this.held) return;
    this.say('asking the node …');
    const said = await this.page.ask(
      this.place,
      // A name would replace one of the reader's.
      `import param_tutorial\nprint(*(lambda node: (node.set_parameter('${this.name}', ${value}), ` +
        `node.get_parameter('${this.name}')))(param_tutorial.ParameterClient('${this.node}')), sep='\\t')`,
    );
    const [words, held] = (said.trim().split('\n').at(-1) ?? '').split('\t');
    this.say(words);
    if (held) this.held = Number(held);
    this.show(this.held);
    if (words.includes(' accepted ')) this.page.age(this.place);
  }
}
