/* What the reader has typed into the cells of a page, kept in the browser. A browser that keeps nothing shows the lesson's
   own code again. */

import {createStore, del, entries, set} from 'idb-keyval';
import {here} from '../scripts/progress.js';

const store = createStore('ros2-parameters-code', 'code');

/** Return what was typed on this page, by the ids of the cells. */
export async function keptCode() {
  /** @type {Record<string, string>} */
  const codes = {};
  try {
    for (const [[page, id], code] of await /** @type {Promise<any[]>} */ (entries(store))) {
      if (page === here && typeof code === 'string') codes[id] = code;
    }
  } catch {
    // This browser keeps nothing for us.
  }
  return codes;
}

/**
 * Keep the code of a cell, or, without any, forget it.
 * @param {string} id
 * @param {string} [code]
 */
export async function keepCode(id, code) {
  try {
    await (code === undefined ? del([here, id], store) : set([here, id], code, store));
  } catch {
    // The page lives on without memory.
  }
}
