/* What every view adds to an anywidget in the browser.

   anywidget gives a script two seconds to load. On a busy machine it may take longer, and from then on anywidget drops
   each message of the kernel: the view would never change again. So a script that comes late listens by itself, and asks
   for what it has missed. */

/** @param {import('@anywidget/types').InitializeProps<{own_id: string}>} props */
export async function initialize({model}) {
  // What anywidget hands over is a part of the widget. Its types say nothing of the methods that take messages.
  const widget = /** @type {any} */ (await model.widget_manager.get_model(model.get('own_id')));
  const nothing = {content: {data: {method: 'nothing'}}};
  widget._handle_comm_msg(nothing).catch(() => {
    const hear = Object.getPrototypeOf(Object.getPrototypeOf(widget))._handle_comm_msg;
    widget.comm.on_msg((/** @type {any} */ message) => hear.call(widget, message));
    model.send({do: 'tell again'});
  });
}
