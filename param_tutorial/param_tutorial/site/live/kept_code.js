/* What the reader has typed into the cells of a page, kept in the browser. A browser that keeps nothing shows the lesson's
   own code again. */

import {entries, openDatabase} from '../scripts/database.js';
import {here} from '../scripts/progress.js';

/** @type {Promise<IDBDatabase | null> | undefined} */
let opened;

/** Return where code is kept, or nothing where this browser keeps nothing for us. */
async function store() {
  opened ??= openDatabase('ros2-parameters-code', ['code']);
  return (await opened)?.transaction('code', 'readwrite').objectStore('code');
}

/** Return what was typed on this page, by the ids of the cells. */
export async function keptCode() {
  const from = await store();
  /** @type {Record<string, string>} */
  const codes = {};
  for (const [[page, id], code] of from ? await entries(from) : []) {
    if (page === here && typeof code === 'string') codes[id] = code;
  }
  return codes;
}

/**
 * Keep the code of a cell, or, without any, forget it.
 * @param {string} id
 * @param {string} [code]
 */
export async function keepCode(id, code) {
  const into = await store();
  if (code === undefined) into?.delete([here, id]);
  else into?.put(code, [here, id]);
}
