/* What the reader has typed into the cells of a page, kept in the browser; see scripts/progress.js for why not elsewhere.
   A browser that keeps nothing shows the lesson's own code again. */

const NAME = 'ros2-parameters-code';
const here = location.pathname.split('/').at(-1) ?? '';

/** @returns {Promise<IDBObjectStore | null>} Null where this browser keeps nothing for us. */
function store() {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open(NAME, 1);
    request.onupgradeneeded = () => request.result.createObjectStore('code');
    request.onsuccess = () => resolve(request.result.transaction('code', 'readwrite').objectStore('code'));
    request.onerror = reject;
  }).catch(() => null);
}

/** Return what was typed on this page, by the ids of the cells. */
export async function keptCode() {
  /** @type {Record<string, string>} */
  const codes = {};
  const from = await store();
  if (!from) return codes;
  const [keys, values] = await Promise.all([from.getAllKeys(), from.getAll()].map(done));
  keys.forEach(([page, id], at) => {
    if (page === here && typeof values[at] === 'string') codes[id] = values[at];
  });
  return codes;
}

/**
 * @param {IDBRequest<any[]>} request
 * @returns {Promise<any[]>}
 */
function done(request) {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = reject;
  });
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
