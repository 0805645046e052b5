/* Hides in JupyterLab what follows a prediction: marks the cells, which the style sheet then veils; see `veil.py`.

   JupyterLab keeps the element of a cell that it takes off the page while one scrolls, and so the mark on it. */

import {initialize} from '../../param_tools/panel/front.js';

/** @import {InitializeProps} from '@anywidget/types' */

const ASKED = /^\s*exercises\.predict\('([^']+)'\)/m;
const FENCED = /^(```|~~~).*?^\1/gms;
const HEADING = /^#{1,6} /m;
const ENDED = ['restarting', 'autorestarting', 'terminating', 'dead'];
const MARKS = ['param-veiled', 'param-veils'];

/**
 * Return the mark of each cell.
 * @param {{type: string, source: string}[]} cells
 * @param {string[]} lifted The numbers of the predictions that hide nothing any more.
 */
export function marksOf(cells, lifted) {
  let isVeiled = false;
  return cells.map(({type, source}) => {
    const number = type === 'code' ? ASKED.exec(source)?.[1] : undefined;
    if (number !== undefined) {
      isVeiled = !lifted.includes(number);
      return isVeiled ? 'param-veils' : '';
    }
    const heading = type === 'markdown' ? source.replace(FENCED, '').trim().search(HEADING) : -1;
    const mark = isVeiled && heading !== 0 ? 'param-veiled' : '';
    if (heading >= 0) isVeiled = false;
    return mark;
  });
}

/** @param {InitializeProps<{own_id: string, lifted: string[]}>} props */
async function begin(props) {
  await initialize(props);
  const {model} = props;
  const widget = /** @type {any} */ (await model.widget_manager.get_model(model.get('own_id')));
  // Both are missing outside of JupyterLab.
  const context = widget.widget_manager.context;
  const shell = /** @type {any} */ (window).jupyterapp?.shell;
  if (!context?.model?.cells || !shell) return;
  const sessions = context.sessionContext;
  const ownKernel = sessions.session?.kernel?.id;

  /** @param {(cells: any[]) => string[]} marks Returns the mark of each cell. */
  function mark(marks) {
    for (const panel of shell.widgets('main')) {
      if (panel.context !== context) continue;
      const cells = panel.content.widgets;
      const all = marks(cells);
      cells.forEach((/** @type {any} */ cell, /** @type {number} */ index) => {
        for (const each of MARKS) cell.toggleClass(each, each === all[index]);
      });
    }
  }
  // A kernel that has ended could lift nothing, and the next one has a veil of its own.
  let hasEnded = false;
  function show() {
    if (hasEnded) return;
    const kernel = sessions.session?.kernel;
    hasEnded = kernel?.id !== ownKernel || ENDED.includes(kernel.status);
    mark(cells => {
      const known = cells.map(({model: {type, sharedModel}}) => ({type, source: sharedModel.getSource()}));
      return hasEnded ? known.map(() => '') : marksOf(known, model.get('lifted'));
    });
  }
  // Many changes come together, and some before JupyterLab has the cells for them.
  let frame = 0;
  function showSoon() {
    cancelAnimationFrame(frame);
    frame = requestAnimationFrame(show);
  }

  show();
  model.on('change:lifted', () => {
    show();
    window.dispatchEvent(new Event('resize')); // what was hidden had no size when it was drawn
  });
  sessions.statusChanged.connect(show);
  sessions.kernelChanged.connect(show);
  context.model.contentChanged.connect(showSoon);
  shell.currentChanged.connect(showSoon); // to another view of the same notebook
}

export default {initialize: begin};
