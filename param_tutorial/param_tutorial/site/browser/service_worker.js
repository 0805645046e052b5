// @ts-check

// Stands between the pages and their server: what was loaded once is not asked for again, so that the course goes on
// without a network; and everything is delivered with a policy that forbids requests to other hosts, also from the
// kernel, which runs what the reader typed. What JupyterLite's own service worker answers is left to it.

// TypeScript knows service workers only where it does not know pages. No name may be one of JupyterLite's script, too.
const worker = /** @type {any} */ (self);

// The build writes the values of these.
const VERSION = '__VERSION__';
const FILES = /** @type {string[]} */ (/** @type {unknown} */ ('__FILES__'));
const POLICY = '__POLICY__';

/** @param {URL} url */
const isJupyterLites = url => /\/api\/(drive|stdin|service-worker-heartbeat)/.test(url.pathname);

/** @param {Request} request */
async function deliver(request) {
  const kept = await caches.open(VERSION);
  const url = request.url.replace(/[?#].*/, '').replace(/\/$/, '/index.html');
  const found = await kept.match(url);
  if (found) {
    return found;
  }
  const {body, status, statusText, headers} = await fetch(request);
  const response = new Response(body, {status, statusText, headers: new Headers(headers)});
  response.headers.set('Content-Security-Policy', POLICY);
  if (response.ok) {
    await kept.put(url, response.clone());
  }
  return response;
}

// What the first page had loaded before this worker was there, and what it did not need, comes when nobody waits.
async function keepEverything() {
  for (const file of FILES) {
    await deliver(new Request(file));
  }
}

async function dropOldVersions() {
  for (const name of await caches.keys()) {
    if (name !== VERSION) {
      await caches.delete(name);
    }
  }
}

/** @param {any} event */
const whenActive = event => event.waitUntil(dropOldVersions());

/** @param {any} event */
const whenTold = event => event.data === 'keep everything' && event.waitUntil(keepEverything());

/** @param {any} event */
function whenAsked(event) {
  const url = new URL(event.request.url);
  if (event.request.method === 'GET' && url.origin === location.origin && !isJupyterLites(url)) {
    event.stopImmediatePropagation();
    event.respondWith(deliver(event.request));
  }
}

worker.addEventListener('activate', whenActive);
worker.addEventListener('message', whenTold);
worker.addEventListener('fetch', whenAsked);
worker.importScripts('jupyterlite-service-worker.js');
