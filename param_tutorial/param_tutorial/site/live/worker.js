/* The worker of a page: begins Pyodide with what the page has sent, and then is the page's kernel.

   Nothing is fetched: a page on a disk may not, and a page on the web must not, since it runs what its reader typed. */

import {Kernel, PROGRESS, unpackFiles} from './kernel.js';

const worker = /** @type {any} */ (self);

/** @param {string} text */
function bytesOf(text) {
  if ('fromBase64' in Uint8Array) return /** @type {any} */ (Uint8Array).fromBase64(text);
  return Uint8Array.from(atob(text), letter => letter.charCodeAt(0));
}

/**
 * Return the content of a part of Pyodide or of the packages, which comes deflated, as text.
 * @param {string} text
 */
async function unpack(text) {
  const stream = new Blob([bytesOf(text)]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/**
 * Return a module in a text.
 * @param {Uint8Array<ArrayBuffer>} code
 */
async function load(code) {
  const address = URL.createObjectURL(new Blob([code], {type: 'text/javascript'}));
  return import(address);
}

/**
 * @param {Record<string, string>} parts
 * @param {string} progress What the browser has kept, as the course writes it into a file.
 */
async function begin(parts, progress) {
  // Pyodide asks by this whether the worker is a classic one, which it rejects; all that it needs works in one, too.
  worker.importScripts = () => {
    throw new TypeError('this page loads no scripts');
  };
  const names = Object.keys(parts);
  const contents = await Promise.all(names.map(name => unpack(parts[name])));
  const part = Object.fromEntries(names.map((name, at) => [name, contents[at]]));
  const [{loadPyodide}, {default: createPyodideModule}] = await Promise.all([
    load(part['pyodide.mjs']),
    load(part['pyodide.asm.mjs']),
  ]);
  const fetchOfBrowser = worker.fetch;
  // Pyodide has no other way to be given its machine code.
  worker.fetch = async (/** @type {any} */ wanted) =>
    String(wanted).endsWith('.wasm')
      ? new Response(part['pyodide.asm.wasm'], {headers: {'Content-Type': 'application/wasm'}})
      : fetchOfBrowser(wanted);
  const python = await loadPyodide({
    createPyodideModule,
    indexURL: 'https://nowhere.invalid/',
    lockFileContents: JSON.parse(new TextDecoder().decode(part['pyodide-lock.json'])),
    stdLibURL: URL.createObjectURL(new Blob([part['python_stdlib.zip']])),
  });
  worker.fetch = fetchOfBrowser;
  unpackFiles(python, part.packages);
  python.FS.writeFile(PROGRESS, progress);
  return new Kernel(python, said => worker.postMessage(said));
}

// The page may ask before all parts are here.
/** @type {(kernel: Promise<Kernel>) => void} */
let arrive;
/** @type {Promise<Kernel>} */
const kernel = new Promise(resolve => {
  arrive = resolve;
});
kernel.then(
  () => worker.postMessage({is: 'ready'}),
  error => worker.postMessage({is: 'dead', why: String(error?.stack ?? error)}),
);
// What the page asks for is done in that order.
let before = Promise.resolve();

worker.onmessage = (/** @type {MessageEvent} */ {data}) => {
  if (data.parts) {
    arrive(begin(data.parts, data.progress));
  } else if (data.run) {
    before = before.then(async () => (await kernel).run(data.run, data.code));
  } else {
    before = before.then(async () => (await kernel).tell(data.widget, data.data));
  }
};
