import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, test } from "node:test";
import { close, draw_all, open, open_blank, until, write } from "./browser.mjs";
import { pack } from "./pack.mjs";
import { long_sample, sample } from "./sample.mjs";
import { study_sample } from "./study_sample.mjs";
import { looks_right } from "./views.mjs";

after(close);

const sample_page = await write(sample());

const studied = sample();
studied.studies = [{ ...study_sample().study, command: "plumb study speed --dt 1/30" }];
const screens = { widths: [360, 1280, 2560], accessible: true };
looks_right("the sample with a study", await write(studied), screens);
looks_right("a damaged report", await write("{"), { ...screens, large: true });
if (process.env.PLUMB_REPORT) looks_right("the real report", process.env.PLUMB_REPORT, { ...screens, large: true });

test("every engine has its line in each chart, and every run its mark against cost", async () => {
  const { page } = await open(sample_page);
  await draw_all(page);
  const first = page.locator("article").first();
  const labels = (locator) => locator.evaluateAll((all) => all.map((mark) => mark.getAttribute("aria-description")).sort());
  const figures = first.locator(".charts figure");
  assert.deepEqual(await labels(figures.nth(0).locator("g.line")), ["box2d", "impulse", "truth"]);
  assert.deepEqual(await labels(figures.nth(1).locator("g.line")), ["box2d", "impulse", "truth"]);
  assert.deepEqual(await labels(figures.nth(2).locator("g.line")), ["box2d", "impulse", "truth"]);
  assert.deepEqual(await labels(figures.nth(3).locator("g.line")), ["box2d", "impulse"]);
  const line = await figures.nth(0).locator("g.line path").first().getAttribute("d");
  assert.equal(line.split("L").length, 121);
  assert.equal(await page.locator("#overview g.marks path, #overview g.marks circle").count(), 4);
  await page.close();
});

test("the tip at the pointer shows the value of every engine at that time", async () => {
  const { page } = await open(sample_page);
  const chart = page.locator("article .charts svg").first();
  await page.locator(".charts").first().scrollIntoViewIfNeeded();
  await chart.hover();
  for (const name of ["impulse: ", "box2d: ", "truth: "]) await until(() => chart.locator("[aria-label=tip]").textContent(), new RegExp(name));
  await page.close();
});

test("the head has the result, and a case without a result has its reason", async () => {
  const { page } = await open(sample_page);
  assert.equal(
    await page.locator("h1").innerText(),
    "box2d is the closest to the truth: within 1 % of scale in 100\u202f% of its checks, wrong in 1 of 3 cases. impulse is within it in 66\u202f%, wrong in 1.",
  );
  const matrix = await page.locator(".matrix").innerText();
  assert.match(matrix, /diverged at t = 0\.42 s/);
  assert.match(matrix, /has one friction coefficient only/);
  await page.close();
});

test("the head says so if nothing is wrong", async () => {
  const data = sample();
  const run = data.report.runs.find(({ scenario, engine }) => scenario === "stacking" && engine === "impulse");
  Object.assign(run, { verdict: "right", truth: [] });
  for (const one of data.report.runs) if (one.verdict === "failed") one.verdict = "right";
  const { page } = await open(await write(data));
  assert.equal(await page.locator("h1").innerText(), "impulse is within 1 % of scale in 100\u202f% of its checks, wrong in none of 4 cases. box2d is within it in 100\u202f%, wrong in 0.");
  await page.close();
});

test("the speed of the fastest body is charted in each case, with who is at rest and when", async () => {
  const { page } = await open(sample_page);
  const rest = page.locator("article").first().locator("figure", { hasText: "Speed of the fastest body" });
  await rest.scrollIntoViewIfNeeded();
  await until(() => rest.locator("g.line").count(), 3);
  assert.match(await rest.locator("figcaption").textContent(), /At rest: impulse since 1\.25\ss, box2d never and the truth since 1\.5\ss\./);
  assert.match(await rest.locator("svg").first().textContent(), /at rest below/);
  assert.equal(await page.locator("details .charts").count(), 0, "open, not folded");
  await page.close();
});

test("an address opens at its element", async () => {
  for (const hash of ["#stacking--10-boxes", "#stacking--10-boxes--box2d", "#method"]) {
    const { page } = await open(sample_page, { hash });
    await until(() => page.evaluate((id) => document.getElementById(id).getBoundingClientRect().top, hash.slice(1)), (top) => top >= 0 && top < 900);
    await page.close();
  }
});

test("a folded part is created when it is opened, for print, and for a link into it", async () => {
  const data = sample();
  data.studies = [{ ...study_sample().study, command: "plumb study speed --dt 1/30" }];
  const file = await write(data);
  // A browser that is never idle, so that nothing is created ahead of time.
  const open_busy = async (hash) => {
    const { page, go } = await open_blank({ fresh: true });
    await page.addInitScript(() => (window.requestIdleCallback = () => 0));
    await go(file, hash);
    return page;
  };
  const page = await open_busy("");
  const numbers = page.locator("article details", { hasText: "All numbers" }).first();
  assert.equal(await numbers.locator("table").count(), 0);
  await numbers.locator("summary").press("Enter");
  await until(() => numbers.locator("table").count(), 2);
  const orders = page.locator("#study--speed--orders");
  assert.equal(await orders.count(), 0);
  await page.evaluate(() => (location.hash = "#study--speed--orders"));
  await orders.waitFor();
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  assert.equal(await page.locator("details:not([open]):not(.keys)").count(), 0);
  assert.equal(await page.locator("details:not(:has(> :nth-child(2)))").count(), 0);
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  assert.ok((await page.locator("details:not([open])").count()) > 3);
  await page.close();
  const there = await open_busy("#study--speed--orders");
  await until(() => there.evaluate(() => document.activeElement.id), "study--speed--orders");
  assert.ok(await there.locator("#study--speed--orders").isVisible());
  await there.close();
});

test("folded parts exist, so that they can be searched, once the browser was idle", async () => {
  const { page } = await open(sample_page);
  await until(() => page.locator("article details:not([open]) table").count(), (made) => made >= 4);
  await page.close();
});

test("folded parts exist even in a browser that never has time left", async () => {
  const { page, go } = await open_blank({ fresh: true });
  await page.addInitScript(() => {
    window.requestIdleCallback = (then, { timeout }) => setTimeout(() => then({ didTimeout: true, timeRemaining: () => 0 }), timeout / 100);
  });
  await go(sample_page);
  await until(() => page.locator("article details:not([open]) table").count(), (made) => made >= 4);
  await page.close();
});

test("the invariants have a row for each run, and a broken one says where", async () => {
  const data = sample();
  const run = data.report.runs.find(({ scenario, engine }) => scenario === "stacking" && engine === "impulse");
  run.invariants = [{ name: "push", unit: "N s", status: "broken", value: 0.5, tolerance: 0.1, ratio: 5, evidence: true, time: 1.5, where: "floor - box 1" }];
  const { page, trouble } = await open(await write(data));
  const table = page.locator('[aria-label="Invariants"]');
  await until(() => table.count(), 3);
  assert.match(await table.first().textContent(), /impulse[^]*not applicable[^]*0\.25[^]*not reported/);
  assert.match(await table.last().textContent(), /5\.00[^]*of floor - box 1 at/);
  assert.match(await page.locator("#stacking--10-boxes--impulse").textContent(), /Largest error \/ tolerance 5\.00: push/);
  assert.deepEqual(trouble, []);
  await page.close();
});

test("what an engine does differently stands beside its verdicts, folded", async () => {
  const { page } = await open(sample_page);
  const verdict = page.locator("#free-fall--height-5--impulse");
  await verdict.locator("summary", { hasText: "What it does differently" }).click();
  assert.equal(await verdict.locator("details li").innerText(), "sinks <b>in</b>");
  assert.equal(await page.locator("#free-fall--height-5--box2d details").count(), 0, "it states none");
  await page.close();
});

test("names are text, never markup", async () => {
  const name = "<img src=x onerror=document.title='bad'></script><b>";
  const { page, trouble } = await open(await write(sample(name)));
  assert.equal(await page.locator("h2", { hasText: "<img" }).innerText(), name);
  assert.equal(await page.locator("img").count(), 0);
  assert.equal(await page.locator("main b").count(), 0);
  assert.notEqual(await page.title(), "bad");
  assert.deepEqual(trouble, []);
  await page.close();
});

const markup = process.env.PLUMB_MARKUP;

test("names and texts of a scene file are text, never markup", { skip: markup ? false : "PLUMB_MARKUP is not set" }, async () => {
  const scene = JSON.parse(await readFile(new URL("markup.json", import.meta.url), "utf8"));
  const { page, trouble } = await open(markup);
  await draw_all(page);
  assert.equal(await page.locator("h2", { hasText: "<img" }).innerText(), scene.name);
  const said = await page.locator("main").textContent();
  for (const text of [scene.about, scene.bodies[0].name, scene.truth[0].source]) assert.ok(said.includes(text), text);
  assert.equal(await page.locator("img, main b, main style:not(svg style), svg[onload]").count(), 0);
  assert.doesNotMatch(await page.title(), /^bad$/);
  assert.deepEqual(trouble, []);
  await page.close();
});

test("print has every chart and every table, none wider than the page", async () => {
  const { page } = await open(sample_page);
  await page.emulateMedia({ media: "print" });
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  assert.equal(await page.locator("details:not([open]):not(.keys)").count(), 0);
  assert.equal(await page.locator(".canvas:not(:has(svg))").count(), 0);
  // The width of A4 within its margins.
  await page.setViewportSize({ width: 718, height: 1000 });
  const cut = await page.evaluate(() => [...document.querySelectorAll("table")].filter((table) => table.getBoundingClientRect().right > innerWidth).map((table) => table.textContent.slice(0, 60)));
  assert.deepEqual(cut, []);
  await page.close();
});

const damages = {
  "no report at all": ["", /the page holds no report/],
  "a report that is cut off": [JSON.stringify(sample()).slice(0, 999), /the report is not JSON/],
  "a report of another format": [{ ...sample(), report: { ...sample().report, plumb: 7 } }, /of format 7, this page reads format 4/],
  "a report without its runs": [{ ...sample(), report: { ...sample().report, runs: undefined } }, /report\.runs: expected a list, found nothing/],
  "an older report, from before invariants": [damaged((page) => page.report.runs.forEach((run) => delete run.invariants)), /report\.runs\[0\]\.invariants: expected a list, found nothing/],
  "a run whose step is text": [damaged((page) => (page.report.runs[1].dt = "1/60")), /report\.runs\[1\]\.dt: expected a number, found a string/],
  "an unknown verdict": [damaged((page) => (page.report.runs[0].verdict = "fine")), /report\.runs\[0\]\.verdict: expected one of right/],
  "a replay whose run has no step": [damaged((page) => delete page.replays[0].runs[1].length), /replays\[0\]\.runs\[1\]\.length: expected a number, found nothing/],
  "a report whose packed text is damaged": [{ report: pack("{}").replace(/.{6}$/, "AAAAA="), curves: [], replays: [], studies: [] }, /report: packed data is damaged/],
};

test("damaged curves say so, and the rest of the page works", async () => {
  const data = damaged((page) => page.series[2].energy.pop());
  const { page, trouble } = await open(await write(data));
  assert.match(await page.locator("article [role=alert]").textContent(), /The charts of this case cannot be shown: series\[2\]\.energy: 120 values for 121 times/);
  assert.ok((await page.locator("article figure").count()) > 3);
  assert.deepEqual(trouble, []);
  await page.close();
});

function damaged(damage) {
  const page = sample();
  damage(page);
  return page;
}

for (const [name, [data, words]] of Object.entries(damages)) {
  test(`${name} is reported, and nothing else is shown`, async () => {
    const { page, trouble } = await open(await write(data));
    assert.match(await page.locator("#page").innerText(), words);
    assert.equal(await page.locator("section").count(), 0);
    assert.deepEqual(trouble, []);
    await page.close();
  });
}

test("short forms of studies are part of the report: ids are unique, and every link has a target", async () => {
  const data = sample("fall");
  data.studies = [{ ...study_sample().study, command: "plumb study speed --dt 1/30" }];
  const { page, trouble } = await open(await write(data));
  await draw_all(page);
  const section = page.locator("#study--speed");
  assert.match(await section.innerText(), /To 1\u202fmm, impulse is the fastest/);
  assert.match(await section.innerText(), /plumb study speed --dt 1\/30/);
  assert.ok((await section.locator("g.line").count()) > 0);
  const [twice, dead] = await page.evaluate(() => {
    const ids = [...document.querySelectorAll("[id]")].map(({ id }) => id);
    const links = [...document.querySelectorAll('a[href^="#"]')].map((a) => decodeURIComponent(a.getAttribute("href").slice(1)));
    return [ids.filter((id, i) => ids.indexOf(id) !== i), links.filter((id) => !ids.map(decodeURIComponent).includes(id))];
  });
  assert.deepEqual(twice, []);
  assert.deepEqual(dead, []);
  assert.deepEqual(trouble, []);
  await page.close();
});

test("a long report makes its cases when they are opened, by a link, the search field or a click", async () => {
  const { page, trouble } = await open(await write(long_sample()));
  assert.equal(await page.locator("article.case").count(), 0, "no case is made before it is wanted");
  assert.equal(await page.locator("nav a").count() < 8, true);
  const field = page.locator("nav input[type=search]");
  await field.focus();
  assert.match(await page.locator(".results").innerText(), /even[\s\S]*odd/);
  const name = (await page.locator("section.chapter").nth(5).getAttribute("id")) ?? "";
  await field.fill(name);
  await field.press("Enter");
  await until(() => page.locator(`section[id="${name}"] > details`).evaluate(({ open }) => open), true);
  assert.ok((await page.locator("article.case").count()) > 0);
  const cell = page.locator("table.matrix td a[href*='--']").last();
  const href = await cell.getAttribute("href");
  await cell.evaluate((link) => link.click());
  await until(() => page.evaluate((id) => !!document.getElementById(id), href.slice(1)), true);
  assert.equal(await page.evaluate((id) => document.getElementById(id).closest("details").open, href.slice(1)), true);
  assert.deepEqual(trouble, []);
  await page.close();
});
