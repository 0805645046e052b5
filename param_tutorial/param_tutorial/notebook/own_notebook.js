/* The notebook in JupyterLab to which a widget belongs that is shown nowhere. */

import {initialize} from '../../param_tools/panel/front.js';

/**
 * Prepare a widget, and return the document of its notebook, JupyterLab's shell, and a function that finds the views of
 * the notebook there are now; undefined outside of JupyterLab.
 * @param {import('@anywidget/types').InitializeProps<any>} props
 */
export async function ownNotebook(props) {
  await initialize(props);
  const {model} = props;
  const widget = /** @type {any} */ (await model.widget_manager.get_model(model.get('own_id')));
  // Both are missing outside of JupyterLab.
  const context = widget.widget_manager.context;
  const shell = /** @type {any} */ (window).jupyterapp?.shell;
  if (!context?.model?.cells || !shell) return undefined;
  return {
    context,
    shell,
    /** @returns {any[]} */
    views: () => [...shell.widgets('main')].filter(each => each.context === context),
  };
}
