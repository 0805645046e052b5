/* The worker of a page: begins Pyodide with what the page has sent, and then is the page's kernel.

   Nothing is fetched: a page on a disk may not, and a page on the web must not, since it runs what its reader typed. */

import {XzReadableStream} from 'xz-decompress';
import {followFiles} from './followed_files.js';
import {filesIn, install, Kernel, PROGRESS} from './kernel.js';

const worker = /** @type {any} */ (self);
// As python_files.py has them.
const LETTERS = Array.from({length: 94}, (_, at) => String.fromCharCode(33 + at)).filter(each => !/["<\\]/.test(each));

/**
 * Return the bytes that python_files.py wrote as text, 13 bits as two letters.
 * @param {string} text
 */
function bytesOf(text) {
  const values = new Uint8Array(128);
  for (const [value, letter] of LETTERS.entries()) values[letter.charCodeAt(0)] = value;
  const bytes = new Uint8Array((text.length / 16) * 13);
  let bits = 0;
  let count = 0;
  let at = 0;
  for (let i = 0; i < text.length; i += 2) {
    bits = (bits << 13) | (values[text.charCodeAt(i)] * LETTERS.length + values[text.charCodeAt(i + 1)]);
    for (count += 13; count >= 8; count -= 8) bytes[at++] = bits >> (count - 8);
  }
  // What xz packs ends with a letter; zeros after that fill the last block.
  return bytes.subarray(0, bytes.findLastIndex(Boolean) + 1);
}

/**
 * Return the files that are packed in a text. Browsers unpack nothing that is as dense as xz.
 * @param {string} text
 */
async function unpack(text) {
  const stream = new XzReadableStream(new Blob([bytesOf(text)]).stream());
  return filesIn(new Uint8Array(await new Response(stream).arrayBuffer()));
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
 * @param {string} packed Pyodide and the packages.
 * @param {string} progress What the browser has kept, as the course writes it into a file.
 * @param {import('./followed_files.js').Files} files Of the reader.
 */
async function begin(packed, progress, files) {
  // Pyodide asks by this whether the worker is a classic one, which it rejects; all that it needs works in one, too.
  worker.importScripts = () => {
    throw new TypeError('this page loads no scripts');
  };
  const tellStep = () => worker.postMessage({is: 'step'});
  tellStep();
  const part = await unpack(packed);
  tellStep();
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
  tellStep();
  install(python, part.packages);
  python.FS.writeFile(PROGRESS, progress);
  look = followFiles(python.FS, files, changes => worker.postMessage({is: 'files', changes}));
  return new Kernel(python, said => worker.postMessage(said));
}

// The page may ask before Python is here.
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
let look = () => {};
// What the page asks for is done in that order.
let before = Promise.resolve();

worker.onmessage = (/** @type {MessageEvent} */ {data}) => {
  if (data.python) {
    arrive(begin(data.python, data.progress, data.files));
  } else if (data.run) {
    before = before.then(async () => (await kernel).run(data.run, data.code)).then(() => look());
  } else {
    before = before.then(async () => (await kernel).tell(data.widget, data.data));
  }
};
