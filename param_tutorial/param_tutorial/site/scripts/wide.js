/* What is wider than the page scrolls sideways: texts, so that they keep their shape, and pictures, so that their letters
   keep their size. See the style sheet. */

import DOMPurify from 'dompurify';
import {all} from '../../../param_tools/panel/dom.js';

const TEXTS = '.output .highlight pre, .param-ros1 pre';
const PICTURES = '.motion-scene, .step-scene, .cell_output > .text_html:has(> svg), .param-check:has(> svg)';

// The theme's script does the same for texts.
const sized = new ResizeObserver(entries => {
  for (const {target} of entries) {
    /** @type {HTMLElement} */ (target).tabIndex = target.scrollWidth > target.clientWidth ? 0 : -1;
  }
});

/**
 * Let sentences wrap: lines of a text without indented lines and columns.
 * @param {ParentNode} root
 */
export function wrapSentences(root) {
  for (const text of all(root, TEXTS)) {
    const hasShape = /^[ \t]|\S(?: {2,}|\t)\S/m.test(text.textContent ?? '');
    text.classList.toggle('lesson-sentences', !hasShape);
  }
}

/**
 * Let the keyboard reach pictures, as long as they scroll.
 * @param {ParentNode} root
 */
export function reachPictures(root) {
  for (const picture of all(root, PICTURES)) {
    if (!picture.hasAttribute('role')) {
      picture.setAttribute('role', 'group');
      picture.setAttribute('aria-label', 'A picture as wide as its letters need');
    }
    sized.observe(picture);
  }
}

/**
 * Return HTML without anything that runs a script, or loads or leaves a page by itself.
 * @param {string} html
 */
export const clean = html => DOMPurify.sanitize(html, {FORBID_TAGS: ['form'], FORCE_BODY: true});

/**
 * Draw what may hold a picture anew; it stays where the reader has scrolled to.
 * @param {HTMLElement} element
 * @param {string} html
 */
export function drawAnew(element, html) {
  const scrolled = element.querySelector(PICTURES)?.scrollLeft;
  element.innerHTML = clean(html);
  reachPictures(element);
  if (scrolled) for (const picture of all(element, PICTURES)) picture.scrollLeft = scrolled;
}
