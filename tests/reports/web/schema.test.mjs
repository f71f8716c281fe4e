import Ajv from 'ajv/dist/2020.js';
import assert from 'node:assert/strict';
import {readFile} from 'node:fs/promises';
import {dirname, join} from 'node:path';
import {test} from 'node:test';

const json = async (file) => JSON.parse(await readFile(file, 'utf8'));
const schema = await json(new URL('../../../reports/report.schema.json', import.meta.url));
const fits = new Ajv({strict: true, strictTypes: false, strictRequired: false, allErrors: true}).compile(schema);
const real = process.env.PLUMB_REPORT && join(dirname(process.env.PLUMB_REPORT), 'report.json');

test('the real report is what its schema says', {skip: real ? false : 'PLUMB_REPORT is not set'}, async () => {
  assert.ok(fits(await json(real)), JSON.stringify(fits.errors, null, 1));
});

test('the schema refuses what it does not know', {skip: real ? false : 'PLUMB_REPORT is not set'}, async () => {
  const spoil = [
    (report) => { report.plumb = 1; },
    (report) => { report.surprise = true; },
    (report) => { delete report.runs[0].verdict; },
    (report) => { report.runs[0].status = 'fine'; },
    (report) => { report.runs[0].status = 'failed'; },
    (report) => { report.runs[0].dt = 0; },
  ];
  for (const change of spoil) {
    const report = await json(real);
    change(report);
    assert.ok(!fits(report), change.toString());
  }
});
