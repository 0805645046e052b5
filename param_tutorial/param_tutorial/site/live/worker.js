/* The workers of a page. One unpacks the Python of the page and ends: only so is the memory for that free again at once.
   The other one begins Pyodide with what came out, and then is the page's kernel.

   Nothing is fetched: a page on a disk may not, and a page on the web must not, since it runs what its reader typed. */

import {XzReadableStream} from 'xz-decompress';
import {followFiles} from './followed_files.js';
import {filesIn, install, Kernel, PROGRESS} from './kernel.js';

const worker = /** @type {any} */ (self);
// As python_files.py has them.
const LETTERS = Array.from({length: 94}, (_, at) => String.fromCharCode(33 + at)).filter(each => !/["<\\]/.test(each));

/**
 * Return the bytes that python_files.py wrote as text, 13 bits as two letters.
 * @param {Uint8Array} text
 */
function bytesOf(text) {
  const values = new Uint8Array(128);
  for (const [value, letter] of LETTERS.entries()) values[letter.charCodeAt(0)] = value;
  const bytes = new Uint8Array((text.length / 16) * 13);
  let bits = 0;
  let count = 0;
  let at = 0;
  for (let i = 0; i < text.length; i += 2) {
    bits = (bits << 13) | (values[text[i]] * LETTERS.length + values[text[i + 1]]);
    for (count += 13; count >= 8; count -= 8) bytes[at++] = bits >> (count - 8);
  }
  // What xz packs ends with a letter; zeros after that fill the last block.
  return bytes.subarray(0, bytes.findLastIndex(Boolean) + 1);
}

/**
 * Tell the files that are packed in a text. Browsers unpack nothing that is as dense as xz.
 * @param {Uint8Array} text
 */
async function unpack(text) {
  const stream = new XzReadableStream(new Blob([bytesOf(text)]).stream());
  const {'pyodide.asm.wasm': wasm, ...part} = filesIn(new Uint8Array(await new Response(stream).arrayBuffer()));
  // Each in a buffer by itself, for the kernel keeps some.
  for (const name in part) part[name] = part[name].slice();
  const buffers = Object.values(part).map(({buffer}) => buffer);
  worker.postMessage({part: {...part, module: await WebAssembly.compile(wasm)}, buffers}, buffers);
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
 * @param {Record<string, any>} part Of Pyodide and the packages, what `unpack` tells.
 * @param {string} progress What the browser has kept, as the course writes it into a file.
 * @param {import('./followed_files.js').Files} files Of the reader.
 */
async function begin({module, ...part}, progress, files) {
  // Pyodide asks by this whether the worker is a classic one, which it rejects; all that it needs works in one, too.
  worker.importScripts = () => {
    throw new TypeError('this page loads no scripts');
  };
  const tellStep = () => worker.postMessage({is: 'step'});
  tellStep();
  const [{loadPyodide}, {default: createPyodideModule}] = await Promise.all([
    load(part['pyodide.mjs']),
    load(part['pyodide.asm.mjs']),
  ]);
  const fetchOfBrowser = worker.fetch;
  const library = part['python_stdlib.zip'].buffer;
  // Pyodide has no other way to be given these.
  worker.fetch = async () => ({ok: true, arrayBuffer: () => library});
  worker.WebAssembly.instantiateStreaming = async (/** @type {any} */ _, /** @type {any} */ imports) => ({
    module,
    instance: await WebAssembly.instantiate(module, imports),
  });
  const python = await loadPyodide({
    createPyodideModule,
    indexURL: 'https://nowhere.invalid/',
    lockFileContents: JSON.parse(new TextDecoder().decode(part['pyodide-lock.json'])),
  });
  worker.fetch = fetchOfBrowser;
  // Python has copied it. What is sent to a port that closes is free again at once.
  const {port1, port2} = new MessageChannel();
  port1.postMessage(0, [library]);
  port2.close();
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
  if (data.packed) {
    unpack(data.packed).catch(reportError);
  } else if (data.part) {
    arrive(begin(data.part, data.progress, data.files));
  } else if (data.run) {
    before = before.then(async () => (await kernel).run(data.run, data.code)).then(() => look());
  } else {
    before = before.then(async () => (await kernel).tell(data.widget, data.data));
  }
};
