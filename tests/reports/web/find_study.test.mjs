import assert from "node:assert/strict";
import { after, test } from "node:test";
import { close, draw_all, open, text_in, write } from "./browser.mjs";

after(close);

const ruler = (engine) => ({
  engine,
  scenes: 19,
  not_supported: 9,
  failed: 0,
  wrong: 3,
  compared: 10,
  closed: 10,
  energy_rise_median: 1e-8,
  "energy_rise_above_0.1_percent": 0.44,
  "energy_rise_above_1_percent": 0.33,
  overlap_median: 0.0012,
  overlap_nine_in_ten: null,
});
const found = (engine, reason, posed) => ({
  name: `${engine}-${reason}`,
  engine,
  reason,
  words: `breaks the ${reason} by 0.00127 m, 2.41 times what is allowed, at 0.583 s: a body with quite a long name`,
  times: 1,
  from: "plane/0",
  posed,
  drawn_bodies: 18,
  bodies: 2,
  moving_bodies: 1,
  file: `found/${engine.replace(/\W/g, "-")}.json`,
});
const kinds = ["belt", "chain", "composite", "cradle", "door", "drop", "drum", "fast", "flight", "heap", "jointed", "painleve", "pair", "plane"];
const sample = {
  study: {
    plumb: 2,
    study: "find",
    about: "Random scenes",
    configuration: { kinds, seed: 1 },
    environment: { processor: "one" },
    results: [],
    timings: { results: {} },
    findings: {
      scenes: 19,
      engines: [ruler("box2d"), ruler("impulse")],
      found: [found("box2d", "relation turn", "well"), found("exec:python3 mine.py", "invariant energy", "ambiguous"), found("fault:no-friction", "invariant cone", "well")],
    },
  },
};

for (const width of [360, 1280]) {
  test(`a search fits ${width} px and shows each finding with what runs it again`, async () => {
    const { page, trouble } = await open(await write(sample), { width });
    await draw_all(page);
    assert.deepEqual(trouble, []);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true);
    const told = await text_in(page.locator("#found"));
    assert.match(told, /\.\/plumb run out\/found\/box2d\.json --engine box2d --engine impulse --relations/);
    assert.match(told, /\.\/plumb run out\/found\/exec-python3-mine-py\.json --engine "exec:python3 mine\.py" --engine impulse(?! --rel)/);
    assert.match(told, /\.\/plumb find --again out\/found/);
    assert.match(await text_in(page.locator("#environment")), /belt, chain, composite/);
    if (width < 1000) return;
    for (const table of await page.locator("table").all()) {
      assert.equal(await table.evaluate((it) => it.scrollWidth <= it.parentElement.clientWidth + 1), true, "no column is out of sight");
    }
  });
}
