/* A vehicle on its track, with the button that lets it drive.

   The same in JupyterLab, where a kernel says what the vehicle does (see `render` at the end), and on a page of the
   website, where a recording does (see `lesson.js`). The markup is Python's: `drawing/driving.py`. */

// What moves is drawn so often. Twice as often costs a browser without a graphics card twice as much, and looks the same.
const FRAMES_PER_SEC = 30;

/** The place where a vehicle is shown. `drive` is called when a person presses the button. */
class DrivingPicture {
  constructor(root, drive) {
    this.picture = root.querySelector('.robot-picture');
    this.said = root.querySelector('.robot-says');
    this.button = root.querySelector('.robot-drive');
    this.button.addEventListener('click', drive);
    // Keyframes belong to the whole page. Each place has this script for itself, so that counting would not tell them apart.
    this.name = `robot-${Math.random().toString(36).slice(2)}`;
    this.count = 0;
    // A notebook shows one vehicle in several places, and each that moves costs the browser as much as the one in sight.
    this.isSeen = true;
    this.held = new Map();
    new IntersectionObserver(entries => {
      this.isSeen = entries.at(-1).isIntersecting;
      this.hold();
    }, {rootMargin: '50px'}).observe(this.picture);
  }

  /** Draw a picture; one that moves begins to, unless the reader wants no motion. */
  draw(picture) {
    this.count += 1;
    this.held.clear();
    this.picture.innerHTML = picture.replaceAll('robot-NAME', `${this.name}-${this.count}`);
    for (const {effect} of this.animations()) {
      const frames = Math.ceil(effect.getTiming().duration / 1000 * FRAMES_PER_SEC);
      effect.updateTiming({easing: `steps(${frames})`});
    }
    this.isNew = true;
  }

  /** Tell what the vehicle does from a moment of its motion on. */
  tell([at, word, text, sentence, lean]) {
    const stage = this.picture.querySelector('.robot-stage');
    stage.style.setProperty('--lean', `${lean}rad`);
    stage.querySelector('.robot-word').textContent = word;
    stage.querySelector('.robot-scene').setAttribute('aria-label', text);
    this.say(sentence);
    // Without motion the picture jumps from scene to scene.
    if (this.isNew || matchMedia('(prefers-reduced-motion: reduce)').matches) this.go(at);
    this.isNew = false;
    this.hold();
  }

  /** Bring what moves to a moment of the motion. */
  go(at) {
    for (const each of this.animations()) each.currentTime = 1000 * at;
  }

  /** What moves the vehicle; snow and a crash go on beside it. */
  animations() {
    return this.picture.getAnimations({subtree: true})
      .filter(each => each.animationName?.startsWith(`${this.name}-`));
  }

  /** Put what moves out of sight to its end, where it costs nothing; back in sight, it is where it would be by now. */
  hold() {
    for (const each of this.picture.getAnimations({subtree: true})) {
      if (this.isSeen && this.held.has(each)) {
        each.startTime = this.held.get(each);
      } else if (!this.isSeen && each.playState === 'running') {
        this.held.set(each, document.timeline.currentTime - each.currentTime);
        each.finish();
      }
    }
    if (this.isSeen) this.held.clear();
  }

  say(words) {
    // What is written again is read out again.
    if (this.said.textContent !== words) this.said.textContent = words;
  }
}

/** In JupyterLab: the kernel says what the vehicle does, and lets it drive. */
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
    if (scene.length) shown.tell(scene); else shown.say('');
    shown.button.disabled = !scene.length;
  }

  show();
  // All that belongs together comes at once, and is told of one after the other.
  model.on('change:take', show);
  model.on('change:scene', show);
  return () => {
    model.off('change:take', show);
    model.off('change:scene', show);
  };
}

export default {initialize, render};
