import assert from 'node:assert/strict';
import {test} from 'node:test';
import {
  excerptOf,
  find,
  matchesOf,
  sectionsOf,
  wordsOf,
} from '../../param_tutorial/param_tutorial/site/scripts/matching.js';

/** Return the places of a word in a text as the marked words with their worth. */
function marks(word, text) {
  return [...matchesOf(word, text)].map(({at, end, worth}) => [text.slice(at, end), worth]);
}

const section = (heading, prose, code = '') => ({anchor: heading, heading, prose, code});

function search(query) {
  const pages = [
    {
      page: '03',
      title: 'Declaring',
      lesson: true,
      sections: [
        section('Declaring', 'Declare a parameter before you use it. Declare it once.'),
        section('Errors', 'A node raises an error.', 'ParameterNotDeclaredException'),
      ],
    },
    {page: '06', title: 'Ranges', lesson: true, sections: [section('Ranges', 'A range limits a parameter.')]},
    {page: 'claims', title: 'Claims', lesson: false, sections: [section('Claims', 'Declare a parameter. Declare it.')]},
  ];
  const {isAll, hits} = find(sectionsOf(pages), query);
  return {isAll, found: hits.map(hit => hit.section.anchor)};
}

test('words are cut at blanks, without quotes and the ends of sentences, each once', () => {
  assert.deepEqual(wordsOf(' The “launch  file”, the LAUNCH! '), ['the', 'launch', 'file"']);
});

test('a whole word is worth more than another form, a beginning or an inside', () => {
  assert.deepEqual(marks('declare', 'declare, declared, declares'), [
    ['declare', 1],
    ['declared', 0.6],
    ['declares', 0.6],
  ]);
  assert.deepEqual(marks('param', 'param parameter ros_parameter'), [
    ['param', 1],
    ['param', 0.2],
    ['param', 0.05],
  ]);
});

test('a hyphen between letters is part of a word, and one at the beginning of an option is none', () => {
  assert.deepEqual(marks('read', 'read-only'), [['read', 0.2]]);
  assert.deepEqual(marks('read-only', 'a read-only value'), [['read-only', 1]]);
  assert.deepEqual(marks('--params-file', 'run --params-file x'), [['--params-file', 1]]);
  assert.deepEqual(marks('be', 'maybe'), []);
});

test('words that are typed apart find those that a hyphen joins', () => {
  const one = {page: '06', title: '', lesson: true, sections: [section('Locks', 'A read-only value stays.')]};
  const other = {page: '04', title: '', lesson: true, sections: [section('Others', 'Read it. Only then set it.')]};
  const {hits} = find(sectionsOf([other, one]), 'read only');
  assert.deepEqual(
    hits.map(hit => [hit.section.anchor, hit.isWhole]),
    [
      ['Locks', true],
      ['Others', true],
    ],
  );
});

test('a section with the word in its heading comes first, and what is no lesson last', () => {
  assert.deepEqual(search('declare'), {isAll: true, found: ['Declaring', 'Errors', 'Claims']});
});

test('a section with the whole word comes before one that has it often inside of others', () => {
  const parts = {page: '01', title: '', lesson: true, sections: [section('Parts', 'Reset, presets, offset, reset.')]};
  const whole = {page: '02', title: '', lesson: true, sections: [section('Whole', 'Many other words, then sets.')]};
  const {hits} = find(sectionsOf([parts, whole]), 'set');
  assert.deepEqual(
    hits.map(hit => hit.section.anchor),
    ['Whole', 'Parts'],
  );
});

test('all words are wanted, and some are better than none', () => {
  assert.deepEqual(search('range parameter'), {isAll: true, found: ['Ranges']});
  assert.deepEqual(search('range nobodywroteit'), {isAll: false, found: ['Ranges']});
  assert.deepEqual(search('nobodywroteit'), {isAll: false, found: []});
});

test('the title of a page alone brings none of its sections', () => {
  assert.deepEqual(search('declaring error').found, ['Errors']);
});

test('an excerpt begins and ends between words, and has as many of the words as it can', () => {
  const text = `${'before '.repeat(40)}first ${'between '.repeat(10)}second ${'after '.repeat(40)}`;
  const matches = ['first', 'second'].flatMap(word => [...matchesOf(word, text)].map(each => ({...each, word})));
  const [from, to] = excerptOf(text, matches);
  const excerpt = text.slice(from, to);
  assert.match(excerpt, /^before .*first between .*second .*after$/);
  assert.ok(excerpt.length <= 170);
  assert.deepEqual(excerptOf('short', []), [0, 5]);
});
