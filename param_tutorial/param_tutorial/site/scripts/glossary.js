/* The words of the course on a page of the website: the first use of each in a section is marked. */

import {all} from '../../../param_tools/panel/dom.js';
import {entriesOf, markerOf} from '../../notebook/terms.js';

const PROSE = ['p', 'ul > li', 'ol > li', 'blockquote p'].map(each => `.bd-article section > ${each}`).join();

export function beginGlossary() {
  const script = /** @type {HTMLElement | null} */ (document.querySelector('.lesson-glossary'));
  if (!script) return;
  const mark = markerOf(entriesOf(JSON.parse(script.textContent ?? '{}'), script.dataset.chapter ?? ''));
  /** @type {Map<Element | null, Set<number>>} */
  const seenIn = new Map();
  for (const block of all(document, PROSE)) {
    const section = block.closest('section');
    const seen = seenIn.get(section) ?? new Set();
    seenIn.set(section, seen);
    mark(block, seen);
  }
}
