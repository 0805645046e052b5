/* A vehicle on its track, with the button that lets it drive.

   The same in JupyterLab, where a kernel says what the vehicle does (see `render` at the end), and on a page of the
   website, where a recording does (see `lesson.js`). The markup is Python's: `pictures/track.py`. */

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
  }

  /** Draw a picture; one that moves begins to, unless the reader wants no motion. */
  draw(picture) {
    this.count += 1;
    this.picture.innerHTML = picture.replaceAll('robot-NAME', `${this.name}-${this.count}`);
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
  }

  /** Bring what moves to a moment of the motion. */
  go(at) {
    for (const each of this.picture.getAnimations({subtree: true})) {
      if (each.animationName?.startsWith(`${this.name}-`)) each.currentTime = 1000 * at;
    }
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

export default {render};
