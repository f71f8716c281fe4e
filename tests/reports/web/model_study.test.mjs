import assert from "node:assert/strict";
import { after, test } from "node:test";
import { close, draw_all, open, text_in, write } from "./browser.mjs";
import { looks_right } from "./views.mjs";

after(close);

const drops = [
  { feature: "contacts", without: "any contact", setting: "contacts=off", change: 20, ratio: 0.1 },
  { feature: "method", without: "<b>sub-steps</b>", setting: "integrator=velocity-verlet,solver=article", change: 2e-6, ratio: 0.5 },
  { feature: "rotation", without: "any turning", setting: "rotation=off", change: 0, ratio: 3 },
  { feature: "method", without: "all", setting: "solver=exact", change: null, ratio: null, why: "holds no joints" },
];

/** A case with a truth and a least model, one without either. */
function sample() {
  const results = [];
  const add = (variant, name, values, truth = "fall") =>
    results.push({
      key: `model|heap/${variant}|${name}`,
      ending: "done",
      reason: "",
      values: { scenario: "heap", variant, line: "impulse", status: "ok", why: "", error: 1e-5, change: 0, within: true, duration: 3, truth, truth_until: 3, compared_until: 0, ...values },
    });
  add("still", "full", { role: "full" });
  for (const drop of drops) add("still", drop.setting, { role: "drop", ...drop, within: drop.change !== null && drop.change <= 1e-4 });
  add("still", "auto", { role: "auto", choices: [{ setting: "rotation=off", reason: "no body turns" }] });
  add("still", "least", { role: "least" });
  add("wild", "full", { role: "full", truth: "", error: null, compared_until: 1.5 });
  add("wild", "auto", { role: "auto", within: false, change: 0.5 });
  results.push({ key: "model|heap/wild|rotation=off", ending: "crashed", reason: "ended by signal 11", values: {} });
  const spread = (median) => ({ median, low: median * 0.9, high: median * 1.1 });
  return {
    study: {
      plumb: 2,
      study: "model",
      about: "The least model",
      configuration: { tolerance: "1e-4", dt: "1/60" },
      environment: { processor: "one" },
      results,
      findings: { promises: [] },
      timings: {
        results: {},
        cases: [
          {
            case: "heap/still",
            full: 2e-3,
            drops: drops.map(({ setting, ratio }) => ({ setting, ratio })),
            least: {
              line: "impulse:rotation=off,solver=article",
              error: 1e-5,
              change: 2e-6,
              cost: spread(1e-3),
              cheaper: spread(2.5),
              auto_cheaper: spread(1),
              dropped: [{ feature: "rotation", without: "any turning" }],
            },
          },
          { case: "heap/wild", full: null, drops: [], least: null },
        ],
      },
    },
  };
}

const pages = { "the sample": await write(sample()) };
if (process.env.PLUMB_MODEL_STUDY) pages["the real study"] = process.env.PLUMB_MODEL_STUDY;

for (const [name, file] of Object.entries(pages)) looks_right(name, file, { large: name === "the real study" });

test("the head has the result, and the table says where impulse:auto is not as accurate", async () => {
  const { page } = await open(pages["the sample"]);
  assert.match(await page.locator("h1").innerText(), /^A smaller model, as good as the full one, is 2\.5 times cheaper in 1 case; in 1 case the search ran out of time; impulse:auto is as accurate as the full model in 1 of 2 cases\.$/);
  assert.match(await page.locator("#overview").innerText(), /yes[\s\S]*no/i);
  await page.close();
});

test("the least model has the features it leaves out, and its command line", async () => {
  const { page } = await open(pages["the sample"]);
  const said = await text_in(page.locator("article").first());
  assert.match(said, /rotation: without any turning/);
  assert.match(said, /\.\/plumb run heap:still --engine impulse:rotation=off,solver=article/);
  assert.match(said, /rotation=off: no body turns/);
  await page.close();
});

test("each feature has its bar and its mark, as far as it ran", async () => {
  const { page } = await open(pages["the sample"]);
  await draw_all(page);
  const article = page.locator("article").first();
  assert.equal(await article.locator("g.cost rect").count(), 3);
  assert.equal(await article.locator("g.change circle").count(), 3);
  await article.locator("details").evaluate((element) => (element.open = true));
  const said = await text_in(article.locator("details"));
  assert.match(said, /holds no joints/);
  assert.match(said, /<b>sub-steps<\/b>/);
  await page.close();
});

test("without a truth models are compared with the full model, and unfinished jobs are listed", async () => {
  const { page } = await open(pages["the sample"]);
  const said = await text_in(page.locator("article").nth(1));
  assert.match(said, /There is no truth for this case: compared with the full model over the first 1\.5/);
  assert.match(said, /No least model was found/);
  assert.match(await page.locator("#endings").innerText(), /crashed.*signal 11/s);
  await page.close();
});
