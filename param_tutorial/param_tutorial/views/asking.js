/* A line below a picture: type a value, or drag the picture's marker to one, and the kernel asks the node for it. */

import {make} from '../../param_tools/panel/dom.js';
import {initialize} from '../../param_tools/panel/front.js';
import {dragMarker} from './dragging.js';
import {ask, attach} from './handle.js';

/** @param {import('@anywidget/types').RenderProps<{name: string, text: string}>} props */
function render(props) {
  const {model} = props;
  const box = make('input', {type: 'text', value: model.get('text'), autocomplete: 'off', spellcheck: false});
  const form = make(
    'form',
    {},
    make('label', {className: 'motion-code'}, `${model.get('name')} = `, box),
    make('button', {type: 'submit'}, 'Ask the node'),
  );
  form.addEventListener('submit', event => {
    event.preventDefault();
    ask(props, box.value);
  });
  attach(props, form);
  return dragMarker(form, text => {
    box.value = text;
    ask(props, text);
  });
}

export default {initialize, render};
