/* What was recorded when the page was made, as it lies packed in the page's scripts. */

/**
 * Unpack what `packed()` of `pages/drawing.py` has packed.
 * @param {string} packed
 */
export async function unpack(packed) {
  const bytes = Uint8Array.from(atob(packed), letter => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return JSON.parse(await new Response(stream).text());
}

/** Pictures or films by the keys of the parameters with which they were taken; unpacked when they are first needed. */
export class Album {
  /** @type {Promise<{parts: string[], pictures: Record<string, any>}> | undefined} */
  content;

  /** @param {string} packed */
  constructor(packed) {
    this.packed = packed;
  }

  /** @param {string} key */
  async find(key) {
    this.content ??= unpack(this.packed);
    const {parts, pictures} = await this.content;
    return Object.hasOwn(pictures, key) ? whole(pictures[key], parts) : null;
  }
}

/**
 * Put the texts together that an album keeps in parts, since several pictures share them.
 * @param {any} picture
 * @param {string[]} parts
 * @returns {any}
 */
function whole(picture, parts) {
  if (Array.isArray(picture)) return picture.map(each => whole(each, parts));
  if (!picture || typeof picture !== 'object') return picture;
  if ('$' in picture) return picture.$.map((/** @type {number} */ number) => parts[number]).join('');
  return Object.fromEntries(Object.entries(picture).map(([name, part]) => [name, whole(part, parts)]));
}

/**
 * Return a name for a set of changed parameters, as the recorder does.
 * @param {Record<string, string>} changed
 */
export function key(changed) {
  const names = Object.keys(changed).sort();
  return names.map(name => `${name}=${changed[name]}`).join('\n');
}

/**
 * Say that something was not recorded for a set of changed parameters.
 * @param {string} what
 * @param {Record<string, string>} changed
 */
export function unknown(what, changed) {
  const values = Object.entries(changed).map(([name, text]) => `${name} = ${text}`);
  return `Not recorded: no ${what} with ${values.join(', ')}. Run the notebook to see it.`;
}
