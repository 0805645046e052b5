/* Finds sections by the words in them, and the places to mark in each. No element of a page is needed for it.

   A section stands the higher the more of what was typed it has, in its heading before its text, in its text before its
   code, and as whole words before parts of words. */

/**
 * @typedef {'heading' | 'title' | 'prose' | 'code'} Field
 *
 * A section of a page, and its texts; `title` is the page's, or empty in the section that begins the page.
 * @typedef {{page: string, lesson: boolean, anchor: string, texts: Record<Field, string>,
 *   plain: Record<Field, string>}} Section
 *
 * Where a word stands in a text, and what that place is worth.
 * @typedef {{at: number, end: number, worth: number}} Place
 *
 * @typedef {Place & {word: string}} Match
 *
 * @typedef {{section: Section, score: number, told: number, count: number, isWhole: boolean,
 *   matches: Partial<Record<Field, Match[]>>}} Hit
 */

// What a match is worth: the whole word, another form of it, the beginning of a longer one, the inside of one.
const WHOLE = 1;
export const FORM = 0.6;
const BEGINNING = 0.2;
const INSIDE = 0.05;
const WORTH = {heading: 5, title: 1.5, prose: 2, code: 0.8};
const FIELDS = /** @type {Field[]} */ (Object.keys(WORTH));
const ENDINGS = /(?:ing|ed|es|s|e)$/;
const EXCERPT = 170;

/**
 * Return the sections of all pages, as `pages/search_index.py` writes them, with what they are searched by.
 * @param {{page: string, title: string, lesson: boolean,
 *   sections: {anchor: string, heading: string, prose: string, code: string}[]}[]} pages
 * @returns {Section[]}
 */
export function sectionsOf(pages) {
  return pages.flatMap(({page, title, lesson, sections}) =>
    sections.map(({anchor, heading, prose, code}) => {
      const texts = {heading, title: heading === title ? '' : title, prose, code};
      const compared = FIELDS.map(field => [field, plain(texts[field])]);
      return {page, lesson, anchor, texts, plain: Object.fromEntries(compared)};
    }),
  );
}

/**
 * Return a text as it is compared; each letter stays where it is.
 * @param {string} text
 */
function plain(text) {
  return text
    .replace(/[A-Z]/g, letter => letter.toLowerCase())
    .replace(/[‘’]/g, "'")
    .replace(/[“”]/g, '"');
}

/** @param {string} query */
export function wordsOf(query) {
  const words = plain(query).split(/\s+/);
  return [...new Set(words.map(word => word.replace(/^"+|"+$|[,;!?]+$/g, '')).filter(Boolean))];
}

/** @param {string | undefined} letter */
function isLetter(letter) {
  return /[\p{L}\p{N}_]/u.test(letter ?? '');
}

/**
 * Say whether a word goes on before or after a place. A hyphen between letters is part of a word: read-only is not the
 * word read.
 * @param {string} text
 * @param {number} at
 * @param {-1 | 1} step
 */
function goesOn(text, at, step) {
  return isLetter(text[at]) || (text[at] === '-' && isLetter(text[at + step]));
}

/**
 * Yield the places where a word stands in a text.
 * @param {string} word
 * @param {string} text Plain.
 * @returns {Generator<Place>}
 */
export function* matchesOf(word, text) {
  const stem = word.length > 4 ? word.replace(ENDINGS, '') : word;
  const sought = stem.length > 3 ? stem : word;
  for (let at = text.indexOf(sought); at >= 0; at = text.indexOf(sought, at + 1)) {
    let end = at + sought.length;
    while (goesOn(text, end, 1)) end += 1;
    const found = text.slice(at, end);
    const begins = !isLetter(word[0]) || !goesOn(text, at - 1, -1);
    if (begins && (found === word || (!isLetter(word.at(-1)) && found.startsWith(word)))) {
      yield {at, end: at + word.length, worth: WHOLE};
    } else if (begins && sought.length > 2 && found.replace(ENDINGS, '') === sought) {
      yield {at, end, worth: FORM};
    } else if (found.startsWith(word) && (begins || word.length > 2)) {
      yield {at, end: at + word.length, worth: begins ? BEGINNING : INSIDE};
    }
  }
}

/**
 * Return the sections that have all words of a query, or, if there are none, those that have some; the best ones first.
 * @param {Section[]} sections
 * @param {string} query
 */
export function find(sections, query) {
  const words = wordsOf(query);
  const hits = sections.map(section => look(section, words));
  // The title alone would bring all sections of a chapter.
  const found = hits.filter(({matches}) => FIELDS.some(field => field !== 'title' && matches[field]));
  weighPages(found);
  const isAll = found.some(hit => hit.count === words.length);
  const least = isAll ? words.length : 1;
  const best = found
    .filter(hit => hit.count >= least)
    .sort(
      (one, other) => other.count - one.count || Number(other.isWhole) - Number(one.isWhole) || other.score - one.score,
    );
  return {words, isAll, hits: best};
}

/**
 * Return a text with spaces for the hyphens between words that were typed one after the other: "read only" finds read-only.
 * @param {string} text
 * @param {string[]} words
 */
function withoutHyphens(text, words) {
  return words
    .slice(1)
    .reduce((loose, word, at) => loose.replaceAll(`${words[at]}-${word}`, `${words[at]} ${word}`), text);
}

/**
 * Return what a section has of some words.
 * @param {Section} section
 * @param {string[]} words
 * @returns {Hit}
 */
function look(section, words) {
  /** @type {Hit} */
  const hit = {section, score: 0, told: 0, count: 0, isWhole: true, matches: {}};
  const texts = FIELDS.map(field => withoutHyphens(section.plain[field], words));
  for (const word of words) {
    let score = 0;
    let isWhole = false;
    for (const [at, field] of FIELDS.entries()) {
      const text = texts[at];
      const found = [...matchesOf(word, text)].map(each => ({...each, word}));
      if (!found.length) continue;
      hit.matches[field] = [...(hit.matches[field] ?? []), ...found];
      const best = Math.max(...found.map(each => each.worth));
      isWhole ||= best >= FORM;
      const often = found.reduce((sum, each) => sum + each.worth, 0);
      // The tenth time says less than the first, and once says more in a short text than in a long one.
      score += WORTH[field] * Math.max(best * 0.5, often / (often + 1 + text.length / 600));
      if (field === 'prose') hit.told += often;
    }
    if (!score) continue;
    hit.score += score;
    hit.count += 1;
    hit.isWhole &&= isWhole;
  }
  const isPhrase = FIELDS.some((field, at) => field !== 'title' && texts[at].includes(words.join(' ')));
  if (words.length > 1 && isPhrase) hit.score *= 1.5;
  return hit;
}

/**
 * Raise what stands in a lesson that speaks of it all along, and lower what is no lesson.
 * @param {Hit[]} hits
 */
function weighPages(hits) {
  /** @type {Record<string, number>} */
  const pages = {};
  for (const {section, told} of hits) pages[section.page] = (pages[section.page] ?? 0) + told;
  const most = Math.max(...Object.values(pages));
  for (const hit of hits) hit.score *= hit.section.lesson ? 1 + pages[hit.section.page] / most : 0.5;
}

/**
 * Return the part of a text in which most of the words stand, from a word's beginning to a word's end.
 * @param {string} text
 * @param {Match[]} matches
 */
export function excerptOf(text, matches) {
  const starts = matches.map(({at}) => Math.max(0, at - 50));
  let from = starts.reduce(
    (best, start) => (worthOf(start, matches) > worthOf(best, matches) ? start : best),
    starts[0] ?? 0,
  );
  let to = Math.min(text.length, from + EXCERPT);
  const space = from && text.indexOf(' ', from);
  if (space > 0 && !matches.some(({at}) => at < space && at >= from)) from = space + 1;
  if (to < text.length && text.lastIndexOf(' ', to) > from) {
    to = Math.max(text.lastIndexOf(' ', to), ...matches.map(({end}) => (end <= to ? end : 0)));
  }
  return [from, to];
}

/**
 * Return what an excerpt is worth that starts at a place.
 * @param {number} start
 * @param {Match[]} matches
 */
function worthOf(start, matches) {
  /** @type {Map<string, number>} */
  const best = new Map();
  for (const {at, end, word, worth} of matches) {
    if (at >= start && end <= start + EXCERPT) best.set(word, Math.max(best.get(word) ?? 0, worth));
  }
  return [...best.values()].reduce((sum, worth) => sum + worth, 0);
}
