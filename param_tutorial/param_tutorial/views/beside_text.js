/* In JupyterLab, views beside the text that is about them: in sight, and once, whatever cells show them again.

   Each `SideBySide` offers its views, and each `RobotPicture` itself. They belong to the section of their cell, up to the
   next heading `## …`, and to each later section whose heading's cell has the tag `stage`, until others do. Beside other text
   they fold to a strip, which a click unfolds. Where JupyterLab has no room, and everywhere else, the views stand in the
   cells. Each widget has a copy of this script, so what they share is kept with the notebook's element. */

import {make, one} from '../../param_tools/panel/dom.js';
import {initialize} from '../../param_tools/panel/front.js';

/**
 * What a cell offers.
 * @typedef {object} Offer
 * @property {Set<HTMLElement>} cells Where it is drawn in the notebook: nowhere yet if its cell is out of sight.
 * @property {string} views Which ones.
 * @property {string} nodes The names of their nodes, in words.
 * @property {() => string} shown The id of the widget that the cell shows.
 * @property {() => Promise<any>} draw Draws them once more.
 * @property {Place} [place]
 */

/** By the ids of the widgets. @type {Map<string, Offer>} */
const offers = new Map();
/** Below this the text would have too little room. */
const MIN_WIDTH_PX = 900;
/** The text in sight is the last that begins above this part of the height. */
const IN_SIGHT = 2 / 3;
/** So long the text must stand still, and what moves it in this time is the stage. */
const QUIET_MS = 200;

/** The place beside the text of a notebook. */
class Place {
  /** @type {Set<Offer>} */
  offers = new Set();
  /** What the text in sight is about. @type {Offer | undefined} */
  about;
  /** What the reader chose beside this text. @type {Offer | undefined} */
  chosen;
  /** @type {Offer | undefined} */
  shown;
  /** What the shown offer has drawn. @type {any} */
  view;
  isWanted = true;
  quietUntil = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  timer;
  element = make('aside', {className: 'beside-text', tabIndex: -1});
  body = make('div', {className: 'side-by-side'});
  strip = make('button', {type: 'button', className: 'beside-strip'});

  /** @param {any} widget JupyterLab's notebook, with its toolbar. */
  constructor(widget) {
    this.panel = /** @type {HTMLElement} */ (widget.node);
    this.notebook = widget.content;
    this.text = one(this.panel, '.jp-WindowedPanel-outer');
    this.element.setAttribute('aria-label', 'Beside the text');
    const back = make('button', {type: 'button', className: 'beside-button'}, 'Show in the cell');
    back.title = 'Show the views in the notebook, below the cell that made them';
    this.strip.title = 'Show the views here, beside the text';
    back.addEventListener('click', () => this.want(undefined));
    this.strip.addEventListener('click', () => this.want(this.nearest().offer));
    // Before JupyterLab hears it, which would go back to the cell that it knows as active, and stay there.
    this.element.addEventListener('keydown', event => this.goOn(event), {capture: true});
    this.element.append(this.strip, back, this.body);
    this.panel.append(this.element);
    this.resized = new ResizeObserver(() => this.update());
    this.resized.observe(this.panel);
    this.text.addEventListener('scroll', () => performance.now() < this.quietUntil || this.update(QUIET_MS));
    this.notebook.activeCellChanged.connect(() => this.update(QUIET_MS));
    for (const end of ['pointerleave', 'focusout']) this.element.addEventListener(end, () => this.update(QUIET_MS));
  }

  /** @param {Offer | undefined} offer What the reader wants beside this text; without one, it goes into the cells. */
  want(offer) {
    this.isWanted = Boolean(offer);
    this.chosen = offer;
    this.show();
    (offer ? this.element : this.strip).focus();
  }

  /** Shift + Enter runs the notebook's cell, also from a box beside it. @param {KeyboardEvent} event */
  goOn(event) {
    if (event.key !== 'Enter' || !event.shiftKey) return;
    event.preventDefault();
    event.stopPropagation();
    /** @type {any} */ (window).jupyterapp.commands.execute('notebook:run-cell-and-select-next');
  }

  /** Show what there is now: when a kernel ends, all offers are withdrawn, one after the other. */
  update(afterMs = 0) {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.show(), afterMs);
  }

  /** Return the cell in sight: the active one, if it is about an offer, or else the last of the text. */
  cellInSight() {
    const {top, height, bottom} = this.text.getBoundingClientRect();
    // After a reload, JupyterLab puts most of the cells onto the page later.
    const tops = this.notebook.widgets.map((/** @type {any} */ {node}) =>
      node.offsetParent ? node.getBoundingClientRect().top : Infinity,
    );
    const active = this.notebook.activeCellIndex;
    const isSeen = tops[active] < bottom && this.notebook.widgets[active].node.getBoundingClientRect().bottom > top;
    if (isSeen && this.nearest(active).isAbout) return active;
    return tops.findLastIndex((/** @type {number} */ each) => each <= top + IN_SIGHT * height);
  }

  /** Return the offer of the nearest cell above the text in sight, and whether that text is about it. */
  nearest(index = this.cellInSight()) {
    const all = [...this.offers];
    /** @type {boolean | undefined} */
    let isStage;
    for (; index >= 0; index--) {
      const {model} = this.notebook.widgets[index];
      const outputs = Array.from({length: model.outputs?.length ?? 0}, (_, at) => model.outputs.get(at).data);
      const ids = outputs.map(data => data['application/vnd.jupyter.widget-view+json']?.model_id);
      const offer = all.find(each => ids.includes(each.shown()));
      if (offer) return {offer, isAbout: isStage ?? true};
      // The first heading above the text in sight is that of its section.
      if (model.type === 'markdown' && /^## /m.test(model.sharedModel.source))
        isStage ??= Boolean(model.getMetadata('tags')?.includes('stage'));
    }
    return {offer: all[0], isAbout: false};
  }

  /** Show what the text in sight is about, or the reader chose, if there is room, and say so in the cells. */
  async show() {
    const hasRoom = this.panel.clientWidth >= MIN_WIDTH_PX;
    const {offer, isAbout} = this.nearest();
    // What a reader uses stays.
    const isUsed = this.element.matches(':hover, :has(:focus-visible)') && this.about && this.offers.has(this.about);
    if (!isUsed && this.about !== (isAbout ? offer : undefined)) {
      this.about = isAbout ? offer : undefined;
      this.chosen = undefined;
    }
    if (this.chosen && !this.offers.has(this.chosen)) this.chosen = undefined;
    const wanted = hasRoom && this.isWanted ? (this.chosen ?? this.about) : undefined;
    this.fold(!hasRoom || !offer ? undefined : wanted ? 'open' : 'strip');
    this.strip.textContent = `◂ ${offer?.nodes}`;
    for (const {cells, views} of this.offers) {
      for (const cell of cells) {
        cell.toggleAttribute('data-is-beside', hasRoom && this.isWanted);
        one(cell, 'button').textContent = views === wanted?.views ? 'Shown at the right →' : 'Show at the right →';
        cell.toggleAttribute('data-has-room', hasRoom);
      }
    }
    if (this.shown && wanted && this.shown.views === wanted.views && this.offers.has(this.shown)) return;
    // Once the notebook is closed there is nothing to take from the page.
    if (this.view?.el.isConnected) this.view.remove();
    this.view = undefined;
    this.shown = wanted;
    if (!wanted) return;
    const view = await wanted.draw();
    // Meanwhile another one may have taken the place.
    if (this.shown !== wanted) view.remove();
    else {
      this.view = view;
      view.luminoWidget.constructor.attach(view.luminoWidget, this.body);
    }
  }

  /** Give the stage its width, and keep the line that is read where it is. @param {'open' | 'strip' | undefined} state */
  fold(state) {
    if (this.panel.dataset.besideText === state) return;
    const {node} = this.notebook.widgets[this.cellInSight()] ?? this.notebook;
    const before = node.getBoundingClientRect().top;
    if (state) this.panel.dataset.besideText = state;
    else delete this.panel.dataset.besideText;
    // JupyterLab hides the toolbar of a cell whose text it would cover; now that is narrower.
    this.notebook.activeCell?.displayChanged.emit();
    this.text.scrollTop += node.getBoundingClientRect().top - before;
    this.quietUntil = performance.now() + QUIET_MS;
  }
}

/** @param {Offer} offer @param {any} manager The widgets', which knows their notebook, also while that is out of sight. */
function putBeside(offer, manager) {
  for (const widget of /** @type {any} */ (window).jupyterapp?.shell.widgets('main') ?? []) {
    if (widget.context !== manager.context || offer.place) continue;
    widget.node.besideText ??= new Place(widget);
    offer.place = /** @type {Place} */ (widget.node.besideText);
    offer.place.offers.add(offer);
  }
}

/** @param {import('@anywidget/types').InitializeProps<{own_id: string, shown: string, box: string, views: string, nodes: string}>} props */
async function offerViews(props) {
  const {model} = props;
  const manager = /** @type {any} */ (model.widget_manager);
  /** @type {Offer} */
  const offer = {
    cells: new Set(),
    views: model.get('views'),
    nodes: model.get('nodes'),
    shown: () => model.get('shown'),
    draw: async () => manager.create_view(await manager.get_model(model.get('box').slice('IPY_MODEL_'.length))),
  };
  offers.set(model.get('own_id'), offer);
  putBeside(offer, manager);
  // Its cell is known only after the widget has come.
  model.on('change:shown', () => offer.place?.update());
  offer.place?.update();
  function withdraw() {
    offers.delete(model.get('own_id'));
    offer.place?.offers.delete(offer);
    for (const cell of offer.cells) cell.removeAttribute('data-is-beside');
    offer.place?.update();
  }
  await initialize(props);
  // What a kernel that has ended has left stands in the cells, where a click brings it back.
  const widget = await manager.get_model(model.get('own_id'));
  widget.on('comm_live_update', () => widget.comm_live || withdraw());
  return withdraw;
}

/** @param {import('@anywidget/types').RenderProps<{own_id: string}>} props */
function render({model, el}) {
  const offer = offers.get(model.get('own_id'));
  if (!offer) return;
  const cell = /** @type {HTMLElement} */ (el);
  const button = make('button', {type: 'button', className: 'beside-button', title: 'They stay in sight there'});
  cell.classList.add('beside-offer');
  cell.append(button);
  button.addEventListener('click', () => offer.place?.want(offer));
  offer.cells.add(cell);
  // Before it is on the page, or it would be seen in the cell for a moment.
  offer.place?.show();
  const arrived = new ResizeObserver(() => {
    putBeside(offer, model.widget_manager);
    offer.place?.update();
  });
  arrived.observe(cell);
  return () => {
    arrived.disconnect();
    offer.cells.delete(cell);
  };
}

export default {initialize: offerViews, render};
