/* A parameter panel in JupyterLab: the kernel holds the state, and takes what is entered; see `panel.py`. */

import {focusedBeside, make, uniqueName} from './dom.js';
import {FileForm} from './file_form.js';
import {initialize} from './front.js';
import {ParameterPanel} from './panel.js';

/**
 * @import {RenderProps} from '@anywidget/types'
 * @import {PanelState} from './panel.js'
 */

/** @param {RenderProps<{markup: string, state: PanelState, search: string}>} props */
function render({model, el}) {
  const client = uniqueName();
  /** @param {Record<string, unknown>} content */
  const send = content => model.send({client, ...content});
  const root = make('div');
  el.append(root);
  const form = new FileForm(`param-file-${client}`, send);
  /** @type {ParameterPanel | undefined} */
  let panel;
  let search = model.get('search');

  function build() {
    // A panel that does not wait for its node is there before there is anything to show.
    if (!model.get('markup')) return;
    const focused = /** @type {HTMLElement | null} */ (focusedBeside(root));
    // A notebook may show a panel twice.
    const shown = make('div', {innerHTML: model.get('markup').replaceAll('panel-NAME', `panel-${client}`)});
    const old = panel;
    panel = new ParameterPanel(shown, send);
    if (old) panel.takeOver(old);
    // At first there may be too few parameters for a search.
    if (panel.search && search) [panel.search.value, search] = [search, ''];
    form.settle(shown);
    root.replaceChildren(shown);
    show();
    panel.find();
    if (focused && form.element.contains(focused)) focused.focus();
    else if (focused && old?.root.contains(focused)) focusHeir(panel, focused);
  }

  function show() {
    if (!panel) return;
    panel.show(model.get('state'));
    form.update(panel.isLocked);
  }

  /** @param {any} message */
  function onMessage(message) {
    if (!panel || message.client !== client) return;
    if ('form' in message) form.answer(message);
    else panel.rows.get(message.name)?.answer(message.number);
  }

  build();
  model.on('change:markup', build);
  model.on('change:state', show);
  model.on('msg:custom', onMessage);
}

/**
 * Give the focus to what stands in the place of an element that had it.
 * @param {ParameterPanel} panel
 * @param {HTMLElement} focused
 */
function focusHeir(panel, focused) {
  if (!focused.className) return;
  const name = /** @type {HTMLElement | null} */ (focused.closest('.param-row'))?.dataset.name;
  const row = panel.rows.get(name ?? '');
  const heir = (row?.element ?? panel.root).querySelector(`.${focused.className}`);
  if (heir instanceof HTMLElement) heir.focus();
  if (!row?.isTyping || heir !== row.box) return;
  const {selectionStart, selectionEnd} = /** @type {HTMLInputElement} */ (focused);
  /** @type {HTMLInputElement} */ (heir).setSelectionRange(selectionStart, selectionEnd);
}

export default {initialize, render};
