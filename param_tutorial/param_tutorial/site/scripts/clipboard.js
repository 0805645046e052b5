/* Copies texts for the reader. */

import {make} from '../../../param_tools/panel/dom.js';

/**
 * Copy a text, and return whether that worked; a page on a disk may not use the clipboard's newer way in every browser.
 * @param {string} text
 */
export async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = make('textarea', {value: text});
    document.body.append(area);
    area.select();
    const done = document.execCommand('copy');
    area.remove();
    return done;
  }
}
