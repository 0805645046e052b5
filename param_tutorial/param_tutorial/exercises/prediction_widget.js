/* A prediction in JupyterLab: the kernel keeps the answer, and says when the verdict may be shown; see `predicting.py`. */

import {one} from '../../param_tools/panel/dom.js';
import {initialize} from '../../param_tools/panel/front.js';
import {askForPrediction} from './prediction.js';

/**
 * @import {RenderProps} from '@anywidget/types'
 * @typedef {{markup: string, answer: string, is_decided: boolean, is_told_below: boolean, note: string}} Traits
 */

/**
 * Go on to the next code cell, for a click has made the prediction's own cell the active one.
 * @param {HTMLElement} el
 * @param {boolean} isToRun Whether to run it; another prediction waits for its own answer.
 */
function goOn(el, isToRun) {
  const app = /** @type {any} */ (window).jupyterapp; // missing outside of JupyterLab
  const panels = /** @type {any[]} */ ([...(app?.shell.widgets('main') ?? [])]);
  const notebook = panels.find(({node}) => node.contains(el))?.content;
  const cells = /** @type {any[]} */ (notebook?.widgets ?? []);
  const own = cells.findIndex(({node}) => node?.contains(el));
  const next = cells.findIndex(({model}, at) => at > own && model.type === 'code');
  if (own < 0 || next < 0) return;
  notebook.deselectAll();
  notebook.activeCellIndex = next;
  const isOther = cells[next].model.sharedModel.getSource().startsWith('exercises.predict');
  if (isToRun && !isOther) app.commands.execute('notebook:run-cell-and-select-next');
}

/** @param {RenderProps<Traits>} props */
function render({model, el}) {
  el.innerHTML = model.get('markup');
  const showAnswer = askForPrediction(one(el, 'form', HTMLFormElement), {
    commit(answer, meant) {
      model.send({do: 'commit', answer, meant});
      goOn(el, !model.get('is_decided'));
    },
    skip() {
      model.send({do: 'skip'});
      goOn(el, false);
    },
  });
  const show = () =>
    showAnswer(model.get('answer'), model.get('is_decided'), model.get('note'), model.get('is_told_below'));
  show();
  model.on('change', show);
}

export default {initialize, render};
