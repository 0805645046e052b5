/* The widgets of a page: each is shown by the very front end that JupyterLab would show it with.

   Before the kernel is awake a view shows what its cell left when the site was built, and keeps what a hand does. As soon
   as the kernel has run the cell, the same view is a view of the kernel's widgets, and what the hand did is done. */

import {make} from '../../../param_tools/panel/dom.js';
import {clean, drawAnew} from '../scripts/wide.js';

const PREFIX = 'IPY_MODEL_';
const LEFT_OUT = new Set(['layout', 'style']);
// What the course's front ends draw as HTML.
const HTML = new Set(['markup', 'picture']);

/** @param {any} one @param {any} other */
const same = (one, other) => one === other || JSON.stringify(one) === JSON.stringify(other);

/** What a front end knows of a widget: the model of anywidget's `render({model, el})`. */
export class Handle {
  /** @type {Map<string, Set<Function>>} */
  listeners = new Map();
  isLive = false;
  /** What a hand did before the kernel had the widget. @type {any[]} */
  waiting = [];
  /** @type {Set<string>} */
  changed = new Set();
  /** What was cleaned last, and what came of it: a front end may ask for the same at each step. @type {Map<string, string[]>} */
  cleaned = new Map();
  // For front.js, whose anywidget may be slow to load; here it is not.
  widget_manager = {get_model: async () => this};
  _handle_comm_msg = async () => {};

  /**
   * @param {View} view
   * @param {string} name
   * @param {any} state
   */
  constructor(view, name, state) {
    this.view = view;
    this.name = name;
    this.state = {...state};
  }

  /** @param {string} key */
  get(key) {
    const value = this.state[key];
    if (!HTML.has(key)) return value;
    if (this.cleaned.get(key)?.[0] !== value) this.cleaned.set(key, [value, clean(value)]);
    return this.cleaned.get(key)?.[1];
  }

  /** @param {string} key @param {any} value */
  set(key, value) {
    if (same(this.state[key], value)) return;
    this.state[key] = value;
    this.changed.add(key);
    this.emit(`change:${key}`, value);
    this.emit('change');
  }

  save_changes() {
    const state = Object.fromEntries([...this.changed].map(key => [key, this.state[key]]));
    this.changed.clear();
    this.tell({method: 'update', state, buffer_paths: []});
  }

  /** @param {any} content */
  send(content) {
    this.tell({method: 'custom', content});
  }

  /** @param {any} data */
  tell(data) {
    if (this.isLive) this.view.page.tell(this.name, data);
    else {
      this.waiting.push(data);
      this.view.page.wake(this.view.cell, this.view.inner);
    }
  }

  /** @param {string} names @param {Function} listener */
  on(names, listener) {
    for (const name of names.split(' ')) {
      if (!this.listeners.has(name)) this.listeners.set(name, new Set());
      this.listeners.get(name)?.add(listener);
    }
  }

  /** @param {string} name @param {...any} values */
  emit(name, ...values) {
    for (const listener of [...(this.listeners.get(name) ?? [])]) listener(...values);
  }

  /**
   * Take over what the kernel says; what belongs together is there before anybody hears of it.
   * @param {any} state
   */
  update(state) {
    const keys = Object.keys(state).filter(key => !LEFT_OUT.has(key) && !same(this.state[key], state[key]));
    for (const key of keys) this.state[key] = state[key];
    for (const key of keys) this.emit(`change:${key}`, state[key]);
    if (keys.length) this.emit('change');
  }

  /** From now on it is the kernel's. @param {any} state */
  goLive(state) {
    this.isLive = true;
    this.update(state);
    for (const data of this.waiting.splice(0)) this.view.page.tell(this.name, data);
  }
}

/**
 * Scripts by their texts, since each widget brings its own.
 * @type {Map<string, Promise<any>>}
 */
const modules = new Map();
/** @type {Set<string>} */
const styles = new Set();

/**
 * Return a text that the page has once for all widgets.
 * @param {string} text Or the name of one.
 */
const shared = text => /** @type {any} */ (self).lessonFronts?.[text] ?? text;

/**
 * Tell whether a script is one that the site was built with; what the reader's code brings does not run in the page.
 * @param {string} text Or the name of one.
 */
const isOfCourse = text => Object.values(/** @type {any} */ (self).lessonFronts ?? {}).includes(shared(text));

/** @param {string} text */
function load(text) {
  const code = shared(text);
  const address = () => URL.createObjectURL(new Blob([code], {type: 'text/javascript'}));
  if (!modules.has(code)) modules.set(code, import(address()));
  return /** @type {Promise<any>} */ (modules.get(code));
}

/** @param {string | undefined} text */
function addStyle(text) {
  const style = shared(text ?? '');
  if (!style || styles.has(style)) return;
  styles.add(style);
  document.head.append(make('style', {}, style));
}

/**
 * Return a slider of ipywidgets, for a panel of the reader's own.
 * @param {Handle} model
 */
function slider(model) {
  const input = /** @type {any} */ (make('input', {type: 'range'}));
  const value = make('output');
  const show = () => {
    for (const key of ['min', 'max', 'step', 'value']) input[key] = model.get(key);
    value.textContent = model.get('value');
  };
  show();
  model.on('change', show);
  input.addEventListener(model.get('continuous_update') ? 'input' : 'change', () => {
    model.set('value', Number(input.value));
    model.save_changes();
  });
  return make('label', {}, model.get('description'), ' ', input, ' ', value);
}

/** One output of a cell: a widget with all that is in it. */
export class View {
  /** @type {Map<string, Handle>} */
  handles = new Map();
  /** What its front ends still load. @type {Promise<void>[]} */
  loading = [];

  /**
   * @param {import('./page.js').Page} page
   * @param {string} cell
   * @param {string} root The name of the widget.
   * @param {Record<string, any>} states Of all widgets in it, by their names; those of the kernel if it has them.
   */
  constructor(page, cell, root, states) {
    this.page = page;
    this.cell = cell;
    this.states = states;
    // What stands in the text, and what may stand beside it.
    this.inner = make('div', {className: 'live-view'}, this.draw(root));
    this.element = make('div', {}, this.inner);
    page.views.add(this);
    page.margin.take(this);
  }

  /** @param {string} name */
  handle(name) {
    let handle = this.handles.get(name);
    if (!handle) {
      const kernels = this.page.widgets.get(name);
      handle = new Handle(this, name, kernels ?? this.states[name] ?? {});
      handle.isLive = Boolean(kernels);
      this.handles.set(name, handle);
    }
    return handle;
  }

  /** The kernel has run the cell, so all in it are the kernel's. */
  goLive() {
    for (const [name, handle] of [...this.handles]) {
      const state = this.page.widgets.get(name);
      if (state && !handle.isLive) handle.goLive(state);
    }
  }

  /** @param {string} name */
  draw(name) {
    const model = this.handle(name);
    const element = make('div');
    const kind = model.get('_model_name');
    element.classList.add(...(model.get('_dom_classes') ?? []));
    if (kind === 'HTMLModel') {
      element.classList.add('widget-html');
      const show = () => drawAnew(element, model.get('value'));
      show();
      model.on('change:value', show);
    } else if (/BoxModel$/.test(kind)) {
      element.classList.add(`widget-${kind.replace('Model', '').toLowerCase()}`);
      this.fill(element, model);
    } else if (kind === 'AnyModel' && isOfCourse(model.get('_esm'))) {
      this.loading.push(this.begin(element, model));
    } else if (/^(Float|Int)SliderModel$/.test(kind)) {
      element.append(slider(model));
    } else {
      const name = kind.replace('Model', '');
      element.append(`JupyterLab shows a widget here (${name}). A page shows sliders and the course’s widgets only.`);
    }
    return element;
  }

  /** @param {HTMLElement} element @param {Handle} model */
  fill(element, model) {
    /** @type {Map<string, HTMLElement>} */
    let shown = new Map();
    const show = () => {
      const names = model.get('children').map((/** @type {string} */ each) => each.slice(PREFIX.length));
      shown = new Map(names.map((/** @type {string} */ name) => [name, shown.get(name) ?? this.draw(name)]));
      element.replaceChildren(...shown.values());
    };
    show();
    model.on('change:children', show);
  }

  /** @param {HTMLElement} el @param {Handle} model */
  async begin(el, model) {
    addStyle(model.get('_css'));
    const {default: front} = await load(model.get('_esm'));
    await front.initialize?.({model});
    front.render({model, el});
  }
}
