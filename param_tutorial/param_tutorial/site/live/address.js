/* What the reader has set with the panels of a page, in the page's address: a reload, Back and a link to it keep that.

   The address names the panel's widget, the parameter and its value, in the order in which the parameters were changed:
   a node may accept one only after another. */

import {make, one} from '../../../param_tools/panel/dom.js';

/** @import {Handle} from './widgets.js' */

/** @type {Map<string, string>} */
const settings = new Map();
/** What a hand has changed, the latest last. @type {Set<string>} */
const entered = new Set();

/**
 * Take notice of what a hand does with a panel.
 * @param {Handle} panel
 * @param {any} content
 */
export function noteEntered(panel, content) {
  if (content?.do !== 'enter') return;
  const key = `${panel.place}:${content.name}`;
  entered.delete(key);
  entered.add(key);
}

/**
 * Keep what a hand has changed and differs from the values with which a panel began; a lesson's own cells make theirs anew.
 * @param {Handle} panel
 */
export function keepSettings(panel) {
  /** @type {Record<string, {text: string, first?: string, is_busy?: boolean}>} */
  const rows = panel.get('state').rows;
  for (const [name, {text, first, is_busy}] of Object.entries(rows)) {
    const key = `${panel.place}:${name}`;
    if (is_busy || !entered.has(key)) continue;
    if (first === undefined) settings.delete(key);
    else settings.set(key, text);
  }
  const order = [...entered];
  const sorted = [...settings].sort(([one], [other]) => order.indexOf(one) - order.indexOf(other));
  const query = new URLSearchParams(sorted).toString().replaceAll('%2F', '/').replaceAll('%3A', ':');
  history.replaceState(null, '', `${location.pathname}${query && `?${query}`}${location.hash}`);
}

/**
 * Set what the page's address names, by the panels' own way, and say so where it names what is not there.
 * @param {(widget: string) => Handle | undefined} find
 */
export function followAddress(find) {
  let isLost = false;
  for (const [key, text] of new URLSearchParams(location.search)) {
    const [, widget, name] = /^([^:]+):(.+)$/s.exec(key) ?? [];
    const panel = widget && find(widget);
    if (!panel || !Object.hasOwn(panel.get('state')?.rows ?? {}, name)) {
      isLost = true;
      continue;
    }
    settings.set(key, text);
    entered.add(key);
    panel.send({do: 'enter', name, text, client: '', number: 0, grip: 0});
  }
  if (!isLost) return;
  const note = make('p', {className: 'lesson-download lesson-no-link'});
  note.setAttribute('role', 'status');
  note.textContent = 'The address that brought you here asks for something that is not on this page. It was ignored.';
  one(document, '.bd-article h1').after(note);
}
