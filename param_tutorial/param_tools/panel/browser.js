/* The nodes of a robot: a list that follows them as they come and go, and a search over all their parameters.

   What is opened stands below it, as panels of their own. */

import {make, one} from './dom.js';
import {initialize} from './front.js';

/**
 * @import {RenderProps} from '@anywidget/types'
 *
 * @typedef {{name: string, says: string, is_bad: boolean, is_open: boolean, hits: [string, string][]}} ListedNode
 * @typedef {{state: {nodes: ListedNode[], status: string}}} Traits
 */

/** @param {RenderProps<Traits>} props */
function render({model, el}) {
  const search = make('input', {
    className: 'param-search',
    type: 'search',
    placeholder: 'Search nodes and parameters: names, descriptions, values',
    ariaLabel: 'Search nodes and parameters',
  });
  const status = make('span', {className: 'param-status', role: 'status'});
  const list = make('ul', {className: 'node-list'});
  const title = make('span', {className: 'param-title', role: 'heading', ariaLevel: '3'}, 'Parameters of all nodes');
  const hint = make('div', {className: 'node-hint'}, 'Choose the nodes whose parameters you want to see.');
  el.append(make('div', {className: 'param-head'}, title, status, search), hint, list);
  /** @type {Map<string, HTMLElement>} */
  const lines = new Map();

  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  function find() {
    clearTimeout(timer);
    timer = setTimeout(() => model.send({do: 'find', text: search.value}), 150);
  }
  search.addEventListener('input', find);
  search.addEventListener('keydown', event => {
    event.stopPropagation();
    if (event.key !== 'Escape') return;
    search.value = '';
    find();
  });

  /** @param {string} name */
  function line(name) {
    const open = make('button', {type: 'button', className: 'node-open'}, name);
    open.addEventListener('click', () => model.send({do: 'toggle', node: name}));
    const [says, hits] = ['node-says', 'node-hits'].map(className => make('span', {className}));
    return make('li', {className: 'node-line'}, open, says, hits);
  }

  function show() {
    const {nodes, status: words} = model.get('state');
    status.textContent = words;
    for (const [name, old] of lines) {
      if (nodes.some(each => each.name === name)) continue;
      old.remove();
      lines.delete(name);
    }
    nodes.forEach((node, index) => {
      const at = lines.get(node.name) ?? line(node.name);
      lines.set(node.name, at);
      if (list.children[index] !== at) list.insertBefore(at, list.children[index] ?? null);
      one(at, '.node-open').ariaExpanded = String(node.is_open);
      const says = one(at, '.node-says');
      says.textContent = node.says;
      says.classList.toggle('param-status-bad', node.is_bad);
      const hits = one(at, '.node-hits');
      if (hits.dataset.hits === JSON.stringify(node.hits)) return;
      hits.dataset.hits = JSON.stringify(node.hits);
      hits.replaceChildren(
        ...node.hits.map(([hit, value]) => {
          const found = make('button', {type: 'button', className: 'node-hit'}, `${hit} = ${value}`);
          found.addEventListener('click', () => model.send({do: 'open', node: node.name, search: hit}));
          return found;
        }),
      );
    });
  }

  show();
  model.on('change:state', show);
}

export default {initialize, render};
