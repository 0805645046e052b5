/* The words of the course in a text: each shows its meaning to a mouse, to the keyboard, to a finger, and to a screen
   reader. They come from the tables at the ends of the chapters; see `terms.py`. */

import {make} from '../../param_tools/panel/dom.js';

/** @typedef {{chapter: string, code: boolean, meaning: string}} Meaning What one chapter says about a word. */
/** @typedef {{word: string, meaning: string, code: boolean}} Entry */

const NOT_PROSE = 'a, button, summary, .lesson-download, .lesson-look, .lesson-term';

/**
 * Return the words as a chapter uses them: of several meanings of a word it has its own, or the latest before it.
 * @param {Record<string, Meaning[]>} words
 * @param {string} chapter Its number.
 * @returns {Entry[]}
 */
export function entriesOf(words, chapter) {
  const isKnown = (/** @type {Meaning} */ each) => place(each.chapter) <= place(chapter);
  return Object.entries(words).map(([word, meanings]) => {
    const {code, meaning} = meanings.findLast(isKnown) ?? meanings[0];
    return {word, code, meaning};
  });
}

/** @param {string} chapter */
function place(chapter) {
  const [part, section = 0] = chapter.split('.').map(Number);
  return part * 100 + section;
}

/**
 * Return what finds one of the words, alone or with an ending; of two that begin alike the longer one.
 * @param {Iterable<string>} words
 */
export function patternOf(words) {
  const longestFirst = [...words].sort((one, other) => other.length - one.length);
  const escaped = longestFirst.map(word => word.replace(/[.*+?^${}()|[\]\\/]/g, '\\$&').replaceAll(' ', '\\s+'));
  return new RegExp(`(?<![\\p{L}\\d_/.-])(${escaped.join('|')})(?:s|es|d|ed)?(?![\\p{L}\\d_/-])`, 'giu');
}

/**
 * Return what marks the words in a block of text. Those that it finds in a set of numbers are left alone, and those that
 * it marks are added there.
 * @param {Entry[]} entries
 * @returns {(block: Element, seen: Set<number>) => void}
 */
export function markerOf(entries) {
  const numbers = new Map(entries.map(({word}, number) => [word.toLowerCase(), number]));
  const words = patternOf(numbers.keys());
  return (block, seen) => {
    for (let text of textsOf(block)) {
      const code = text.parentElement?.closest('code');
      words.lastIndex = 0;
      for (let found = words.exec(text.data); found; found = words.exec(text.data)) {
        const number = numbers.get(found[1].toLowerCase().replace(/\s+/g, ' ')) ?? 0;
        // Code is a word of the course if it is nothing else.
        if (seen.has(number) || (code ? code.textContent !== found[0] : entries[number].code)) continue;
        seen.add(number);
        const term = text.splitText(found.index);
        text = term.splitText(found[0].length);
        words.lastIndex = 0;
        describe(term, number, entries[number]);
      }
    }
  };
}

/**
 * Return the texts of a block in which words are marked.
 * @param {Node} block
 */
function textsOf(block) {
  const texts = [];
  const walker = document.createTreeWalker(block, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const text = /** @type {Text} */ (walker.currentNode);
    if (!text.parentElement?.closest(NOT_PROSE)) texts.push(text);
  }
  return texts;
}

/**
 * Make a term of a piece of text.
 * @param {Text} text
 * @param {number} number
 * @param {Entry} entry
 */
function describe(text, number, {meaning}) {
  const term = make('span', {className: 'lesson-term', tabIndex: 0});
  term.dataset.number = String(number);
  term.setAttribute('role', 'button');
  term.setAttribute('aria-description', make('div', {innerHTML: meaning}).textContent ?? '');
  text.before(term);
  term.append(text);
  term.addEventListener('pointerenter', event => {
    if (event.pointerType !== 'touch') show(term, meaning);
  });
  term.addEventListener('pointerleave', hideSoon);
  term.addEventListener('focus', () => show(term, meaning));
  term.addEventListener('blur', hide);
  term.addEventListener('click', () => show(term, meaning));
  term.addEventListener('keydown', event => {
    if (event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    show(term, meaning);
  });
}

/** @type {HTMLElement | undefined} */
let box;
/** @type {ReturnType<typeof setTimeout> | undefined} */
let leaving;

function makeBox() {
  const made = make('div', {className: 'lesson-meaning'});
  // A screen reader has the word's description.
  made.setAttribute('aria-hidden', 'true');
  addEventListener('keydown', event => {
    if (event.key === 'Escape') hide();
  });
  // You may move there, to select the words.
  made.addEventListener('pointerenter', () => clearTimeout(leaving));
  made.addEventListener('pointerleave', hideSoon);
  document.body.append(made);
  return made;
}

/**
 * Show a meaning below its word, or above it where there is no room.
 * @param {Element} term
 * @param {string} meaning
 */
function show(term, meaning) {
  clearTimeout(leaving);
  box ??= makeBox();
  box.innerHTML = meaning;
  box.hidden = false;
  const [line] = term.getClientRects();
  const {width, height} = box.getBoundingClientRect();
  const room = document.documentElement.clientWidth;
  const below = line.bottom + height + 8 < innerHeight;
  box.style.left = `${scrollX + Math.max(8, Math.min(line.left, room - width - 8))}px`;
  box.style.top = `${scrollY + (below ? line.bottom + 2 : line.top - height - 2)}px`;
}

export function hide() {
  clearTimeout(leaving);
  if (box) box.hidden = true;
}

/** Hide the meaning unless the pointer goes on to it. */
function hideSoon() {
  clearTimeout(leaving);
  leaving = setTimeout(hide, 250);
}
