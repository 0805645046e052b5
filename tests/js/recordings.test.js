import assert from 'node:assert/strict';
import {test} from 'node:test';
import {deflateSync} from 'node:zlib';
import {Album, key, unknown, unpack} from '../../param_tutorial/param_tutorial/site/scripts/recordings.js';

const pack = content => deflateSync(JSON.stringify(content)).toString('base64');

test('what is packed is unpacked', async () => {
  const content = {node: '/räder', rows: [1, null, '“”']};
  assert.deepEqual(await unpack(pack(content)), content);
});

test('what is damaged is an error', async () => {
  await assert.rejects(unpack('nonsense'));
});

test('an album puts the parts together that pictures share', async () => {
  const film = {picture: {$: [0, 1]}, scenes: [[0, {$: [1]}]], end: null};
  const album = new Album(pack({parts: ['<svg>', '</svg>'], pictures: {'a=1': film}}));
  assert.deepEqual(await album.find('a=1'), {picture: '<svg></svg>', scenes: [[0, '</svg>']], end: null});
  assert.equal(await album.find('constructor'), null);
});

test('a key is the same in whatever order the parameters come', () => {
  assert.equal(key({b: 'x', a: '1'}), 'a=1\nb=x');
  assert.equal(key({}), '');
});

test('what was not recorded is named', () => {
  assert.equal(
    unknown('drive', {a: '1', b: 'x'}),
    'Not recorded: no drive with a = 1, b = x. Run the notebook to see it.',
  );
});
