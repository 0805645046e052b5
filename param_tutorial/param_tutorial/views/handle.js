/* What all lines below a picture do: send what a reader chooses to the kernel, and say what came of it. */

import {make} from '../../param_tools/panel/dom.js';

/**
 * Ask the node for what a reader has chosen. In a page whose kernel is not awake yet, the answer takes its time.
 * @param {import('@anywidget/types').RenderProps<any>} props
 * @param {unknown} chosen
 */
export function ask({model, el}, chosen) {
  el.querySelector('.motion-handle')?.classList.add('motion-waiting');
  model.send({chosen});
}

/**
 * Put a line on the page.
 * @param {import('@anywidget/types').RenderProps<any>} props
 * @param {HTMLElement} line
 * @param {() => void} [draw] Draws again what may have changed.
 */
export function attach({model, el}, line, draw) {
  line.classList.add('motion-handle');
  // A screen reader hears what changes in these two; what came of it, the picture shows to everybody else.
  const problem = make('span');
  const outcome = make('span', {className: 'motion-outcome'});
  for (const each of [problem, outcome]) each.setAttribute('role', 'status');
  line.append(problem, outcome);
  // JupyterLab has meanings of its own for keys.
  line.addEventListener('keydown', event => event.stopPropagation());
  el.append(line);
  const show = () => {
    problem.textContent = model.get('problem');
    outcome.textContent = model.get('outcome');
    draw?.();
  };
  show();
  model.on('change:answered', () => line.classList.remove('motion-waiting'));
  model.on('change', show);
}
