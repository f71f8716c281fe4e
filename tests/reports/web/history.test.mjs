import assert from "node:assert/strict";
import { after, test } from "node:test";
import { close, draw_all, open, write } from "./browser.mjs";
import { sample } from "./sample.mjs";
import { looks_right } from "./views.mjs";

after(close);

const many = 20;
const subject = { scenario: "<b>fall</b>", variant: "height 5", dt: 1 / 60 };
const range = Array.from({ length: many }, (_, i) => i);

/** Twenty snapshots: a number and a verdict change in the tenth, the time of one of two engines in the fifteenth. */
function history() {
  const snapshots = range.map((i) => ({
    key: `id${i}`,
    ending: "done",
    reason: "",
    values: { commit: `c0ffee${String(i).padStart(2, "0")}a`, at: `2026-01-${String(i + 1).padStart(2, "0")}T00:00:00Z`, verdicts: { right: 2 } },
  }));
  const line = (engine, metric, unit, values, machine, changes) => ({
    ...{ ...subject, engine, metric, unit, machine, changes, values },
    ...{ snapshots: range, low: values.map((value) => value * (machine ? 0.98 : 1)), high: values.map((value) => value * (machine ? 1.03 : 1)) },
  });
  const noise = (i) => 0.01 * Math.sin(37 * i);
  return {
    study: {
      plumb: 2,
      study: "history",
      about: "What reports said from commit to commit",
      configuration: { level: 0.01 },
      environment: { processor: "one" },
      results: snapshots,
      findings: {
        unchanged: 12,
        verdicts: [{ ...subject, engine: "impulse", snapshot: 10, before: "right", after: "wrong" }],
        trends: [line("impulse", "energy_rise", "J", range.map((i) => (i < 10 ? 1 : 2)), "", [{ at: 10, before: 1, after: 2, p: 0 }])],
      },
      timings: {
        results: {},
        trends: [
          line("impulse", "step_us", "us", range.map((i) => (i < 15 ? 0.7 : 0.8) + noise(i)), "one", [{ at: 15, before: 0.7, after: 0.8, p: 0.002 }]),
          line("box2d", "step_us", "us", range.map((i) => 0.9 + noise(i)), "one", []),
          line("box2d", "step_us", "us", range.map((i) => 0.4 + noise(i)), "another", []),
        ],
      },
    },
  };
}

const alone = await write(history());
const in_report = await write({ ...sample(), studies: [history().study] });

const files = { "a page of its own": alone, "part of a report": in_report };
if (process.env.PLUMB_HISTORY) files["the real history"] = process.env.PLUMB_HISTORY;

const has_charts = async (page) => assert.ok((await page.locator(".canvas:has(svg)").count()) > 0);
for (const [name, file] of Object.entries(files)) looks_right(`the history as ${name}`, file, { large: true, also: has_charts });

test("changes are listed, the newest snapshot first, and the largest change of a snapshot first", async () => {
  const { page } = await open(alone);
  const rows = await page.locator("#changes tbody tr").allInnerTexts();
  assert.equal(rows.length, 3);
  assert.match(rows[0], /2026-01-16 c0ffee15[^]*time per step[^]*0\.700[^]*0\.800[^]*\+14[^]*p 0\.002/);
  assert.match(rows[1], /2026-01-11 c0ffee10[^]*verdict[^]*right[^]*wrong[^]*exact/);
  assert.match(rows[2], /2026-01-11 c0ffee10[^]*energy rise[^]*\+100[^]*exact/);
  assert.ok(rows[0].includes("<b>fall</b>"));
  assert.match(await page.locator("h1").innerText(), /^From 2026-01-01 to 2026-01-20, over 20 snapshots: 1 verdict and 2 numbers changed, none in the newest\.$/);
  await page.close();
});

test("a metric has a chart for each machine, with a line for each engine and a ring at each change", async () => {
  const { page } = await open(alone);
  await draw_all(page);
  const figures = page.locator("main figure");
  assert.equal(await figures.count(), 3);
  const labels = (locator) => locator.evaluateAll((all) => all.map((mark) => mark.getAttribute("aria-description")).sort());
  assert.deepEqual(await labels(figures.nth(0).locator("g.line")), ["impulse"]);
  assert.deepEqual(await labels(figures.nth(1).locator("g.line")), ["box2d", "impulse"]);
  assert.deepEqual(await labels(figures.nth(2).locator("g.line")), ["box2d"]);
  assert.equal(await figures.nth(0).locator("g.change circle").count(), 1);
  assert.equal(await figures.nth(1).locator("g.change circle").count(), 1);
  assert.equal(await figures.nth(2).locator("g.change circle").count(), 0);
  assert.equal(await page.locator("details figure").count(), 1);
  await page.close();
});

test("a history of nothing says so", async () => {
  const empty = history();
  empty.study.results = [];
  empty.study.findings = { unchanged: 0, verdicts: [], trends: [] };
  empty.study.timings.trends = [];
  const { page, trouble } = await open(await write(empty));
  assert.match(await page.locator("h1").innerText(), /Nothing has been recorded/);
  assert.deepEqual(trouble, []);
  await page.close();
});
