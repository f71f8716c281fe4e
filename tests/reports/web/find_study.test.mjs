import assert from "node:assert/strict";
import { after, test } from "node:test";
import { close, draw_all, drawn, open, text_in, until, write } from "./browser.mjs";
import { sample as report_sample } from "./sample.mjs";

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
  job: `cut|${engine}|${reason}|plane/0`,
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
  image: reason.startsWith("relation ") ? `found/${engine.replace(/\W/g, "-")}.image.json` : null,
});
const [film] = report_sample().replays;
const run_of = (engine, index) => ({ ...film.runs[index], engine, method: "" });
const result = (of, films) => ({ key: of.job, ending: "done", reason: "", values: { run: { films } } });
const kinds = ["belt", "chain", "composite", "cradle", "door", "drop", "drum", "fast", "flight", "heap", "jointed", "painleve", "pair", "plane"];
const turned = found("box2d", "relation turn", "well");
const beside_another = found("exec:python3 mine.py", "invariant energy", "ambiguous");
const beside_truth = found("fault:no-friction", "closed form y -", "well");
const sample = {
  study: {
    plumb: 2,
    study: "find",
    about: "Random scenes",
    configuration: { kinds, seed: 1 },
    folder: "my finds",
    environment: { processor: "one" },
    results: [
      result(turned, [
        { ...film, variant: "scene", runs: [run_of("box2d", 0)] },
        { ...film, variant: "image: turn", runs: [run_of("box2d", 1)] },
      ]),
      result(beside_another, [{ ...film, variant: "scene", runs: [run_of("exec:python3 mine.py", 0), run_of("impulse", 1)] }]),
      result(beside_truth, [{ ...film, variant: "scene", runs: [run_of("fault:no-friction", 0), run_of("closed-form:first-impact", 1)] }]),
    ],
    timings: { results: {} },
    findings: {
      scenes: 19,
      engines: [ruler("box2d"), ruler("impulse")],
      found: [turned, beside_another, beside_truth],
    },
  },
};

const article = (page, name) => page.locator("#found article").filter({ has: page.locator("h3", { hasText: name }) });

async function open_replay(page, name) {
  const shown = article(page, name);
  await shown.locator("details > summary").first().click();
  await until(() => shown.locator(".stage[data-ready]").count(), 1);
  await drawn(page);
  return shown;
}

for (const width of [360, 1280]) {
  test(`a search fits ${width} px and shows each finding with what runs it again`, async () => {
    const { page, trouble } = await open(await write(sample), { width });
    await draw_all(page);
    assert.deepEqual(trouble, []);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true);
    assert.match(await page.locator("h1").innerText(), /^Of 19 random scenes, box2d is wrong in \d+ and impulse in \d+: 3 findings\.?$/);
    const told = await page.locator("#found").textContent(); // of what is laid out near the screen only, too
    assert.match(told, /\.\/plumb run 'my finds\/found\/box2d\.json' --engine box2d --engine impulse --relations/);
    assert.match(told, /\.\/plumb run 'my finds\/found\/exec-python3-mine-py\.json' --engine 'exec:python3 mine\.py' --engine impulse(?! --rel)/);
    assert.match(told, /\.\/plumb find --again 'my finds\/found'/);
    assert.match(await text_in(page.locator("#environment")), /belt, chain, composite/);
    if (width < 1000) return;
    for (const table of await page.locator("table").all()) {
      assert.equal(await table.evaluate((it) => it.scrollWidth <= it.parentElement.clientWidth + 1), true, "no column is out of sight");
    }
  });
}

for (const width of [360, 1280]) {
  test(`a broken relation replays the scene and its image beside each other, by one clock, at ${width} px`, async () => {
    const { page, trouble } = await open(await write(sample), { width });
    const shown = await open_replay(page, "box2d");
    assert.match(await text_in(shown), /my finds\/found\/box2d\.json and my finds\/found\/box2d\.image\.json/);
    assert.match(await text_in(shown), /scene[^]*image: turn/);
    const [scene, image] = await Promise.all([0, 1].map((n) => shown.locator("canvas").nth(n).boundingBox()));
    if (width < 1000) assert.ok(image.y > scene.y + scene.height, "below each other on a narrow screen");
    else assert.ok(image.x > scene.x + scene.width && image.y === scene.y, "beside each other");
    assert.equal(await shown.locator("input[type=range]").count(), 1, "one clock");
    const view = (n) => shown.locator("canvas").nth(n).getAttribute("data-view");
    const before = await view(1);
    await shown.getByRole("button", { name: "Zoom in" }).click();
    await drawn(page);
    assert.notEqual(await view(1), before, "the image zooms with the scene");
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true);
    assert.deepEqual(trouble, []);
  });
}

test("another finding replays the engine beside another, or beside the closed form", async () => {
  const { page, trouble } = await open(await write(sample));
  const other = await open_replay(page, "exec:python3 mine.py");
  assert.equal(await other.locator("canvas").count(), 1);
  assert.match(await text_in(other), /Replay of exec:python3 mine\.py and impulse/);
  const truth = await open_replay(page, "fault:no-friction");
  assert.match(await text_in(truth), /Replay of fault:no-friction and closed-form:first-impact/);
  assert.deepEqual(trouble, []);
});

const real = process.env.PLUMB_FIND;

test("the replays of a real search open", { skip: real ? false : "PLUMB_FIND is not set" }, async () => {
  const { page, trouble } = await open(real);
  const folds = page.locator("#found article > details");
  assert.ok((await folds.count()) > 0, "nothing was found");
  for (let n = 0; n < (await folds.count()); ++n) {
    await folds.nth(n).locator("> summary").click();
    await until(() => folds.nth(n).locator(".stage[data-ready]").count(), 1);
    assert.equal(await folds.nth(n).locator("[role=alert]").count(), 0);
  }
  assert.deepEqual(trouble, []);
});
