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

test('every reported scene follows the schema', async () => {
  const folder = new URL('scenarios/tracker/', root);
  for (const file of (await readdir(folder)).filter((name) => name.endsWith('.json'))) {
    assert.ok(is_scene(await json(new URL(file, folder))), `${file}: ${JSON.stringify(is_scene.errors, null, 1)}`);
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

// Every line that the example of Python 3 exchanges with `plumb engine check` would do too; these are one of each kind.
test('the schema of the protocol takes what it describes and nothing else', async () => {
  const is_line = await validator('reference/programs/engine.schema.json');
  const state = [0, 1, 0, 0, 0, 0];
  const lines = [
    {hello: 1},
    {'plumb-engine': 1, name: 'mine', version: '1', options: [{key: 'n', value: '1', about: 'iterations', min: 1, max: 9}]},
    {stepping: {dt: 0.1, options: {n: '1'}}},
    {stepping: {arithmetic: 'float', substep: 0.01, drift: 0.5, order: 1}},
    {build: {scene: {}, masses: [[1, 1, 0, 0]], options: {}}},
    {states: [state]},
    {notSupported: 'no joints'},
    {step: {count: 3, dt: 0.1}},
    {step: 1, states: [state], ns: 100, contacts: [[0, 1, 0, 0, 0, 1, 2, 0, -0.1]]},
    {error: 'unknown ask'},
    {end: true},
  ];
  for (const line of lines) assert.ok(is_line(line), `${JSON.stringify(line)}: ${JSON.stringify(is_line.errors)}`);
  const wrong = [{}, {hello: 2}, {states: [[0, 1]]}, {step: 1, states: [state]}, {stepping: {skin: 1}}, {end: false}, {'plumb-engine': 1, name: 'my engine', version: '1'}];
  for (const line of wrong) assert.ok(!is_line(line), JSON.stringify(line));
});
