/* A line below a picture: type a value, and the kernel asks the node for it. */

import {make} from '../../param_tools/panel/dom.js';
import {initialize} from '../../param_tools/panel/front.js';

/** @param {import('@anywidget/types').RenderProps<{name: string, text: string, said: string}>} props */
function render({model, el}) {
  const box = make('input', {type: 'text', value: model.get('text'), autocomplete: 'off', spellcheck: false});
  const button = make('button', {type: 'submit'}, 'Ask the node');
  const said = make('span');
  said.setAttribute('role', 'status');
  const form = make(
    'form',
    {className: 'motion-asking'},
    make('label', {}, `${model.get('name')} = `, box),
    button,
    said,
  );
  form.addEventListener('submit', event => {
    event.preventDefault();
    model.send({do: 'ask', text: box.value});
  });
  // JupyterLab has meanings of its own for keys.
  form.addEventListener('keydown', event => event.stopPropagation());
  el.append(form);
  const show = () => {
    said.textContent = model.get('said');
  };
  show();
  model.on('change:said', show);
  return () => model.off('change:said', show);
}

export default {initialize, render};
