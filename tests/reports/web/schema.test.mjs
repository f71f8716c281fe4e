// The schemas of report.json and of scene files, against real files and against broken ones.
import Ajv from 'ajv/dist/2020.js';
import assert from 'node:assert/strict';
import {readdir, readFile} from 'node:fs/promises';
import {dirname, join} from 'node:path';
import {test} from 'node:test';

const root = new URL('../../../', import.meta.url);
const json = async (file) => JSON.parse(await readFile(file, 'utf8'));
const validator = async (file) =>
  new Ajv({strict: true, strictTypes: false, strictRequired: false, allErrors: true}).compile(await json(new URL(file, root)));
const is_report = await validator('reports/report.schema.json');
const is_scene = await validator('scenarios/scene.schema.json');
const real = process.env.PLUMB_REPORT && join(dirname(process.env.PLUMB_REPORT), 'report.json');
const scenes = process.env.PLUMB_SCENES;
const files = new URL('tests/scenarios/scene_files/', root);

test('the real report follows its schema', {skip: real ? false : 'PLUMB_REPORT is not set'}, async () => {
  assert.ok(is_report(await json(real)), JSON.stringify(is_report.errors, null, 1));
});

test('the schema refuses what it does not know', {skip: real ? false : 'PLUMB_REPORT is not set'}, async () => {
  const mutations = [
    (report) => { report.plumb = 1; },
    (report) => { report.surprise = true; },
    (report) => { delete report.runs[0].verdict; },
    (report) => { report.runs[0].status = 'fine'; },
    (report) => { report.runs[0].status = 'failed'; },
    (report) => { report.runs[0].dt = 0; },
  ];
  for (const change of mutations) {
    const report = await json(real);
    change(report);
    assert.ok(!is_report(report), change.toString());
  }
});

test('every exported scene follows the schema', {skip: scenes ? false : 'PLUMB_SCENES is not set'}, async () => {
  const exported = await readdir(scenes);
  assert.ok(exported.length > 0);
  for (const file of exported) {
    assert.ok(is_scene(await json(join(scenes, file))), `${file}: ${JSON.stringify(is_scene.errors, null, 1)}`);
  }
});

test('the schema takes every feature', async () => {
  assert.ok(is_scene(await json(new URL('every_feature.json', files))), JSON.stringify(is_scene.errors, null, 1));
});

// Applies a row of the table that the test of the reader uses: each changes one value.
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
    assert.equal(is_scene(scene), row.beyondSchema === true, JSON.stringify(row));
  }
});
