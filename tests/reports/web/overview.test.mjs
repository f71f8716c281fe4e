import assert from "node:assert/strict";
import { after, test } from "node:test";
import { close, open, text_in, until, write } from "./browser.mjs";
import { sample } from "./sample.mjs";
import { study_sample } from "./study_sample.mjs";

after(close);

const file = await write(sample());
const rows = (page) => page.locator(".matrix tbody tr").evaluateAll((all) => all.map((row) => [...row.children].slice(0, 2).map((cell) => cell.textContent).join(" ")));
const heads = (page) => page.locator(".matrix thead th").evaluateAll((all) => all.map((head) => head.querySelector("button").firstChild.textContent));
const hash = (page) => new URL(page.url()).hash;
const all_rows = ["free-fall height 5", "free-fall height 50", "stacking 10 boxes", "stacking tilted"];

test("the filters select engines, scenarios and verdicts", async () => {
  const { page, trouble } = await open(file);
  assert.deepEqual(await rows(page), all_rows);
  await page.getByRole("button", { name: "box2d", exact: true }).first().click();
  assert.deepEqual(await heads(page), ["scenario", "case", "box2d"]);
  assert.equal(hash(page), "#overview?engine=box2d");
  await page.getByRole("searchbox").fill("boxes");
  assert.deepEqual(await rows(page), ["stacking 10 boxes"]);
  await page.getByRole("searchbox").fill("nothing like it");
  assert.match(await page.locator("#overview").innerText(), /No case matches/);
  await page.getByRole("button", { name: "Show all" }).click();
  assert.deepEqual(await rows(page), all_rows);
  await page.getByRole("combobox", { name: "verdict" }).selectOption("something is not supported");
  assert.deepEqual(await rows(page), ["stacking tilted"]);
  assert.match(await page.getByText("of 4 cases shown").innerText(), /^1 of 4/);
  assert.deepEqual(trouble, []);
  await page.close();
});

test("engines whose code is not native are marked where times are compared", async () => {
  const { page } = await open(file);
  assert.deepEqual(await page.locator(".matrix thead .execution").allInnerTexts(), ["WebAssembly"]);
  assert.match(await text_in(page.locator("#overview figcaption").first()), /factors between them are not of the methods alone/);
  await page.close();
});

test("seven engines fit beside each other on a laptop", async () => {
  const data = sample();
  const box2d = data.report.engines.find(({ name }) => name === "box2d");
  const runs = data.report.runs.filter(({ engine }) => engine === "box2d");
  for (const name of ["box2d3", "chipmunk", "rapier", "planck", "matter"]) {
    data.report.engines.push({ ...box2d, name });
    data.report.runs.push(...runs.map((run) => ({ ...run, engine: name })));
  }
  const { page } = await open(await write(data), { width: 1280, height: 900 });
  assert.equal((await heads(page)).length, 2 + 7);
  const { whole, seen } = await page.locator(".verdicts-by-case").evaluate((table) => ({ whole: table.scrollWidth, seen: table.clientWidth }));
  assert.ok(whole <= seen, `${whole} of ${seen} px`);
  await page.close();
});

test("the chart of error against cost follows the filters", async () => {
  const { page } = await open(file, { hash: "#overview?engine=box2d" });
  await page.locator("#overview .canvas").first().scrollIntoViewIfNeeded();
  await page.waitForSelector("#overview g.marks");
  assert.equal(await page.locator("#overview g.marks path, #overview g.marks circle").count(), 2);
  await page.close();
});

test("the chart of times at equal error follows the filters of engines and scenarios", async () => {
  const data = sample();
  data.studies = [study_sample().study];
  const { page } = await open(await write(data));
  const chart = page.locator("#overview .pair > div").last();
  const marks = () => chart.locator("g.factor").evaluateAll((all) => all.map((mark) => mark.getAttribute("aria-description")).sort());
  const caption = () => chart.locator("figcaption").textContent();
  await chart.scrollIntoViewIfNeeded();
  await until(marks, ["box2d", "impulse"]);
  assert.match(await caption(), /over all cases.*In no case: never/);
  await page.getByRole("button", { name: "impulse", exact: true }).first().click();
  await chart.scrollIntoViewIfNeeded();
  await until(marks, ["impulse"]);
  assert.doesNotMatch(await caption(), /In no case/);
  await page.getByRole("searchbox").fill("heap");
  await until(caption, /over 1 case/);
  await chart.scrollIntoViewIfNeeded();
  await until(marks, ["impulse"]);
  await page.getByRole("searchbox").fill("nothing like it");
  await until(() => chart.textContent(), /No case of the speed study matches/);
  await page.close();
});

test("a column's head sorts by it, reverses the order, and restores it", async () => {
  const { page } = await open(file);
  const head = page.locator(".matrix thead").getByRole("button", { name: "impulse" });
  const state = () => page.locator(".matrix thead th").nth(2).getAttribute("aria-sort");
  await head.click();
  assert.equal(await state(), "ascending");
  const up = await rows(page);
  assert.equal(up.indexOf("stacking 10 boxes"), 2, "the largest error");
  assert.equal(up.at(-1), "stacking tilted", "cases without a number come last");
  await head.press("Enter");
  assert.equal(await state(), "descending");
  const down = await rows(page);
  assert.equal(down[0], "stacking 10 boxes");
  assert.equal(down.at(-1), "stacking tilted");
  await head.click();
  assert.equal(await state(), "none");
  assert.deepEqual(await rows(page), all_rows);
  await page.close();
});

test("cells show the chosen number, and rows are sorted by it", async () => {
  const { page } = await open(file);
  await page.getByRole("combobox", { name: "number" }).selectOption("time per step");
  await until(() => page.locator(".matrix td[data-verdict]").first().innerText(), /\u00b5s/);
  await page.getByRole("combobox", { name: "order" }).selectOption("case, descending");
  assert.equal((await rows(page))[0], "stacking tilted");
  assert.equal(hash(page), "#overview?show=time+per+step&sort=-case");
  await page.close();
});

test("an address shares the view, and back and forward go through views", async () => {
  const { page } = await open(file, { hash: "#overview?engine=impulse&sort=-scenario" });
  assert.deepEqual(await heads(page), ["scenario", "case", "impulse"]);
  assert.match((await rows(page))[0], /^stacking/);
  assert.equal(await page.getByRole("button", { name: "impulse", exact: true }).first().getAttribute("aria-pressed"), "true");
  await page.getByRole("combobox", { name: "verdict" }).selectOption("something is wrong");
  assert.deepEqual(await rows(page), ["stacking 10 boxes"]);
  await page.locator(".matrix td[data-verdict] a").click();
  assert.match(hash(page), /^#stacking--10-boxes--impulse\?engine=impulse&sort=-scenario&verdict=/);
  await page.goBack();
  await until(() => hash(page), /^#overview\?engine=impulse&sort=-scenario&verdict=/);
  await until(() => rows(page), ["stacking 10 boxes"]);
  await page.goBack();
  await until(() => rows(page), (shown) => shown.length === 4);
  await page.goForward();
  await until(() => rows(page), ["stacking 10 boxes"]);
  await page.close();
});

test("a row for each case says how far two engines are apart, and which came to rest", async () => {
  const { page, trouble } = await open(file);
  const row = (n) => page.locator(".apart tbody tr").nth(n).textContent();
  assert.match(await row(0), /free-fall: height 5.*2\.3\s%0\.040\s%.*only impulse 1\.25\ss.*0, 3\.40\.25\ss$/);
  assert.match(await page.locator("#overview .lede").first().textContent(), /within 1 % of each other in energy in 0 of 2 cases, in momentum in 2 of 2 .*only impulse in 2 \(free-fall height 5, free-fall height 50\), only box2d in 0\./);
  await page.getByRole("combobox", { name: "with" }).selectOption("truth");
  assert.match(await row(0), /50\s%0\s%.*both 1\.25\ss, 1\.5\ss/);
  assert.equal(hash(page), "#overview?b=truth");
  await page.getByRole("combobox", { name: "compare" }).selectOption("box2d");
  assert.match(await page.locator(".apart").textContent(), /^$/);
  await page.getByRole("combobox", { name: "with" }).selectOption("impulse");
  assert.match(await row(0), /only impulse 1\.25\ss.*3\.4, 0/, "turned around");
  assert.deepEqual(trouble, []);
  await page.close();
});

test("rows of differences are sorted by the chosen quantity", async () => {
  const data = sample();
  data.report.comparisons[1].key_differences.energy = { largest: 0.9, end: 0 };
  const { page } = await open(await write(data));
  const first = () => page.locator(".apart tbody th").first().textContent();
  assert.equal(await first(), "free-fall: height 5");
  await page.getByRole("combobox", { name: "largest first" }).selectOption("energy");
  assert.equal(await first(), "free-fall: height 50");
  await page.close();
});

test("the league table counts checks by the same ruler for every engine, and cases by verdict", async () => {
  const { page } = await open(file);
  const rows = () => page.locator(".league tbody tr").evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent.replace(/\s/g, " "))));
  assert.deepEqual(await rows(), [
    ["impulse", "3", "66 %", "66 %", "0 %", "0 %", "1", "2", "1", "1", "0", "0"],
    ["box2d", "2", "100 %", "100 %", "0 %", "0 %", "0", "2", "0", "0", "1", "1"],
  ]);
  await page.close();
});

test("a table shows which engine keeps which relation, if they were checked", async () => {
  const without = await open(file);
  assert.equal(await without.page.locator(".relations").count(), 0);
  await without.page.close();
  const data = sample();
  const checked = (run, name, value, status) => {
    run.invariants.push({ name, unit: "m", status, value, tolerance: 1e-3, ratio: value / 1e-3, evidence: true, time: 1, where: "ball", detail: "compared to the end" });
    run.metrics[name] = { value, unit: "1" };
  };
  const [first, second] = ["height 5", "height 50"].map((variant) => data.report.runs.filter((run) => run.variant === variant));
  checked(first.find(({ engine }) => engine === "impulse"), "relation_mirror", 1e-12, "held");
  checked(second.find(({ engine }) => engine === "impulse"), "relation_mirror", 1e-5, "held");
  checked(second.find(({ engine }) => engine === "impulse"), "relation_shift", 5e-4, "held");
  checked(first.find(({ engine }) => engine === "box2d"), "relation_mirror", 1e-12, "held");
  checked(second.find(({ engine }) => engine === "box2d"), "relation_mirror", 0.5, "broken");
  data.report.invariants.push({ name: "relation_mirror", unit: "m", definition: "the mirrored scene moves as the mirror image" });
  const { page, trouble } = await open(await write(data));
  const cells = await page.locator(".relations tbody tr").evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent.replace(/\s/g, " "))));
  assert.deepEqual(cells, [
    ["impulse", "100 % of 2", "0 % of 1"],
    ["box2d", "50 % of 2 1 broken", "\u2013"],
  ]);
  assert.match(await page.locator(".relations").textContent(), /the mirrored scene moves as the mirror image/);
  assert.match(await page.locator("#free-fall--height-50").textContent(), /compared to the end/);
  assert.deepEqual(trouble, []);
  await page.close();
});

test("verdicts of little evidence have a sign, a meaning and a filter", async () => {
  const data = sample();
  data.report.runs[0].verdict = "no evidence";
  data.report.runs[0].truth[0].evidence = false;
  data.report.runs[1].verdict = "coarse";
  const { page } = await open(await write(data));
  assert.match(await page.locator(".meanings").textContent(), /coarse.*a smaller step cures it.*no evidence.*could have failed/);
  await page.getByRole("combobox", { name: "verdict" }).selectOption("something has no evidence");
  assert.deepEqual(await rows(page), ["free-fall height 5"]);
  assert.match(await text_in(page.locator("#free-fall--height-5--impulse")), /too large for a test of y\./);
  assert.match(await page.locator("#free-fall--height-5 .grouped").first().textContent(), /not a test/);
  await page.close();
});

test("a cell links to the reason for its verdict, which is unfolded and highlighted", async () => {
  const { page } = await open(file);
  await page.locator(".matrix a", { hasText: "wrong" }).press("Enter");
  const place = page.locator("#stacking--10-boxes--impulse");
  await until(() => place.evaluate((element) => element.getBoundingClientRect().top), (top) => top >= 0 && top < 900);
  assert.match(await text_in(place), /Off by 42\s% of scale at most: box 10, x at 10\ss\. Largest error \/ tolerance 3\.23: box 10, x at 10\ss, error 0\.42\sm, tolerance 0\.13\sm\./);
  assert.ok(await place.evaluate((element) => element === document.activeElement && element.classList.contains("linked")));
  assert.equal(await page.locator("tr.linked").count(), 1);
  await page.locator(".matrix a", { hasText: "failed" }).click();
  assert.match(await text_in(page.locator(".verdicts .linked")), /diverged at t = 0\.42 s/);
  await page.close();
});

test("every verdict has its reason, and every cell links to one", async () => {
  const { page } = await open(file);
  const dead = await page.evaluate(() =>
    [...document.querySelectorAll(".matrix a")].map((a) => a.getAttribute("href").slice(1)).filter((id) => !document.getElementById(id)),
  );
  assert.deepEqual(dead, []);
  await page.close();
});

test("command lines are copied as shown, with the options of the report", async () => {
  const data = sample();
  data.report.command = ["plumb", "report", "--all", "--engine", "impulse", "--dt", "1/120"];
  const { page } = await open(await write(data));
  await page.evaluate(() => Object.defineProperty(navigator, "clipboard", { value: { writeText: async (text) => (window.copied = text) } }));
  const copied = () => page.evaluate(() => window.copied);
  await page.locator("#method .command button").first().click();
  await until(copied, "./plumb report --all --engine impulse --dt 1/120");
  await page.locator("#method summary", { hasText: "Each case by itself" }).click();
  await page.locator("#method details .command button").first().click();
  await until(copied, "./plumb run 'free-fall:height 5' --engine impulse --dt 1/120");
  await until(() => page.locator("#method details .command button").first().innerText(), "Copied");
  await page.close();
});

test("the method lists what is not supported, and why", async () => {
  const { page } = await open(file);
  await page.locator("#method summary", { hasText: "Not supported" }).click();
  await until(() => page.locator("#method").innerText(), /Checks that need something/);
  const said = await page.locator("#method").innerText();
  assert.match(said, /box2d: has one friction coefficient only\s+stacking \(tilted\)/);
  assert.match(said, /impulse does not report what the invariant push needs/);
  assert.doesNotMatch(said, /invariant bouncing needs/);
  await page.close();
});

test("changes since the baseline are shown, with a link", async () => {
  const data = sample();
  const regression = { scenario: "stacking", variant: "10 boxes", engine: "impulse", method: "", metric: "verdict", before: "right", now: "wrong", tolerance: "", why: "It was right.", change: "worse" };
  const findings = { verdict: "1 of 8 runs is not as accepted.", notes: [], runs: 8, regressions: [regression] };
  data.studies = [
    { plumb: 2, study: "baseline", about: "Against what was accepted", configuration: { baseline: "canonical.json" }, environment: {}, results: [], findings, timings: { results: {} } },
  ];
  const { page, trouble } = await open(await write(data));
  assert.match(await page.locator("#overview .since").innerText(), /1 of 8 runs is not as accepted/);
  await page.locator("#overview .since a").click();
  assert.equal(hash(page), "#study--baseline");
  const section = page.locator("#study--baseline");
  assert.match(await section.innerText(), /8 runs that are also in canonical\.json/);
  assert.match(await section.locator("tbody tr").innerText(), /stacking, 10 boxes\s+impulse\s+verdict\s+right\s+wrong/);
  assert.deepEqual(trouble, []);
  await page.close();
});

test("the overview says what is at stake in each group, and how often each engine is wrong there", async () => {
  const data = sample();
  const { report } = data;
  const names = [...new Set(report.runs.map(({ scenario }) => scenario))];
  assert.ok(names.length > 1);
  report.groups = [
    { name: "first", title: "first things", stake: "<b>All</b> falls." },
    { name: "rest", title: "the rest", stake: "Some of it." },
    { name: "empty", title: "nothing", stake: "None." },
  ];
  report.scenarios = names.map((name, index) => ({ ...report.scenarios[0], name, group: index ? "rest" : "first" }));
  const { page } = await open(await write(data));
  const said = await page.locator(".groups tbody tr").evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
  assert.deepEqual(said.map((row) => row.slice(0, 3)), [["first things", "<b>All</b> falls.", "1"], ["the rest", "Some of it.", String(names.length - 1)]]);
  for (const cell of said.flatMap((row) => row.slice(3))) assert.match(cell, /^(\d+ of \d+|\u2013)$/);
  await page.close();
});
