/* Lines below a picture: choose what each of several things has; the kernel asks the node. */

import {all, make} from '../../param_tools/panel/dom.js';
import {initialize} from '../../param_tools/panel/front.js';
import {ask, attach} from './handle.js';

/**
 * @typedef {Record<string, Record<string, string>>} Things
 * @param {import('@anywidget/types').RenderProps<{caption: string, options: Record<string, string[]>, things: Things}>}
 *   props
 */
function render(props) {
  const {model} = props;
  const lines = make('div', {className: 'motion-choices'});
  const whole = make('div', {}, make('span', {}, model.get('caption')), lines);
  let drawn = '';

  /** @param {string} thing */
  function line(thing) {
    const choices = Object.entries(model.get('options')).map(([property, values]) => {
      const choice = make(
        'select',
        {ariaLabel: `${property} of ${thing}`, name: `${thing} ${property}`},
        ...values.map(each => make('option', {value: each}, each)),
      );
      choice.addEventListener('change', () => ask(props, [thing, property, choice.value]));
      return choice;
    });
    return make('div', {}, make('span', {className: 'motion-code'}, thing), make('span', {}, ...choices));
  }

  attach(props, whole, () => {
    const things = model.get('things');
    // A line that is drawn anew would take the keyboard away.
    if (drawn !== Object.keys(things).join('\n')) {
      drawn = Object.keys(things).join('\n');
      lines.replaceChildren(...Object.keys(things).map(line));
      whole.hidden = !drawn;
    }
    for (const choice of all(lines, 'select', HTMLSelectElement)) {
      const [thing, property] = choice.name.split(' ');
      choice.value = things[thing][property];
    }
  });
}

export default {initialize, render};
