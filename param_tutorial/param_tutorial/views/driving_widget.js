/* A vehicle on its track in JupyterLab: the kernel says what it does, and lets it drive; see `driving.py`. */

import {initialize} from '../../param_tools/panel/front.js';
import {DrivingPicture} from './driving.js';

/**
 * @import {RenderProps} from '@anywidget/types'
 * @import {Scene} from './driving.js'
 */

/** @param {RenderProps<{markup: string, picture: string, scene: Scene | [], take: number}>} props */
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
