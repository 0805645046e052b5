/* What became of an answer, at the choices themselves: in the notebook and on the website. */

import {all} from '../../param_tools/panel/dom.js';

/**
 * Mark the right choice with ✓, and the chosen one with ✗ if it is another; the style sheet draws them.
 * @param {HTMLElement} form
 * @param {string} right The right choice; empty as long as nothing is to be marked.
 */
export function markChoices(form, right) {
  for (const box of all(form, 'input[type=radio]', HTMLInputElement)) {
    const mark = box.value === right ? 'right' : box.checked ? 'wrong' : '';
    const label = /** @type {HTMLElement} */ (box.parentElement);
    if (right && mark) label.dataset.mark = mark;
    else delete label.dataset.mark;
  }
}
