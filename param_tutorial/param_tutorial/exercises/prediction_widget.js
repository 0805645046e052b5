/* A prediction in JupyterLab: the kernel keeps the answer, and says when the verdict may be shown; see `predicting.py`. */

import {one} from '../../param_tools/panel/dom.js';
import {initialize} from '../../param_tools/panel/front.js';
import {askForPrediction} from './prediction.js';

/**
 * @import {RenderProps} from '@anywidget/types'
 * @typedef {{markup: string, answer: string, is_decided: boolean, note: string}} Traits
 */

/** @param {RenderProps<Traits>} props */
function render({model, el}) {
  el.innerHTML = model.get('markup');
  const showAnswer = askForPrediction(one(el, 'form', HTMLFormElement), {
    commit: answer => model.send({do: 'commit', answer}),
    skip: () => model.send({do: 'skip'}),
  });
  const show = () => showAnswer(model.get('answer'), model.get('is_decided'), model.get('note'));
  show();
  model.on('change', show);
}

export default {initialize, render};
