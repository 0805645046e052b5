/* What the course adds to JupyterLab: a widget whose kernel has ended says so, and a click on it runs its cell again.
   Text is as wide as the pictures, and what is printed breaks between words. The list of files shows no folder but the
   learner's own: links lead to the others. When the first chapter opens in a window that has no room for it beside a stage
   and the text, that list closes. The hints of a check look like buttons.

   JupyterLab marks each widget of a kernel that was restarted with a broken link, and leaves its buttons to look alive.
   In a notebook that is opened again, it shows an error in the widget's place.

   And a picture that a notebook has stored scrolls in a narrow window: shrunk, nobody could read its letters. A LinePlot
   is drawn larger, and shrinks until its letters have 11 px. */

const WORDS = 'The kernel is new. Click here to run this cell, after all cells above it.';
const RESTARTED = '.jp-OutputArea-output > .jupyter-widgets-disconnected';
// JupyterLab's own error is the only text that stands here without an element around it.
const REOPENED = '.jp-OutputArea-output.jupyter-widgets:not(:has(*))';
// Code of 80 characters stands beside a stage in what is left of it, with the list closed.
const NARROW_PX = 1600;
const STYLE = `
.jupyter-widgets-disconnected::before { content: none !important; }
${RESTARTED}::before, ${REOPENED}::before {
  content: '${WORDS}' !important; display: block; margin: 4px 0; padding: 4px 12px; text-align: left; white-space: normal;
  border-left: 4px solid var(--jp-warn-color1); background: var(--jp-layout-color2); color: var(--jp-ui-font-color1);
  font: var(--jp-content-font-size1) / 1.5 var(--jp-content-font-family); }
${REOPENED} { font-size: 0; }
:is(${RESTARTED}, ${REOPENED}) { cursor: pointer; }
${RESTARTED} > * { filter: grayscale(1); opacity: 0.55; pointer-events: none; interactivity: inert; }
:is(.jp-RenderedHTML, .param-check):has(> svg[width]) { overflow-x: auto; }
@media screen { :is(.jp-RenderedHTML, .param-check) > svg[width] { max-width: none !important; } }
:is(.jp-RenderedHTML, .param-check) > svg[width="500"] { max-width: 100% !important; min-width: 356px; }
.jp-RenderedMarkdown { max-width: 60em; }
.jp-OutputArea-output pre { word-break: normal !important; overflow-wrap: anywhere; text-indent: 4ch hanging each-line; }
.param-hints { margin-top: 8px; }
.param-hints summary { width: fit-content; margin: 8px 0; padding: 2px 12px; border: 1px solid var(--jp-border-color1);
  border-radius: 4px; background: var(--jp-layout-color2); cursor: pointer; list-style: none; }
.jp-DirListing-item:is([title^='Name: solutions\\a '], [title^='Name: images\\a ']) { display: none; }
@media print { ${RESTARTED}::before, ${REOPENED}::before { content: none !important; } }
`;

/** @param {any} app JupyterLab. */
function activate(app) {
  const style = document.createElement('style');
  style.textContent = STYLE;
  document.head.append(style);
  const close = (/** @type {any} */ shell) => {
    if (!shell.currentWidget?.node.matches('.jp-NotebookPanel')) return;
    shell.currentChanged.disconnect(close);
    if (innerWidth < NARROW_PX) shell.collapseLeft();
  };
  app.shell.currentChanged.connect(close);
  document.addEventListener('click', async event => {
    const stale = /** @type {Element} */ (event.target).closest(`${RESTARTED}, ${REOPENED}`);
    const cells = app.shell.currentWidget?.content?.widgets ?? [];
    const index = stale ? cells.findIndex((/** @type {any} */ cell) => cell.node.contains(stale)) : -1;
    if (index < 0) return;
    app.shell.currentWidget.content.activeCellIndex = index;
    await app.commands.execute('notebook:run-all-above');
    await app.commands.execute('notebook:run-cell');
  });
}

// What webpack would write around it: JupyterLab asks for the module that package.json names.
const plugin = {id: 'param-tutorial:new-kernel', autoStart: true, activate};
const host = /** @type {any} */ (window);
host._JUPYTERLAB = host._JUPYTERLAB ?? {};
host._JUPYTERLAB['param-tutorial'] = {init() {}, get: async () => () => ({__esModule: true, default: plugin})};
