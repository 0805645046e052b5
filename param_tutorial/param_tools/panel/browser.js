/* The nodes of a robot: a list that follows them as they come and go, and a search over all their parameters.

   What is opened stands below it, as panels of their own. */

function element(tag, className, text) {
  const made = document.createElement(tag);
  made.className = className;
  if (text !== undefined) made.textContent = text;
  return made;
}

function render({model, el}) {
  const search = element('input', 'param-search');
  search.type = 'search';
  search.placeholder = 'Search nodes and parameters: names, descriptions, values';
  search.setAttribute('aria-label', 'Search nodes and parameters');
  const status = element('span', 'param-status');
  status.setAttribute('role', 'status');
  const head = element('div', 'param-head');
  head.append(element('span', 'param-node', 'Nodes'), status, search);
  const list = element('ul', 'node-list');
  el.append(head, list);
  const lines = new Map();

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

  function line(name) {
    const made = element('li', 'node-line');
    const open = element('button', 'node-open', name);
    open.type = 'button';
    open.addEventListener('click', () => model.send({do: 'toggle', node: name}));
    made.append(open, element('span', 'node-says'), element('span', 'node-hits'));
    return made;
  }

  function show() {
    const {nodes, status: words} = model.get('state');
    status.textContent = words;
    for (const [name, old] of lines) if (!nodes.some(each => each.name === name)) { old.remove(); lines.delete(name); }
    nodes.forEach((node, index) => {
      if (!lines.has(node.name)) lines.set(node.name, line(node.name));
      const at = lines.get(node.name);
      if (list.children[index] !== at) list.insertBefore(at, list.children[index] || null);
      at.querySelector('.node-open').setAttribute('aria-expanded', String(node.is_open));
      const says = at.querySelector('.node-says');
      says.textContent = node.says;
      says.classList.toggle('param-status-bad', node.is_bad);
      const hits = at.querySelector('.node-hits');
      if (hits.dataset.hits === JSON.stringify(node.hits)) return;
      hits.dataset.hits = JSON.stringify(node.hits);
      hits.replaceChildren(...node.hits.map(([hit, value]) => {
        const found = element('button', 'node-hit', `${hit} = ${value}`);
        found.type = 'button';
        found.addEventListener('click', () => model.send({do: 'open', node: node.name, search: hit}));
        return found;
      }));
    });
  }

  show();
  model.on('change:state', show);
  return () => model.off('change:state', show);
}

export default {initialize, render};
