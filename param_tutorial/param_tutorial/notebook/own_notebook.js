/* The notebook in JupyterLab to which a widget belongs that is shown nowhere. */

/**
 * Return the document of a widget's notebook, JupyterLab's shell, and a function that finds the views of the notebook
 * there are now; undefined outside of JupyterLab.
 * @param {import('@anywidget/types').InitializeProps<any>['model']} model
 */
export async function ownNotebook(model) {
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
