/* The editor of a cell: CodeMirror, which the page loads when a reader edits for the first time. */

import {defaultKeymap, history, historyKeymap, indentWithTab} from '@codemirror/commands';
// Without the completion that `python()` adds: no part of it knows rclpy.
import {pythonLanguage} from '@codemirror/lang-python';
import {indentOnInput, indentUnit, syntaxHighlighting} from '@codemirror/language';
import {EditorView, keymap, lineNumbers} from '@codemirror/view';
import {tagHighlighter, tags} from '@lezer/highlight';

// The colors of the other cells: those that the theme has for the classes of Pygments.
const COLORS = tagHighlighter([
  {tag: tags.keyword, class: 'k'},
  {tag: [tags.bool, tags.null], class: 'kc'},
  {tag: tags.operatorKeyword, class: 'ow'},
  {tag: tags.comment, class: 'c1'},
  {tag: tags.string, class: 's1'},
  {tag: tags.number, class: 'mi'},
  {tag: tags.operator, class: 'o'},
  {tag: tags.meta, class: 'nd'},
  {tag: tags.definition(tags.className), class: 'nc'},
  {tag: tags.function(tags.definition(tags.variableName)), class: 'nf'},
]);

/**
 * Return an editor; Tab indents in it, and after Escape leaves it.
 * @param {string} code
 * @param {(code: string) => void} onChange
 * @param {() => void} onRun
 */
export function makeEditor(code, onChange, onRun) {
  const run = () => {
    onRun();
    return true;
  };
  return new EditorView({
    doc: code,
    extensions: [
      lineNumbers(),
      EditorView.lineWrapping,
      history(),
      indentOnInput(),
      indentUnit.of('    '),
      pythonLanguage,
      syntaxHighlighting(COLORS),
      keymap.of([
        {key: 'Shift-Enter', run},
        {key: 'Mod-Enter', run},
        ...defaultKeymap,
        ...historyKeymap,
        indentWithTab,
      ]),
      // Sphinx takes this key for its search, but in boxes.
      EditorView.domEventHandlers({keydown: event => (event.key === '/' ? event.stopPropagation() : undefined)}),
      EditorView.updateListener.of(update => update.docChanged && onChange(update.state.doc.toString())),
      EditorView.editorAttributes.of({class: 'highlight'}),
      EditorView.contentAttributes.of({
        tabindex: '0', // for axe, which knows no editable text that the keyboard reaches
        'aria-label': 'The code of this cell',
        'aria-description': 'Tab indents. To leave the editor, press Escape and then Tab.',
      }),
    ],
  });
}
