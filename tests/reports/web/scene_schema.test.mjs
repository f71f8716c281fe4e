import Ajv from 'ajv/dist/2020.js';
import assert from 'node:assert/strict';
import {readdir, readFile} from 'node:fs/promises';
import {join} from 'node:path';
import {test} from 'node:test';

const json = async (file) => JSON.parse(await readFile(file, 'utf8'));
const root = new URL('../../../', import.meta.url);
const schema = await json(new URL('scenarios/scene.schema.json', root));
const files = new URL('tests/scenarios/scene_files/', root);
const fits = new Ajv({strict: true, strictTypes: false, strictRequired: false, allErrors: true}).compile(schema);
const scenes = process.env.PLUMB_SCENES;

test('every exported scene is what the schema says', {skip: scenes ? false : 'PLUMB_SCENES is not set'}, async () => {
  const exported = await readdir(scenes);
  assert.ok(exported.length > 0);
  for (const file of exported) {
    assert.ok(fits(await json(join(scenes, file))), `${file}: ${JSON.stringify(fits.errors, null, 1)}`);
  }
});

test('the schema takes every feature', async () => {
  assert.ok(fits(await json(new URL('every_feature.json', files))), JSON.stringify(fits.errors, null, 1));
});

// The table of the reader's own test: one place is changed a row.
function changed(scene, row) {
  const keys = row.at.split('/').slice(1);
  const last = keys.pop();
  const parent = keys.reduce((value, key) => value[key], scene);
  if ('put' in row) parent[last] = row.put;
  else delete parent[last];
  return scene;
}

test('the schema refuses what the reader refuses, as far as a schema can', async () => {
  for (const row of await json(new URL('refused.json', files))) {
    const scene = changed(await json(new URL('every_feature.json', files)), row);
    assert.equal(fits(scene), row.beyondSchema === true, JSON.stringify(row));
  }
});
