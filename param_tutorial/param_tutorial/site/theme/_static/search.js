/* The search: finds sections as one types, from a disk too, and shows the words in a sentence.

   A section stands the higher the more of what was typed it has, in its heading before its text, in its text before its
   code, and as whole words before parts of words. */
'use strict';

(() => {
  const AT_ONCE = 10;
  const EXCERPT = 170;
  // What a match is worth: the whole word, another form of it, the beginning of a longer one, the inside of one.
  const WHOLE = 1, FORM = 0.6, BEGINNING = 0.2, INSIDE = 0.05;
  const WORTH = {heading: 5, title: 1.5, prose: 2, code: 0.8};
  const ENDINGS = /(?:ing|ed|es|s|e)$/;

  /** Load the index when it is first needed: a script, since a page on a disk may not fetch anything. */
  let loading = null;
  function load() {
    loading ||= new Promise((resolve, reject) => {
      const script = document.createElement('script');
      script.src = `${document.documentElement.dataset.content_root}searchindex.js`;
      script.onload = () => resolve(prepare(globalThis.LESSONS_INDEX));
      script.onerror = () => { loading = null; reject(new Error('The index of the search can’t be loaded.')); };
      document.head.append(script);
    });
    return loading;
  }

  function prepare(pages) {
    const sections = pages.flatMap(({page, title, lesson, sections}) => sections.map(({anchor, heading, prose, code}) => ({
      page, lesson, texts: {heading, title: heading === title ? '' : title, prose, code},
      href: `${document.documentElement.dataset.content_root}${page}.html${anchor && `#${encodeURIComponent(anchor)}`}`})));
    for (const section of sections) {
      section.plain = Object.fromEntries(Object.entries(section.texts).map(([field, text]) => [field, plain(text)]));
    }
    return sections;
  }

  /** Give a text as it is compared; each letter stays where it is. */
  function plain(text) {
    return text.replace(/[A-Z]/g, letter => letter.toLowerCase()).replace(/[‘’]/g, '\'').replace(/[“”]/g, '"');
  }

  function wordsOf(query) {
    return [...new Set(plain(query).split(/\s+/).map(word => word.replace(/^"+|"+$|[,;!?]+$/g, '')).filter(Boolean))];
  }

  const isLetter = letter => /[\p{L}\p{N}_]/u.test(letter || '');
  // A hyphen between letters is part of a word: read-only is not the word read.
  const goesOnBefore = (text, at) => isLetter(text[at - 1]) || (text[at - 1] === '-' && isLetter(text[at - 2]));
  const goesOnAfter = (text, at) => isLetter(text[at]) || (text[at] === '-' && isLetter(text[at + 1]));

  /** Give where a word stands in a text, and what each place is worth. */
  function* matchesOf(word, text) {
    const stem = word.length > 4 ? word.replace(ENDINGS, '') : word;
    const sought = stem.length > 3 ? stem : word;
    for (let at = text.indexOf(sought); at >= 0; at = text.indexOf(sought, at + 1)) {
      let end = at + sought.length;
      while (goesOnAfter(text, end)) end += 1;
      const found = text.slice(at, end);
      const begins = !isLetter(word[0]) || !goesOnBefore(text, at);
      if (begins && (found === word || !isLetter(word.at(-1)) && found.startsWith(word))) {
        yield {at, end: at + word.length, worth: WHOLE};
      } else if (begins && sought.length > 2 && found.replace(ENDINGS, '') === sought) {
        yield {at, end, worth: FORM};
      } else if (found.startsWith(word) && (begins || word.length > 2)) {
        yield {at, end: at + word.length, worth: begins ? BEGINNING : INSIDE};
      }
    }
  }

  /** Raise what stands in a lesson that speaks of it all along, and lower what is no lesson. */
  function weighPages(hits) {
    const pages = {};
    for (const {section: {page}, told} of hits) pages[page] = (pages[page] || 0) + told;
    const most = Math.max(...Object.values(pages));
    for (const hit of hits) hit.score *= hit.section.lesson ? 1 + pages[hit.section.page] / most : 0.5;
  }

  /** Give the sections that have all words, or, if there are none, those that have some; the best ones first. */
  function find(sections, query) {
    const words = wordsOf(query);
    const hits = [];
    for (const section of sections) {
      const hit = {section, score: 0, told: 0, count: 0, isWhole: true, matches: {}};
      for (const word of words) {
        let score = 0;
        let isWhole = false;
        for (const [field, text] of Object.entries(section.plain)) {
          const found = [...matchesOf(word, text)];
          if (!found.length) continue;
          (hit.matches[field] ||= []).push(...found.map(each => ({...each, word})));
          const best = Math.max(...found.map(each => each.worth));
          isWhole ||= best >= FORM;
          const often = found.reduce((sum, each) => sum + each.worth, 0);
          // The tenth time says less than the first, and once says more in a short text than in a long one.
          score += WORTH[field] * Math.max(best * 0.5, often / (often + 1 + text.length / 600));
          if (field === 'prose') hit.told += often;
        }
        if (score) { hit.score += score; hit.count += 1; hit.isWhole &&= isWhole; }
      }
      if (words.length > 1 && ['heading', 'prose', 'code'].some(field => section.plain[field].includes(words.join(' ')))) {
        hit.score *= 1.5;
      }
      // The title alone would bring all sections of a chapter.
      if (Object.keys(hit.matches).some(field => field !== 'title')) hits.push(hit);
    }
    weighPages(hits);
    const most = hits.some(hit => hit.count === words.length) ? words.length : 1;
    return {words, all: most === words.length, hits: hits.filter(hit => hit.count >= most)
      .sort((one, other) => other.count - one.count || other.isWhole - one.isWhole || other.score - one.score)};
  }

  /** Append a part of a text to an element, with what was sought marked. */
  function appendMarked(element, text, matches, from = 0, to = text.length) {
    const sorted = matches.filter(each => each.at >= from && each.end <= to).sort((one, other) => one.at - other.at);
    const best = Math.max(...sorted.map(each => each.worth));
    let done = from;
    for (const {at, end, worth} of sorted) {
      // Beside a whole word, parts of others would lead astray.
      if (at < done || (best >= FORM && worth < FORM)) continue;
      element.append(text.slice(done, at), Object.assign(document.createElement('mark'), {textContent: text.slice(at, end)}));
      done = end;
    }
    element.append(text.slice(done, to));
  }

  /** Give the part of a text in which most of the words stand, from a word's beginning to a word's end. */
  function excerptOf(text, matches) {
    const value = start => {
      const best = {};
      for (const {at, end, word, worth} of matches) {
        if (at >= start && end <= start + EXCERPT) best[word] = Math.max(best[word] || 0, worth);
      }
      return Object.values(best).reduce((sum, worth) => sum + worth, 0);
    };
    const starts = matches.map(({at}) => Math.max(0, at - 50));
    let from = starts.reduce((best, start) => (value(start) > value(best) ? start : best), starts[0] ?? 0);
    let to = Math.min(text.length, from + EXCERPT);
    const space = from && text.indexOf(' ', from);
    if (space > 0 && !matches.some(({at}) => at < space && at >= from)) from = space + 1;
    if (to < text.length && text.lastIndexOf(' ', to) > from) to = Math.max(text.lastIndexOf(' ', to), ...matches.map(
      ({end}) => (end <= to ? end : 0)));
    return [from, to];
  }

  function drawHit({section, matches}, id) {
    const link = Object.assign(document.createElement('a'), {id, href: section.href, className: 'search-hit', tabIndex: -1});
    link.setAttribute('role', 'option');
    link.setAttribute('aria-selected', 'false');
    const line = (name, content) => {
      const element = Object.assign(document.createElement('span'), {className: name});
      content(element);
      link.append(element, ' ');
    };
    line('search-heading', each => appendMarked(each, section.texts.heading, matches.heading || []));
    if (section.texts.title) line('search-page', each => each.append(section.texts.title));
    const field = matches.prose || !matches.code ? 'prose' : 'code';
    const found = matches[field] || [];
    const wholes = found.some(each => each.worth >= FORM) || !matches.code?.some(each => each.worth >= FORM);
    const shown = wholes ? field : 'code';
    const [from, to] = excerptOf(section.texts[shown], matches[shown] || []);
    line(`search-excerpt search-${shown}`, each => {
      if (from) each.append('… ');
      appendMarked(each, section.texts[shown], matches[shown] || [], from, to);
      if (to < section.texts[shown].length) each.append(' …');
    });
    return link;
  }

  /** A box to type into and the list of what is found: a combobox, see https://www.w3.org/WAI/ARIA/apg/patterns/combobox/. */
  class Search {
    constructor(form) {
      this.form = form;
      this.box = form.querySelector('input');
      this.list = form.querySelector('[role=listbox]');
      this.status = form.querySelector('[role=status]');
      // The page of the search shows all, the dialog over another page the first ones.
      this.isPage = 'page' in form.dataset;
      this.typed = 0;
      this.box.addEventListener('focus', () => load().catch(() => {}));
      this.box.addEventListener('input', () => this.search());
      this.box.addEventListener('keydown', event => this.press(event));
      form.addEventListener('submit', event => this.submit(event));
      if (this.isPage) {
        this.box.value = new URLSearchParams(location.search).get('q') || '';
        this.box.focus();
      }
      if (this.box.value) this.search();
    }

    get hits() { return [...this.list.children]; }

    get chosen() { return this.list.querySelector('[aria-selected=true]'); }

    async search() {
      const query = this.box.value.trim();
      this.typed += 1;
      const typed = this.typed;
      let sections;
      try {
        sections = await load();
      } catch (error) {
        this.status.textContent = error.message;
        return;
      }
      if (typed !== this.typed) return;
      if (this.isPage) history.replaceState(null, '', query ? `?q=${encodeURIComponent(query)}` : location.pathname);
      this.show(query ? find(sections, query) : {words: [], all: true, hits: []});
    }

    show({words, all, hits}) {
      const shown = this.isPage ? hits : hits.slice(0, AT_ONCE);
      const options = shown.map((hit, index) => drawHit(hit, `${this.list.id}-${index}`));
      if (shown.length < hits.length) {
        const more = Object.assign(document.createElement('a'), {id: `${this.list.id}-all`, className: 'search-hit search-all',
          href: `${this.form.getAttribute('action')}?q=${encodeURIComponent(this.box.value.trim())}`, tabIndex: -1,
          textContent: `All ${hits.length} sections`});
        more.setAttribute('role', 'option');
        more.setAttribute('aria-selected', 'false');
        options.push(more);
      }
      this.list.replaceChildren(...options);
      this.list.hidden = !options.length;
      this.list.scrollTop = 0;
      this.box.setAttribute('aria-expanded', String(Boolean(options.length)));
      this.box.removeAttribute('aria-activedescendant');
      const count = hits.length === 1 ? '1 section' : `${hits.length || 'No'} sections`;
      this.status.textContent = !words.length ? ''
        : !hits.length ? 'Nothing found.'
        : all ? `${count} found.`
        : `No section has all of these words. ${count} with some of them.`;
    }

    press(event) {
      const {hits} = this;
      const at = hits.indexOf(this.chosen);
      const next = {ArrowDown: at + 1, ArrowUp: at < 0 ? hits.length - 1 : at - 1}[event.key];
      if (event.key === 'Escape' && this.isPage && this.box.value) {
        this.box.value = '';
        this.search();
      } else if (next !== undefined && hits.length) {
        this.choose(hits[next]);
      } else {
        return;
      }
      event.preventDefault();
    }

    /** Choose a hit; beyond the first and the last one nothing is chosen, and the box has the word again. */
    choose(hit) {
      this.chosen?.setAttribute('aria-selected', 'false');
      this.box.removeAttribute('aria-activedescendant');
      if (!hit) return;
      hit.setAttribute('aria-selected', 'true');
      this.box.setAttribute('aria-activedescendant', hit.id);
      hit.scrollIntoView({block: 'nearest'});
    }

    submit(event) {
      if (this.chosen) {
        event.preventDefault();
        this.chosen.click();
      } else if (this.isPage || !this.box.value.trim()) {
        event.preventDefault();
      }
    }
  }

  function begin() {
    for (const form of document.querySelectorAll('form.bd-search')) new Search(form);
    // A hit may be on this very page.
    const dialog = document.querySelector('#pst-search-dialog');
    dialog?.addEventListener('click', event => { if (event.target.closest('.search-hit')) dialog.close(); });
  }

  if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', begin); else begin();
})();
