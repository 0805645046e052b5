/* The search: finds sections as one types, from a disk too, and shows the words in a sentence. */

import {all, make, one} from '../../../param_tools/panel/dom.js';
import {excerptOf, FORM, find, sectionsOf} from './matching.js';

/** @import {Hit, Match, Section} from './matching.js' */

const AT_ONCE = 10;

/** @type {Promise<Section[]> | undefined} */
let loading;

/** Load the index when it is first needed: a script, since a page on a disk may not fetch anything. */
function load() {
  loading ??= new Promise((resolve, reject) => {
    const script = make('script', {src: `${document.documentElement.dataset.content_root}searchindex.js`});
    script.onload = () => resolve(sectionsOf(/** @type {any} */ (globalThis).LESSONS_INDEX));
    script.onerror = () => {
      loading = undefined;
      reject(new Error('The index of the search can’t be loaded.'));
    };
    document.head.append(script);
  });
  return loading;
}

/**
 * Append a part of a text to an element, with what was sought marked.
 * @param {HTMLElement} element
 * @param {string} text
 * @param {Match[]} matches
 */
function appendMarked(element, text, matches, from = 0, to = text.length) {
  const sorted = matches.filter(each => each.at >= from && each.end <= to).sort((one, other) => one.at - other.at);
  const best = Math.max(...sorted.map(each => each.worth));
  let done = from;
  for (const {at, end, worth} of sorted) {
    // Beside a whole word, parts of others would lead astray.
    if (at < done || (best >= FORM && worth < FORM)) continue;
    element.append(text.slice(done, at), make('mark', {}, text.slice(at, end)));
    done = end;
  }
  element.append(text.slice(done, to));
}

/**
 * @param {string} id
 * @param {string} href
 * @param {string} className
 */
function makeOption(id, href, className) {
  const link = make('a', {id, href, className: `search-hit ${className}`.trim(), tabIndex: -1});
  link.setAttribute('role', 'option');
  link.setAttribute('aria-selected', 'false');
  return link;
}

/**
 * @param {Hit} hit
 * @param {string} id
 */
function drawHit({section: {page, anchor, texts}, matches}, id) {
  const root = document.documentElement.dataset.content_root;
  const link = makeOption(id, `${root}${page}.html${anchor && `#${encodeURIComponent(anchor)}`}`, '');
  const heading = make('span', {className: 'search-heading'});
  appendMarked(heading, texts.heading, matches.heading ?? []);
  link.append(heading, ' ');
  if (texts.title) link.append(make('span', {className: 'search-page'}, texts.title), ' ');
  // Whole words in the code say more than parts of words in the prose.
  const isWhole = (/** @type {Match[] | undefined} */ found) => found?.some(each => each.worth >= FORM) ?? false;
  const isCode = !isWhole(matches.prose) && (isWhole(matches.code) || Boolean(matches.code && !matches.prose));
  const field = isCode ? 'code' : 'prose';
  const [from, to] = excerptOf(texts[field], matches[field] ?? []);
  const excerpt = make('span', {className: `search-excerpt search-${field}`}, from ? '… ' : '');
  appendMarked(excerpt, texts[field], matches[field] ?? [], from, to);
  if (to < texts[field].length) excerpt.append(' …');
  link.append(excerpt, ' ');
  return link;
}

/** A box to type into and the list of what is found: a combobox, see https://www.w3.org/WAI/ARIA/apg/patterns/combobox/. */
class Search {
  typed = 0;

  /** @param {HTMLFormElement} form */
  constructor(form) {
    this.form = form;
    this.box = one(form, 'input', HTMLInputElement);
    this.list = one(form, '[role=listbox]');
    this.status = one(form, '[role=status]');
    // The page of the search shows all, the dialog over another page the first ones.
    this.isPage = 'page' in form.dataset;
    this.box.addEventListener('focus', () => load().catch(() => {}));
    this.box.addEventListener('input', () => this.search());
    this.box.addEventListener('keydown', event => this.press(event));
    form.addEventListener('submit', event => this.submit(event));
    if (this.isPage) {
      this.box.value = new URLSearchParams(location.search).get('q') ?? '';
      this.box.focus();
    }
    if (this.box.value) this.search();
  }

  get hits() {
    return all(this.list, ':scope > *');
  }

  get chosen() {
    return /** @type {HTMLElement | null} */ (this.list.querySelector('[aria-selected=true]'));
  }

  async search() {
    const query = this.box.value.trim();
    this.typed += 1;
    const typed = this.typed;
    let sections;
    try {
      sections = await load();
    } catch (error) {
      this.status.textContent = /** @type {Error} */ (error).message;
      return;
    }
    if (typed !== this.typed) return;
    if (this.isPage) history.replaceState(null, '', query ? `?q=${encodeURIComponent(query)}` : location.pathname);
    this.show(query ? find(sections, query) : {words: [], isAll: true, hits: []});
  }

  /** @param {ReturnType<typeof find>} found */
  show({words, isAll, hits}) {
    const shown = this.isPage ? hits : hits.slice(0, AT_ONCE);
    const options = shown.map((hit, index) => drawHit(hit, `${this.list.id}-${index}`));
    if (shown.length < hits.length) {
      const href = `${this.form.getAttribute('action')}?q=${encodeURIComponent(this.box.value.trim())}`;
      const more = makeOption(`${this.list.id}-all`, href, 'search-all');
      more.append(`All ${hits.length} sections`);
      options.push(more);
    }
    this.list.replaceChildren(...options);
    this.list.hidden = !options.length;
    this.list.scrollTop = 0;
    this.box.setAttribute('aria-expanded', String(Boolean(options.length)));
    this.box.removeAttribute('aria-activedescendant');
    const count = hits.length === 1 ? '1 section' : `${hits.length} sections`;
    if (!words.length) this.status.textContent = '';
    else if (!hits.length) this.status.textContent = 'Nothing found.';
    else if (isAll) this.status.textContent = `${count} found.`;
    else this.status.textContent = `No section has all of these words. ${count} with some of them.`;
  }

  /** @param {KeyboardEvent} event */
  press(event) {
    const {hits, chosen} = this;
    const at = chosen ? hits.indexOf(chosen) : -1;
    if (event.key === 'Escape' && this.isPage && this.box.value) {
      this.box.value = '';
      this.search();
    } else if (event.key === 'ArrowDown' && hits.length) {
      this.choose(hits[at + 1]);
    } else if (event.key === 'ArrowUp' && hits.length) {
      this.choose(hits[at < 0 ? hits.length - 1 : at - 1]);
    } else {
      return;
    }
    event.preventDefault();
  }

  /**
   * Choose a hit; beyond the first and the last one nothing is chosen, and the box has the word again.
   * @param {HTMLElement | undefined} hit
   */
  choose(hit) {
    this.chosen?.setAttribute('aria-selected', 'false');
    this.box.removeAttribute('aria-activedescendant');
    if (!hit) return;
    hit.setAttribute('aria-selected', 'true');
    this.box.setAttribute('aria-activedescendant', hit.id);
    hit.scrollIntoView({block: 'nearest'});
  }

  /** @param {SubmitEvent} event */
  submit(event) {
    const {chosen} = this;
    if (chosen || this.isPage || !this.box.value.trim()) event.preventDefault();
    chosen?.click();
  }
}

export function beginSearch() {
  for (const form of all(document, 'form.bd-search', HTMLFormElement)) new Search(form);
  // A hit may be on this very page.
  const dialog = /** @type {HTMLDialogElement | null} */ (document.querySelector('#pst-search-dialog'));
  dialog?.addEventListener('click', event => {
    if (/** @type {Element} */ (event.target).closest('.search-hit')) dialog.close();
  });
}
