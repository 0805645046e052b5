import assert from 'node:assert/strict';
import {test} from 'node:test';
import {marksOf} from '../../param_tutorial/param_tutorial/notebook/veil.js';

const ASKED = ["exercises.predict('1-1')", 'print(1)', '*One.* A text.', 'print(2)', 'Two.\n\n## Next\n\nThree.', '4'];

/** Return the marks of cells, of which those in italics or with a full stop are text, as letters. */
function letters(sources, lifted = []) {
  const cells = sources.map(source => ({type: /\.$|^#/m.test(source) ? 'markdown' : 'code', source}));
  return marksOf(cells, lifted)
    .map(mark => ({'': '-', 'param-veils': '?', 'param-veiled': 'x'})[mark])
    .join('');
}

test('texts and outputs are veiled up to the next heading', () => {
  assert.equal(letters(ASKED), '?xxxx-');
  assert.equal(letters(["exercises.predict('1-1')", '1', '## Next', '2']), '?x--');
});

test('nothing is veiled once the question is committed to or skipped, or taken out', () => {
  assert.equal(letters(ASKED, ['1-1']), '------');
  assert.equal(letters(ASKED.slice(1)), '-----');
  assert.equal(letters(["# exercises.predict('1-1').", '1']), '--');
  assert.equal(letters(ASKED, ['1-2']), '?xxxx-');
});

test('the next question veils what follows it', () => {
  const two = ["exercises.predict('1-1')", '1', "import x\n\nexercises.predict('1-2')", '2', 'A text.'];
  assert.equal(letters(two), '?x?xx');
  assert.equal(letters(two, ['1-1']), '--?xx');
  assert.equal(letters(two, ['1-2']), '?x---');
});

test('a comment in code of a text is no heading', () => {
  assert.equal(letters(["exercises.predict('1-1')", 'In YAML.\n```\n# a comment\n```\nMore.', '1']), '?xx');
});

test('a question on an earlier chapter veils nothing', () => {
  assert.equal(letters(["exercises.recall('4-r1')", '1', 'A text.']), '---');
});
