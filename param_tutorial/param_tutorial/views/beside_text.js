/* In JupyterLab, two views beside the text of their notebook: in sight, and once, whatever cells show them again.

   Each `SideBySide` offers its views. Beside the text stand those of the cell that ran last, or that the reader chose; in
   the cells that offer the same ones, a button leads there. Where JupyterLab has no room, and everywhere else, the views
   stand in the cells. Each widget has a copy of this script, so what they share is kept with the notebook's element. */

import {make, one} from '../../param_tools/panel/dom.js';
import {initialize} from '../../param_tools/panel/front.js';

/**
 * What a cell offers.
 * @typedef {object} Offer
 * @property {Set<HTMLElement>} cells Where it is drawn in the notebook: nowhere yet if its cell is out of sight.
 * @property {string} views Which ones.
 * @property {number} at When the cell ran, or the reader chose it, in seconds.
 * @property {() => Promise<any>} draw Draws them once more.
 * @property {Place} [place]
 */

/** By the ids of the widgets. @type {Map<string, Offer>} */
const offers = new Map();
/** Of a notebook in JupyterLab, with its toolbar. */
const PANEL = '.jp-NotebookPanel';
/** Below this the text would have too little room. */
const MIN_WIDTH_PX = 900;

/** The place beside the text of a notebook. */
class Place {
  /** @type {Set<Offer>} */
  offers = new Set();
  /** @type {Offer | undefined} */
  shown;
  /** What the shown offer has drawn. @type {any} */
  view;
  isWanted = true;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  timer;
  element = make('aside', {className: 'beside-text', tabIndex: -1});
  body = make('div', {className: 'side-by-side'});

  /** @param {HTMLElement} panel */
  constructor(panel) {
    this.panel = panel;
    this.element.setAttribute('aria-label', 'Beside the text');
    const back = make('button', {type: 'button', className: 'beside-button'}, 'Put into the cell');
    back.addEventListener('click', () => this.want(false));
    this.element.append(back, this.body);
    panel.append(this.element);
    this.resized = new ResizeObserver(() => this.update());
    this.resized.observe(panel);
  }

  /** @param {boolean} isWanted */
  want(isWanted) {
    this.isWanted = isWanted;
    this.show();
    if (isWanted) this.element.focus();
  }

  /** Show what there is now: when a kernel ends, all offers are withdrawn, one after the other. */
  update() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.show());
  }

  /** Show what was offered or chosen last, if there is room, and say so in the cells. */
  async show() {
    const [last] = [...this.offers].sort((one, other) => other.at - one.at);
    const isShown = Boolean(last) && this.isWanted && this.panel.clientWidth >= MIN_WIDTH_PX;
    this.panel.toggleAttribute('data-beside-text', isShown);
    for (const {cells, views} of this.offers) {
      for (const cell of cells) {
        const isBeside = isShown && views === last.views;
        cell.toggleAttribute('data-is-beside', isBeside);
        one(cell, 'button').textContent = isBeside ? 'Beside the text →' : 'Put beside the text';
        cell.toggleAttribute('data-has-room', this.panel.clientWidth >= MIN_WIDTH_PX);
      }
    }
    if (this.shown && isShown && this.shown.views === last.views && this.offers.has(this.shown)) return;
    // Once the notebook is closed there is nothing to take from the page.
    if (this.view?.el.isConnected) this.view.remove();
    this.view = undefined;
    this.shown = isShown ? last : undefined;
    if (!this.shown) return;
    const view = await this.shown.draw();
    // Meanwhile another one may have taken the place.
    if (this.shown !== last) view.remove();
    else {
      this.view = view;
      view.luminoWidget.constructor.attach(view.luminoWidget, this.body);
    }
  }
}

/** @param {Offer} offer @param {Element | null} panel */
function putBeside(offer, panel) {
  if (!panel || offer.place) return;
  const shared = /** @type {any} */ (panel);
  shared.besideText ??= new Place(shared);
  offer.place = /** @type {Place} */ (shared.besideText);
  offer.place.offers.add(offer);
}

/** @param {import('@anywidget/types').InitializeProps<{own_id: string, box: string, views: string, at: number}>} props */
async function offerViews(props) {
  const {model} = props;
  const manager = /** @type {any} */ (model.widget_manager);
  /** @type {Offer} */
  const offer = {
    cells: new Set(),
    views: model.get('views'),
    at: model.get('at'),
    draw: async () => manager.create_view(await manager.get_model(model.get('box').slice('IPY_MODEL_'.length))),
  };
  offers.set(model.get('own_id'), offer);
  // JupyterLab draws a cell only once it is in sight, and the manager of the widgets knows their notebook before.
  for (const panel of /** @type {any} */ (window).jupyterapp?.shell.widgets('main') ?? []) {
    if (panel.context === manager.context) putBeside(offer, panel.node);
  }
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
  const button = make('button', {type: 'button', className: 'beside-button'});
  cell.classList.add('beside-offer');
  cell.append(button);
  button.addEventListener('click', () => {
    offer.at = Date.now() / 1000;
    offer.place?.want(true);
  });
  offer.cells.add(cell);
  // Before it is on the page, or it would be seen in the cell for a moment.
  offer.place?.show();
  const arrived = new ResizeObserver(() => {
    putBeside(offer, cell.closest(PANEL));
    offer.place?.update();
  });
  arrived.observe(cell);
  return () => {
    arrived.disconnect();
    offer.cells.delete(cell);
  };
}

export default {initialize: offerViews, render};
