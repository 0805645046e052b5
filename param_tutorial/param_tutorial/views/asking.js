/* A line below a picture: type a value, or drag the picture's marker to one, and the kernel asks the node for it. */

import {make} from '../../param_tools/panel/dom.js';
import {initialize} from '../../param_tools/panel/front.js';
import {dragMarker} from './dragging.js';

/** @param {import('@anywidget/types').RenderProps<{name: string, text: string, problem: string, outcome: string}>} props */
function render({model, el}) {
  const box = make('input', {type: 'text', value: model.get('text'), autocomplete: 'off', spellcheck: false});
  // A screen reader hears what changes in these two; what came of it, the picture shows to everybody else.
  const problem = make('span');
  const outcome = make('span', {className: 'motion-outcome'});
  for (const each of [problem, outcome]) each.setAttribute('role', 'status');
  const form = make(
    'form',
    {className: 'motion-handle'},
    make('label', {className: 'motion-code'}, `${model.get('name')} = `, box),
    make('button', {type: 'submit'}, 'Ask the node'),
    problem,
    outcome,
  );
  const ask = () => {
    // In a page whose kernel is not awake yet, the answer takes its time.
    form.classList.add('motion-waiting');
    model.send({asked: box.value});
  };
  form.addEventListener('submit', event => {
    event.preventDefault();
    ask();
  });
  // JupyterLab has meanings of its own for keys.
  form.addEventListener('keydown', event => event.stopPropagation());
  el.append(form);
  const show = () => {
    problem.textContent = model.get('problem');
    outcome.textContent = model.get('outcome');
  };
  show();
  model.on('change:answered', () => form.classList.remove('motion-waiting'));
  model.on('change', show);
  return dragMarker(form, text => {
    box.value = text;
    ask();
  });
}

export default {initialize, render};
