import assert from 'node:assert/strict';
import {test} from 'node:test';
import {patternOf} from '../../param_tutorial/param_tutorial/site/scripts/glossary.js';

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
