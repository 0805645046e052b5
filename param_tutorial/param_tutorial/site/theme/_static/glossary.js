/* The words of the course in the text of a lesson: the first use of each in a section shows its meaning to a mouse, to
   the keyboard, to a finger, and to a screen reader. They come with the page; see pages/terms.py. */
'use strict';

(() => {
  // Where prose stands, and what in it is none.
  const PROSE = ['p', 'ul > li', 'ol > li', 'blockquote p'].map(each => `.bd-article section > ${each}`).join();
  const NOT_PROSE = 'a, button, summary, .lesson-download, .lesson-look, .lesson-term';

  /** Give what finds one of the words, alone or with an ending; of two that begin alike the longer one. */
  function pattern(words) {
    const longestFirst = [...words].sort((one, other) => other.length - one.length);
    const escaped = longestFirst.map(word => word.replace(/[.*+?^${}()|[\]\\/]/g, '\\$&').replaceAll(' ', '\\s+'));
    return new RegExp(`(?<![\\p{L}\\d_/.-])(${escaped.join('|')})(?:s|es|d|ed)?(?![\\p{L}\\d_/-])`, 'giu');
  }

  /** Mark the words in the sections of the page. */
  function mark(entries) {
    const numbers = new Map(entries.map(({word}, number) => [word.toLowerCase(), number]));
    const words = pattern(numbers.keys());
    const seenIn = new Map();
    for (const block of document.querySelectorAll(PROSE)) {
      const section = block.closest('section');
      if (!seenIn.has(section)) seenIn.set(section, new Set());
      const seen = seenIn.get(section);
      const texts = [];
      const walker = document.createTreeWalker(block, NodeFilter.SHOW_TEXT);
      while (walker.nextNode()) if (!walker.currentNode.parentElement.closest(NOT_PROSE)) texts.push(walker.currentNode);
      for (let text of texts) {
        const code = text.parentElement.closest('code');
        words.lastIndex = 0;
        for (let found = words.exec(text.data); found; found = words.exec(text.data)) {
          const number = numbers.get(found[1].toLowerCase().replace(/\s+/g, ' '));
          // Code is a word of the course if it is nothing else.
          if (seen.has(number) || (code ? code.textContent !== found[0] : entries[number].code)) continue;
          seen.add(number);
          const term = text.splitText(found.index);
          text = term.splitText(found[0].length);
          words.lastIndex = 0;
          describe(term, number, entries[number]);
        }
      }
    }
  }

  /** Make a term of a piece of text. */
  function describe(text, number, {meaning}) {
    const id = `lesson-meaning-${number}`;
    if (!document.getElementById(id)) {
      document.body.append(Object.assign(document.createElement('span'), {id, hidden: true, textContent: plain(meaning)}));
    }
    const term = Object.assign(document.createElement('span'), {className: 'lesson-term', tabIndex: 0});
    term.setAttribute('role', 'button');
    term.setAttribute('aria-describedby', id);
    text.before(term);
    term.append(text);
    term.addEventListener('pointerenter', event => event.pointerType !== 'touch' && show(term, meaning));
    term.addEventListener('pointerleave', () => hideSoon());
    term.addEventListener('focus', () => show(term, meaning));
    term.addEventListener('blur', hide);
    term.addEventListener('click', () => show(term, meaning));
    term.addEventListener('keydown', event => {
      if (event.key !== 'Enter' && event.key !== ' ') return;
      event.preventDefault();
      show(term, meaning);
    });
  }

  function plain(meaning) {
    return Object.assign(document.createElement('div'), {innerHTML: meaning}).textContent;
  }

  let box = null;
  let leaving = 0;

  /** Show a meaning below its word, or above it where there is no room. */
  function show(term, meaning) {
    clearTimeout(leaving);
    if (!box) {
      box = Object.assign(document.createElement('div'), {className: 'lesson-meaning'});
      // A screen reader has the word's description.
      box.setAttribute('aria-hidden', 'true');
      // You may move there, to select the words.
      box.addEventListener('pointerenter', () => clearTimeout(leaving));
      box.addEventListener('pointerleave', () => hideSoon());
      document.body.append(box);
    }
    box.innerHTML = meaning;
    box.hidden = false;
    const [line] = term.getClientRects();
    const {width, height} = box.getBoundingClientRect();
    const room = document.documentElement.clientWidth;
    const below = line.bottom + height + 8 < innerHeight;
    box.style.left = `${scrollX + Math.max(8, Math.min(line.left, room - width - 8))}px`;
    box.style.top = `${scrollY + (below ? line.bottom + 2 : line.top - height - 2)}px`;
  }

  function hide() {
    clearTimeout(leaving);
    if (box) box.hidden = true;
  }

  /** Hide it unless the pointer goes on to the meaning itself. */
  function hideSoon() {
    clearTimeout(leaving);
    leaving = setTimeout(hide, 250);
  }

  function begin() {
    const script = document.querySelector('.lesson-glossary');
    if (!script) return;
    mark(JSON.parse(script.textContent));
    addEventListener('keydown', event => { if (event.key === 'Escape') hide(); });
  }

  if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', begin); else begin();
})();
