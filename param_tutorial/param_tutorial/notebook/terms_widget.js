/* Marks the words of the course in a notebook of JupyterLab: the first use of each in a section.

   JupyterLab draws a text when it comes into sight, and anew when it was edited. */

import {all} from '../../param_tools/panel/dom.js';
import {ownNotebook} from './own_notebook.js';
import {entriesOf, hide, markerOf} from './terms.js';

/** @import {InitializeProps} from '@anywidget/types' */
/** @import {Meaning} from './terms.js' */

const TEXT = '.jp-MarkdownCell .jp-MarkdownOutput';
const HEADINGS = 'h1, h2, h3';
const BLOCKS = `${HEADINGS}, p, ul > li, ol > li, .lesson-term`;
const TITLE = /^# ([\d.]+) · /;

/** @param {InitializeProps<{own_id: string, words: Record<string, Meaning[]>}>} props */
async function begin(props) {
  const {model} = props;
  const notebook = await ownNotebook(props);
  if (!notebook) return;
  const {context, shell, views} = notebook;
  const [, chapter] = TITLE.exec(context.model.cells.get(0).sharedModel.getSource()) ?? [];
  if (!chapter) return;
  const mark = markerOf(entriesOf(model.get('words'), chapter));

  /** @param {Element} notebook */
  function markAll(notebook) {
    let seen = new Set();
    for (const text of all(notebook, TEXT)) {
      const isMarked = text.hasAttribute('data-terms');
      text.setAttribute('data-terms', '');
      for (const block of all(text, BLOCKS)) {
        if (block.matches(HEADINGS)) seen = new Set();
        else if (block.matches('.lesson-term')) seen.add(Number(block.dataset.number));
        else if (!isMarked) mark(block, seen);
      }
    }
  }

  /** Mark what there is, and what is drawn later. */
  function follow() {
    for (const {content} of views()) {
      if (content.node.hasAttribute('data-terms')) continue;
      content.node.setAttribute('data-terms', '');
      markAll(content.node);
      content.node.addEventListener('scroll', hide, true);
      let frame = 0;
      new MutationObserver(changes => {
        const isText = changes.some(({target, addedNodes}) =>
          [target, ...addedNodes].some(node => node instanceof Element && node.closest('.jp-MarkdownCell')),
        );
        if (!isText) return;
        cancelAnimationFrame(frame);
        frame = requestAnimationFrame(() => markAll(content.node));
      }).observe(content.node, {childList: true, subtree: true});
    }
  }
  follow();
  shell.currentChanged.connect(follow); // to another view of the same notebook
}

export default {initialize: begin};
