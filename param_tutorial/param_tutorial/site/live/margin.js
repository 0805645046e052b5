/* Beside the text of a wide page: the robot and the panels that the section in sight is about, and what nodes and callbacks
   say, with its time. In a narrow window they stand in the text, and a sheet at the foot shows what is out of sight above.

   Views belong to the section of their cells, and to each later section whose heading's cell has the tag `stage`, until a
   section has views of its own: the rule of views/beside_text.js in JupyterLab. */

import {all, make} from '../../../param_tools/panel/dom.js';

const BESIDE = '.side-by-side, .robot-picture, .robot-view, .param-panel';
// As in the style sheet.
const WIDE = matchMedia('(min-width: 1280px)');
/** The text in sight is the last that begins above this part of the height. */
const IN_SIGHT = 2 / 3;
const MAX_LINES = 200;

/** @typedef {import('./widgets.js').View} View */

/** What stands beside the text of a page, or at its foot. */
export class Margin {
  /** What stands here. @type {View[]} */
  shown = [];
  /** True if the reader has asked for the views above this section, which is not about them. */
  isWanted = false;
  /** True if the reader has opened the sheet. */
  isOpen = false;
  /** Of the section in sight. @type {Element | undefined} */
  heading;
  isDue = false;
  /** True if the last line of the log has not come to its end. */
  isInLine = false;
  strip = make('button', {type: 'button', className: 'live-strip', hidden: true});
  body = make('div');
  log = make('ol', {className: 'live-log', tabIndex: 0, hidden: true});
  element = make('aside', {className: 'live-margin', tabIndex: -1}, this.strip, this.body, this.log);

  /** @param {() => View[]} views Returns all of the page, from its top to its end. */
  constructor(views) {
    this.views = views;
    this.headings = all(document, '.bd-article section > h2');
    this.element.setAttribute('aria-label', 'Beside the text');
    this.log.setAttribute('aria-label', 'What nodes and callbacks said');
    document.querySelector('.bd-content')?.append(this.element);
    this.strip.addEventListener('click', () => this.press());
    const update = () => this.update();
    addEventListener('scroll', update, {passive: true});
    WIDE.addEventListener('change', update);
    for (const end of ['pointerleave', 'focusout']) this.element.addEventListener(end, update);
    new ResizeObserver(update).observe(document.body);
    addEventListener('beforeprint', () => this.put([]));
    addEventListener('afterprint', update);
  }

  /** Let a view stand here if it is of a kind that does. @param {View} view */
  take(view) {
    // The first page is no lesson, and has no room beside its text.
    if (!document.querySelector('.lesson') || !view.inner.querySelector(BESIDE)) return;
    const button = make('button', {type: 'button', className: 'live-to-margin'}, 'Shown at the right →');
    button.addEventListener('click', () => this.goTo(view));
    view.element.classList.add('live-home');
    view.element.append(button);
    this.update();
  }

  /** @param {View} view */
  goTo(view) {
    if (!this.shown.includes(view)) view.element.scrollIntoView({block: 'center'});
    // What was used before need not stay.
    this.element.focus();
    this.look();
  }

  /** Show the views, or no longer. */
  press() {
    if (WIDE.matches) this.isWanted = true;
    else this.isOpen = !this.isOpen;
    this.look();
  }

  /** Look in the next frame what is to be shown. */
  update() {
    if (!this.isDue) requestAnimationFrame(() => this.look());
    this.isDue = true;
  }

  /** Show what the text in sight is about. */
  look() {
    this.isDue = false;
    const {views, isAbout} = this.inSight();
    // What a reader uses stays.
    const isThere = this.shown.some(view => this.views().includes(view));
    if (isThere && this.body.matches(':hover, :has(:focus-visible)')) return;
    const isAbove = views.some(({element}) => element.getBoundingClientRect().bottom < 0);
    const isOffered = WIDE.matches ? views.length && !isAbout : isAbove && isAbout;
    const isHere = WIDE.matches ? isAbout : isOffered && this.isOpen;
    this.element.classList.toggle('is-open', Boolean(isHere));
    this.strip.hidden = !isOffered;
    this.strip.textContent = `${isHere ? '▾' : '▸'} ${[...new Set(views.map(nodesOf))].join(' and ')}`;
    this.put(isHere ? views : []);
  }

  /** Return the views of the section in sight, or those above it, and whether they are to be seen with this section. */
  inSight() {
    const isReached = (/** @type {Element} */ each) => each.getBoundingClientRect().top <= IN_SIGHT * innerHeight;
    const here = this.headings.findLastIndex(isReached);
    if (this.headings[here] !== this.heading) this.isWanted = false;
    this.heading = this.headings[here];
    const homes = this.views().filter(
      ({element}) => element.isConnected && element.matches('.live-home') && !element.closest('.lesson-folded'),
    );
    // Before the first heading it is -1.
    const sections = homes.map(({element}) => this.headings.findLastIndex(each => isBelow(element, each)));
    const section = Math.max(...sections.filter(each => each <= here));
    /** @type {Map<string, View>} */
    const views = new Map();
    for (const view of homes.filter((_, at) => sections[at] === section)) {
      // The same robot again takes the place of the one before when the text has come there.
      const name = `${view.inner.firstElementChild?.className} ${nodesOf(view)}`;
      if (!views.has(name) || isReached(view.element)) views.set(name, view);
    }
    const isStage = this.heading?.parentElement?.querySelector(':scope > .lesson-stage');
    return {views: [...views.values()], isAbout: section === here || Boolean(isStage) || this.isWanted};
  }

  /** @param {View[]} views What stands here from now on; other views go back into the text. */
  put(views) {
    if (views.length === this.shown.length && views.every((each, at) => each === this.shown[at])) return;
    for (const {element, inner} of this.shown) {
      element.prepend(inner);
      element.style.minHeight = '';
    }
    // Nothing in the text moves.
    if (!WIDE.matches)
      for (const {element} of views) element.style.minHeight = `${element.getBoundingClientRect().height}px`;
    this.body.append(...views.map(({inner}) => inner));
    this.shown = views;
  }

  /**
   * Add to the log.
   * @param {number} time_ms Since 1970.
   * @param {string} text Lines, or a part of one that the next text goes on with.
   */
  say(time_ms, text) {
    const {scrollTop, clientHeight, scrollHeight} = this.log;
    for (const line of text.split(/(?<=\n)/)) {
      const time = make('time', {}, new Date(time_ms).toLocaleTimeString('en-GB'));
      if (!this.isInLine) this.log.append(make('li', {}, time, ' '));
      this.log.lastChild?.appendChild(new Text(line.replace(/\n$/, '')));
      this.isInLine = !line.endsWith('\n');
    }
    while (this.log.childElementCount > MAX_LINES) this.log.firstChild?.remove();
    this.log.hidden = false;
    // Who reads an earlier line goes on reading it.
    if (scrollTop + clientHeight > scrollHeight - 5) this.log.scrollTop = this.log.scrollHeight;
  }
}

/** @param {Element} one @param {Element} other */
function isBelow(one, other) {
  return Boolean(other.compareDocumentPosition(one) & Node.DOCUMENT_POSITION_FOLLOWING);
}

/** Return the names of the nodes that a view shows, or what else it is. @param {View} view */
function nodesOf({handles, inner}) {
  const named = [...handles.values()].map(handle => handle.get('nodes')).find(Boolean);
  const names = all(inner, '.param-node, .robot-node').map(each => each.textContent);
  return named ?? (names.join(' and ') || (inner.querySelector('.param-panel') ? 'parameters' : 'the robot'));
}
