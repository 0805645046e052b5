// @ts-check

// Opens the start page for somebody whose address names no file. Says that a kernel is being loaded: from the moment its
// worker begins until it answers that it is ready. Then it has the service worker keep the rest of the course, too.

const [arrival] = /** @type {PerformanceNavigationTiming[]} */ (performance.getEntriesByType('navigation'));
if (arrival.type === 'navigate' && !new URLSearchParams(location.search).has('path')) {
  history.replaceState(null, '', '?path=index.md');
}

const notice = document.createElement('div');
notice.setAttribute('role', 'status');
notice.textContent = 'Python and ROS are coming into this page: 30 MB the first time, and then they are here.';
notice.style.cssText = `position: fixed; right: 1rem; bottom: 2.5rem; z-index: 10000; max-width: 22rem;
  padding: 0.6rem 1rem; border-radius: 4px; background: #0d47a1; color: #fff; font: 14px/1.4 system-ui, sans-serif`;
let loading = 0;

if (location.protocol === 'file:') {
  // Browsers let no page that comes from the disk ask for its own files.
  document.addEventListener('DOMContentLoaded', () => {
    document.body.textContent =
      'This page needs a web server, any will do: type  python3 -m http.server  in its folder, and open the address ' +
      'that it prints.';
  });
}

/** @param {number} difference */
function count(difference) {
  loading += difference;
  if (loading > 0) {
    document.body.append(notice);
  } else {
    notice.remove();
    navigator.serviceWorker.controller?.postMessage('keep everything');
  }
}

window.Worker = class extends Worker {
  /** @param {any} message @param {any} others */
  postMessage(message, others) {
    // JupyterLite's kernel is asked to begin by a message with this path, and its answer has the same id.
    if (message?.path?.[0] === 'initialize') {
      count(1);
      /** @param {MessageEvent} event */
      const answered = event => {
        if (event.data?.id === message.id) {
          count(-1);
          this.removeEventListener('message', answered);
        }
      };
      this.addEventListener('message', answered);
    }
    super.postMessage(message, others);
  }
};
