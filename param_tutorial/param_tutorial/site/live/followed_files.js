/* The reader's own ROS package in the file system of a page's kernel. Where the page keeps it is told in `kept_files.js`. */

/**
 * Contents by paths below the lessons' folder, a letter for each byte; null for what is gone.
 * @typedef {Record<string, string>} Files
 * @typedef {Record<string, string | null>} Changes
 */

export const WORKSPACE = 'ros2_ws';
const DRIVE = '/drive/';

/** @param {Uint8Array} bytes */
export const lettersOf = bytes => Array.from(bytes, each => String.fromCharCode(each)).join('');

/**
 * Put files into a kernel's file system, and from then on tell of changes at once, for the cell may never end. Return what
 * looks for changes of files that are not closed.
 * @param {any} FS Emscripten's.
 * @param {Files} files
 * @param {(changes: Changes) => void} tell
 */
export function followFiles(FS, files, tell) {
  for (const [path, content] of Object.entries(files)) {
    FS.mkdirTree(DRIVE + path.replace(/\/[^/]*$/, ''));
    const bytes = Uint8Array.from(content, each => each.charCodeAt(0));
    FS.writeFile(DRIVE + path, bytes);
  }
  let seen = files;
  const look = () => {
    const found = FS.analyzePath(DRIVE + WORKSPACE).exists ? filesBelow(FS, WORKSPACE) : {};
    // What has moved to the backups is there before it is gone elsewhere.
    const changed = Object.keys({...seen, ...found})
      .filter(path => seen[path] !== found[path])
      .sort();
    seen = found;
    if (changed.length) tell(Object.fromEntries(changed.map(path => [path, found[path] ?? null])));
  };
  for (const name of ['close', 'rename', 'unlink']) {
    const original = FS[name];
    FS[name] = (/** @type {any[]} */ ...given) => {
      const result = original.apply(FS, given);
      const [{flags, path}] = given;
      // These bits are zero in a file that can only be read.
      if (name !== 'close' || (flags & 3 && path?.startsWith(DRIVE + WORKSPACE))) look();
      return result;
    };
  }
  return look;
}

/** @param {any} FS @param {string} folder @param {Files} [found] */
function filesBelow(FS, folder, found = {}) {
  for (const name of FS.readdir(DRIVE + folder)) {
    const path = `${folder}/${name}`;
    const {mode} = FS.lstat(DRIVE + path);
    if (FS.isFile(mode)) found[path] = lettersOf(FS.readFile(DRIVE + path));
    else if (FS.isDir(mode) && !['.', '..', '__pycache__'].includes(name)) filesBelow(FS, path, found);
  }
  return found;
}
