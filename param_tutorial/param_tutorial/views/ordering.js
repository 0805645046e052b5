/* A line below a picture: drag things into another order, or move them with their arrows; the kernel asks the node. */

import {all, make} from '../../param_tools/panel/dom.js';
import {initialize} from '../../param_tools/panel/front.js';
import {ask, attach} from './handle.js';

/** @param {import('@anywidget/types').RenderProps<{items: string[]}>} props */
function render(props) {
  const {model} = props;
  const caption = 'Drag into another order:';
  const list = make('ol', {ariaLabel: caption});
  const line = make('div', {}, make('span', {ariaHidden: 'true'}, caption), list);
  const order = () => all(list, 'li').map(each => each.dataset.item ?? '');
  const send = () => ask(props, order());

  /**
   * @param {string} name
   * @param {-1 | 1} by
   */
  function arrow(name, by) {
    const button = make(
      'button',
      {type: 'button', ariaLabel: `Move ${name} ${by < 0 ? 'earlier' : 'later'}`},
      by < 0 ? '‹' : '›',
    );
    button.addEventListener('click', () => {
      const items = order();
      const at = items.indexOf(name);
      [items[at], items[at + by]] = [items[at + by], items[at]];
      draw(items);
      // The keyboard stays on what it has moved.
      const [earlier, later] = all(list.children[at + by], 'button', HTMLButtonElement);
      const again = by < 0 ? earlier : later;
      (again.disabled ? (by < 0 ? later : earlier) : again).focus();
      send();
    });
    return button;
  }

  /** @param {string[]} items */
  function draw(items) {
    list.replaceChildren(
      ...items.map((name, at) => {
        const [earlier, later] = [arrow(name, -1), arrow(name, 1)];
        [earlier.disabled, later.disabled] = [at === 0, at === items.length - 1];
        const item = make('li', {}, earlier, make('span', {className: 'motion-code'}, name), later);
        item.dataset.item = name;
        return item;
      }),
    );
  }

  list.addEventListener('pointerdown', event => {
    const pressed = /** @type {Element} */ (event.target);
    const held = pressed.closest('li');
    if (!held || pressed.closest('button') || event.button !== 0) return;
    const before = order();
    const done = new AbortController();
    const {signal} = done;
    held.classList.add('motion-held');
    // Held by the list: an item that changes its place would lose it.
    list.setPointerCapture(event.pointerId);
    const root = /** @type {Document | ShadowRoot} */ (list.getRootNode());
    const move = (/** @type {PointerEvent} */ {clientX, clientY}) => {
      const other = root.elementFromPoint(clientX, clientY)?.closest('li');
      if (!other || other === held || other.parentElement !== list) return;
      const {left, width} = other.getBoundingClientRect();
      const isPast = clientX > left + width / 2;
      const isLater = Boolean(held.compareDocumentPosition(other) & Node.DOCUMENT_POSITION_FOLLOWING);
      if (isPast && isLater) other.after(held);
      if (!isPast && !isLater) other.before(held);
    };
    const end = () => {
      done.abort();
      const items = order();
      draw(items);
      if (items.join('\n') !== before.join('\n')) send();
    };
    list.addEventListener('pointermove', move, {signal});
    list.addEventListener('pointerup', end, {signal});
    list.addEventListener('pointercancel', end, {signal});
  });

  attach(props, line, () => {
    line.hidden = model.get('items').length < 2;
    // Only other things are drawn anew: the order is the reader's, who may have gone on before an answer comes.
    if (order().sort().join('\n') !== [...model.get('items')].sort().join('\n')) draw(model.get('items'));
  });
}

export default {initialize, render};
