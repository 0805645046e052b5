/* A vehicle on its track, with the button that lets it drive: the kernel says what it does. The markup is Python's. */

import {one, uniqueName} from '../../param_tools/panel/dom.js';
import {initialize} from '../../param_tools/panel/front.js';

/**
 * From which second of the motion on, the state as one word, the picture in words, what to say, and how the vehicle leans.
 * @typedef {[at: number, word: string, text: string, sentence: string, lean: number]} Scene
 */

// What moves is drawn so often. Twice as often costs a browser without a graphics card twice as much, and looks the same.
const FRAMES_PER_SEC = 30;

/** The place where a vehicle is shown. */
class DrivingPicture {
  // Keyframes belong to the whole page.
  name = `robot-${uniqueName()}`;
  count = 0;
  isNew = false;
  // A notebook shows one vehicle in several places, and each that moves costs the browser as much as the one in sight.
  isSeen = true;
  /** What is held at its end, with its start. @type {Map<Animation, number>} */
  held = new Map();

  /**
   * @param {HTMLElement} root
   * @param {() => void} drive Called when a person presses the button.
   */
  constructor(root, drive) {
    this.picture = one(root, '.robot-picture');
    this.said = one(root, '.robot-says');
    this.button = one(root, '.robot-drive', HTMLButtonElement);
    this.button.addEventListener('click', drive);
    const look = new IntersectionObserver(
      entries => {
        this.isSeen = Boolean(entries.at(-1)?.isIntersecting);
        this.hold();
      },
      {rootMargin: '50px'},
    );
    look.observe(this.picture);
  }

  /**
   * Draw a picture; one that moves begins to, unless the reader wants no motion.
   * @param {string} picture
   */
  draw(picture) {
    this.count += 1;
    this.held.clear();
    this.picture.innerHTML = picture.replaceAll('robot-NAME', `${this.name}-${this.count}`);
    for (const {effect} of this.animations()) {
      const frames = Math.ceil((Number(effect?.getTiming().duration) / 1000) * FRAMES_PER_SEC);
      effect?.updateTiming({easing: `steps(${frames})`});
    }
    this.isNew = true;
  }

  /**
   * Tell what the vehicle does from a moment of its motion on.
   * @param {Scene} scene
   */
  tell([at, word, text, sentence, lean]) {
    const stage = one(this.picture, '.robot-stage');
    stage.style.setProperty('--lean', `${lean}rad`);
    one(stage, '.robot-word', Element).textContent = word;
    one(stage, '.robot-scene', Element).setAttribute('aria-label', text);
    this.say(sentence);
    // Without motion the picture jumps from scene to scene.
    if (this.isNew || matchMedia('(prefers-reduced-motion: reduce)').matches) this.go(at);
    this.isNew = false;
    this.hold();
  }

  /**
   * Bring what moves to a moment of the motion.
   * @param {number} at
   */
  go(at) {
    for (const each of this.animations()) each.currentTime = 1000 * at;
  }

  /** What moves the vehicle; snow and a crash go on beside it. */
  animations() {
    return this.picture
      .getAnimations({subtree: true})
      .filter(each => /** @type {CSSAnimation} */ (each).animationName?.startsWith(`${this.name}-`));
  }

  /** Put what moves out of sight to its end, where it costs nothing; back in sight, it is where it would be by now. */
  hold() {
    for (const each of this.picture.getAnimations({subtree: true})) {
      const begun = this.held.get(each);
      if (this.isSeen && begun !== undefined) {
        each.startTime = begun;
      } else if (!this.isSeen && each.playState === 'running') {
        this.held.set(each, Number(document.timeline.currentTime) - Number(each.currentTime));
        each.finish();
      }
    }
    if (this.isSeen) this.held.clear();
  }

  /** @param {string} words */
  say(words) {
    // What is written again is read out again.
    if (this.said.textContent !== words) this.said.textContent = words;
  }
}

/** @param {import('@anywidget/types').RenderProps<{markup: string, picture: string, scene: Scene | [], take: number}>} props */
function render({model, el}) {
  el.innerHTML = model.get('markup');
  const shown = new DrivingPicture(el, () => model.send({do: 'drive'}));
  let take = 0;

  function show() {
    const scene = model.get('scene');
    if (model.get('take') !== take) {
      take = model.get('take');
      shown.draw(model.get('picture'));
    }
    if (scene.length) shown.tell(scene);
    else shown.say('');
    shown.button.disabled = !scene.length;
  }

  show();
  // All that belongs together comes at once, and is told of one after the other.
  model.on('change:take', show);
  model.on('change:scene', show);
}

export default {initialize, render};
