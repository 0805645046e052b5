/* What a browser keeps for the site: databases of its own, for the reasons in `progress.js`. */

/**
 * Return a database, or null where this browser has none for us.
 * @param {string} name
 * @param {string[]} stores What is in it.
 * @returns {Promise<IDBDatabase | null>}
 */
export function openDatabase(name, stores) {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open(name, 1);
    request.onupgradeneeded = () => {
      for (const each of stores) request.result.createObjectStore(each);
    };
    request.onsuccess = () => resolve(request.result);
    request.onerror = reject;
  }).catch(() => null);
}

/**
 * Return the keys and values of a store.
 * @param {IDBObjectStore} store
 * @returns {Promise<[any, any][]>}
 */
export async function entries(store) {
  const [keys, values] = await Promise.all([store.getAllKeys(), store.getAll()].map(result));
  return keys.map((key, at) => [key, values[at]]);
}

/**
 * @param {IDBRequest<any[]>} request
 * @returns {Promise<any[]>}
 */
function result(request) {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = reject;
  });
}
