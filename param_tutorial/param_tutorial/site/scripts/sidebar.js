/* The list of lessons stands where the reader is: at this lesson, and at the section in sight. */

import {all} from '../../../param_tools/panel/dom.js';

/** Follow what the reader reads, from now on. */
export function followReading() {
  const list = document.querySelector('.bd-sidebar-primary');
  const links = all(document, '.bd-docs-nav .current ul a', HTMLAnchorElement);
  const sections = links.map(({hash}) => document.getElementById(decodeURIComponent(hash.slice(1))));

  /** @param {Element | null | undefined} link */
  function bringIntoSight(link) {
    if (!list || !link) return;
    const [box, place] = [list.getBoundingClientRect(), link.getBoundingClientRect()];
    if (place.top < box.top || place.bottom > box.bottom) list.scrollTop += place.top - box.top - box.height / 3;
  }

  function mark() {
    const here = links[sections.findLastIndex(each => each && each.getBoundingClientRect().top < innerHeight / 3)];
    if (here?.ariaCurrent) return;
    for (const link of links) link.ariaCurrent = link === here ? 'location' : null;
    bringIntoSight(here);
  }

  // The theme's script has by then put the list where it was on the page before.
  addEventListener('load', () => bringIntoSight(document.querySelector('.bd-docs-nav .current > a')));
  mark();
  addEventListener('scroll', mark, {passive: true});
}
