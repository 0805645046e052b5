/* The reader's own ROS package, kept in the browser: all files below ros2_ws in the folder of the lessons.

   They are kept where JupyterLab of the same site keeps its files, in the database and the form of JupyterLite 0.8's
   BrowserStorageDrive. So there is one copy of each file: what a page has written is on JupyterLab's drive at once, and
   what is written there is in every page whose kernel starts later.

   The last one who writes a file wins. Before a page replaces or deletes what it hasn't written itself since it was loaded
   (the work of another page, of JupyterLab, or of an earlier visit), that goes to ros2_ws/backups/, unless the same content
   is there. JupyterLab's kernel writes as to a disk, without a backup.

   Limits: folders without files and Python's __pycache__ aren't kept. A kernel that runs sees nothing of what other pages
   write. In a browser that keeps nothing each page begins anew, and a private window forgets everything when it is closed.
   Pages on a disk share their files by folder, but JupyterLab isn't among them, since it needs a server. */

import {promisifyRequest} from 'idb-keyval';
import {localTime} from '../scripts/progress.js';
import {lettersOf, WORKSPACE} from './followed_files.js';

/** @typedef {import('./followed_files.js').Changes} Changes */
/** A file or a folder of JupyterLite. @typedef {{path: string, type: string, format: string, content: any}} Model */

const BACKUPS = `${WORKSPACE}/backups/`;
/** What this page has written since it was loaded. @type {Changes} */
const own = {};

/** @param {string} prefix */
const below = prefix => IDBKeyRange.bound(prefix, `${prefix}\uffff`);

/** @param {Model} model Of a file. */
function contentOf({format, content}) {
  if (format === 'base64') return atob(content);
  return lettersOf(new TextEncoder().encode(typeof content === 'string' ? content : JSON.stringify(content)));
}

/** @param {number} [version] @returns {Promise<IDBDatabase>} */
async function open(version) {
  const request = indexedDB.open(`JupyterLite Storage - ${new URL('lite/', location.href).pathname}`, version);
  request.onupgradeneeded = () => request.result.createObjectStore('files');
  const database = await promisifyRequest(request);
  if (database.objectStoreNames.contains('files')) return database;
  database.close();
  return open(database.version + 1);
}

/**
 * Do something with the models, by their paths, unless this browser keeps nothing.
 * @param {(store: IDBObjectStore) => Promise<void>} how
 */
async function use(how) {
  try {
    const database = await open();
    const store = database.transaction('files', 'readwrite').objectStore('files');
    // It is closed when that has ended, for JupyterLite can't add its other stores as long as a page has it open.
    database.close();
    await Promise.all([how(store), promisifyRequest(store.transaction)]);
  } catch (error) {
    console.warn('Files of the reader are not kept:', error);
  }
}

/** Return all files that are kept. */
export async function keptFiles() {
  /** @type {import('./followed_files.js').Files} */
  const files = {};
  await use(async store => {
    for (const model of await promisifyRequest(store.getAll(below(`${WORKSPACE}/`)))) {
      if (model.type !== 'directory') files[model.path] = contentOf(model);
    }
  });
  return files;
}

/** Keep files that the kernel has written, and forget those that it has deleted. @param {Changes} changes */
export function keepFiles(changes) {
  return use(async store => {
    for (const [path, content] of Object.entries(changes)) {
      const before = await promisifyRequest(store.get(path));
      if (before && ![content, own[path]].includes(contentOf(before))) await backUp(store, before);
      const model = {...before, path, type: 'file', format: 'base64'};
      if (content === null) store.delete(path);
      else await put(store, {...model, content: btoa(content), size: content.length});
      own[path] = content;
    }
  });
}

/** @param {IDBObjectStore} store @param {Model} model */
async function backUp(store, model) {
  const content = contentOf(model);
  const backups = await promisifyRequest(store.getAll(below(BACKUPS)));
  if (backups.some(each => each.type !== 'directory' && contentOf(each) === content)) return;
  // Two pages that start at once may replace one file twice in a second.
  const stamp = `${localTime().replace('T', '_').replaceAll(':', '-')}-${Date.now() % 1000}`;
  await put(store, {...model, path: model.path.replace(WORKSPACE, BACKUPS + stamp)});
}

/** @param {IDBObjectStore} store @param {any} model Its name and times are added, and its folders. */
async function put(store, model) {
  const [folder, name] = model.path.split(/\/(?=[^/]*$)/);
  const now = new Date().toISOString();
  const full = {mimetype: '', writable: true, created: now, ...model, name: name ?? folder, last_modified: now};
  store.put(full, model.path);
  if (!name || (await promisifyRequest(store.getKey(folder)))) return;
  await put(store, {path: folder, type: 'directory', format: 'json', content: null, size: 0});
}
