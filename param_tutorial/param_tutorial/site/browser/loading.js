// @ts-check

// Opens the start page for somebody whose address names no file. Says that a kernel is being loaded, and when it is there,
// has the service worker keep the rest of the course, too. Says how to end a cell that runs for long: JupyterLab's own
// button cannot, since Python in a page hears of nothing while it runs. Keeps the service worker.

const [arrival] = /** @type {PerformanceNavigationTiming[]} */ (performance.getEntriesByType('navigation'));
if (arrival.type === 'navigate' && !new URLSearchParams(location.search).has('path')) {
  history.replaceState(null, '', '?path=index.md');
}

const LOADING = 'Python and ROS are coming into this page: 30 MB the first time, and then they are here.';
const RUNNING =
  'A cell has been running for half a minute. If it never ends, Kernel → Restart Kernel… ends it. Its variables and ' +
  'nodes are lost; your files stay.';
const LONG_MS = 30_000;

if (location.protocol === 'file:') {
  // Browsers let no page that comes from the disk ask for its own files.
  document.addEventListener('DOMContentLoaded', () => {
    document.body.textContent =
      'This page needs a web server, any will do: type  python3 -m http.server  in its folder, and open the address ' +
      'that it prints.';
  });
}

// On the second visit JupyterLite 0.8.6 takes its service worker for one of an older version and unregisters it. Without a
// network no other comes, and the visit after that would find nothing. The browser itself replaces old ones.
ServiceWorkerRegistration.prototype.unregister = async () => false;

/**
 * Show a notice, and return what takes it away.
 * @param {string} text
 */
function show(text) {
  const notice = document.createElement('div');
  notice.setAttribute('role', 'status');
  notice.textContent = text;
  notice.style.cssText = `position: fixed; right: 1rem; bottom: 2.5rem; z-index: 10000; max-width: 22rem;
    padding: 0.6rem 1rem; border-radius: 4px; background: #0d47a1; color: #fff; font: 14px/1.4 system-ui, sans-serif`;
  document.body.append(notice);
  return () => notice.remove();
}

window.Worker = class extends Worker {
  /** What to do once it has answered, by the ids of the messages. @type {Map<string, (answer?: any) => void>} */
  awaited = new Map();

  /** @param {string | URL} script @param {WorkerOptions} [options] */
  constructor(script, options) {
    super(script, options);
    // Here, and so before JupyterLite has the answer.
    this.addEventListener('message', ({data}) => this.finish(data?.id, data?.value));
  }

  /** @param {any} message @param {any} others */
  postMessage(message, others) {
    // JupyterLite's kernel is called by messages with the name of what it is to do, and its answer has the same id.
    const asked = message?.path?.[0];
    if (asked === 'initialize') {
      const hide = show(LOADING);
      this.awaited.set(message.id, () => {
        hide();
        navigator.serviceWorker.controller?.postMessage('keep everything');
      });
    } else if (asked === 'execute') {
      let hide = () => {};
      const timer = setTimeout(() => {
        hide = show(RUNNING);
      }, LONG_MS);
      this.awaited.set(message.id, answer => {
        clearTimeout(timer);
        hide();
        // After an error JupyterLite drops the cells that wait, also if JupyterLab says that the error is intended.
        if (answer?.status === 'error' && !message.argumentList[0].value.stop_on_error) answer.status = 'ok';
      });
    }
    super.postMessage(message, others);
  }

  terminate() {
    for (const id of this.awaited.keys()) this.finish(id);
    super.terminate();
  }

  /** @param {string} id @param {any} [answer] */
  finish(id, answer) {
    this.awaited.get(id)?.(answer);
    this.awaited.delete(id);
  }
};
