import assert from 'node:assert/strict';
import {test} from 'node:test';
import {entriesOf, patternOf} from '../../param_tutorial/param_tutorial/notebook/terms.js';

/** Return what is marked in a text. */
function marked(words, text) {
  return [...text.matchAll(patternOf(words))].map(([found, word]) => [found, word]);
}

test('a word is found in its forms, whatever its case', () => {
  assert.deepEqual(marked(['node'], 'Nodes, a node.'), [
    ['Nodes', 'Node'],
    ['node', 'node'],
  ]);
});

test('a part of another word, a path or a name is no word', () => {
  assert.deepEqual(marked(['node'], 'nodelet sub-node /node node_name my.node Knoten'), []);
});

test('of two words that begin alike the longer one is found, over the end of a line too', () => {
  assert.deepEqual(marked(['parameter', 'parameter server'], 'the parameter\n  server'), [
    ['parameter\n  server', 'parameter\n  server'],
  ]);
});

test('signs in a word mean themselves', () => {
  assert.deepEqual(marked(['a.b', 'c++'], 'axb a.b'), [['a.b', 'a.b']]);
});

test('a chapter uses a word in its own meaning, or else in the latest before, or the first', () => {
  const snapshot = ['2', '10.2', '10.5'].map(chapter => ({chapter, code: false, meaning: `of ${chapter}`}));
  const used = ['1', '9.1', '10.2', '11'].map(chapter => entriesOf({snapshot}, chapter)[0].meaning);
  assert.deepEqual(used, ['of 2', 'of 2', 'of 10.2', 'of 10.5']);
});
