import assert from 'node:assert/strict';
import {test} from 'node:test';
import {choiceOf, parseNumber} from '../../param_tutorial/param_tutorial/exercises/prediction.js';

// What is typed, and the number that it is.
const NUMBERS = [
  ['60', 60],
  ['60.0', 60],
  ['60,0', 60],
  ['60 m', 60],
  ['60m', 60],
  [' 60 rpm ', 60],
  ['60 rpm.', 60],
  ['60 %', 60],
  ['21 °C', 21],
  ['0.5 m/s^2', 0.5],
  ['0,125', 0.125],
  ['.5', 0.5],
  ['1,500', 1500],
  ['1,500.5 m', 1500.5],
  ['-20', -20],
  ['+8', 8],
  ['1e-3', 0.001],
  ['60\u00a0m', 60],
];
const NONE = [
  'ninety',
  'about 60',
  '60 or 90',
  '12:30',
  '1/2',
  '3-4',
  '1,2,3',
  '60 000',
  'nan',
  'inf',
  '0x10 or so',
  '',
];

test('a number is read with its unit and its commas', () => {
  for (const [given, number] of NUMBERS) assert.equal(parseNumber(given), number, given);
  for (const given of NONE) assert.equal(parseNumber(given), Number.NaN, given);
});

test('a typed answer is compared as a number', () => {
  const facts = {verdicts: {150: 'Yes.', 100: 'More.'}, right: '150', otherwise: 'It is 150.'};
  for (const given of ['150', '150 rpm', '150,0', '1.5e2']) assert.equal(choiceOf(given, facts), '150');
  assert.equal(choiceOf('99 rpm', facts), '99 rpm');
  assert.equal(choiceOf('many', facts), '');
});

test('a marker near a choice means that choice', () => {
  const facts = {verdicts: {0.3: 'No.', 0: 'Yes.'}, right: '0', otherwise: 'It is 0.', scale: {tolerance: 0.1}};
  for (const given of ['0', '0.1', '0.2']) assert.equal(choiceOf(given, facts), given === '0.2' ? '0.3' : '0');
  assert.equal(choiceOf('0.5', facts), '0.5');
});

test('an answer that the question no longer has is none', () => {
  const facts = {verdicts: {'a text': 'No.', 'a number': 'Yes.'}, right: 'a number', otherwise: null};
  assert.equal(choiceOf('a text', facts), 'a text');
  assert.equal(choiceOf('a list', facts), '');
});
