import assert from "node:assert/strict";
import { after, test } from "node:test";
import { close, draw_all, drawn, open, text_in, until, write } from "./browser.mjs";
import { study_sample } from "./study_sample.mjs";
import { looks_right } from "./views.mjs";

after(close);

const sample_page = await write(study_sample());

looks_right("the sample", sample_page, { widths: [360, 1280, 2560], accessible: true });
if (process.env.PLUMB_STUDY) looks_right("the real study", process.env.PLUMB_STUDY, { large: true });

test("the head has the result in a sentence", async () => {
  const { page } = await open(sample_page);
  const said = await page.locator("h1").innerText();
  assert.match(said, /^To 1\u202fmm, impulse is the fastest in 2 of 2 cases\. Cases in which an engine gets there: box2d \(WebAssembly\) in 2, impulse in 2 and never in 0\.$/);
  assert.match(await text_in(page.locator("article").first()), /impulse is the fastest to 1\u202fmm: 400\u202f\u00b5s for a simulated second; next is box2d \(WebAssembly\), 2\.0 times that, but the two run differently: no factor of method alone\. Never that accurate: never\./);
  await page.close();
});

test("times are told apart by how code runs, and engines that failed are named", async () => {
  const { page } = await open(sample_page);
  assert.match(await text_in(page.locator("#overall")), /factors between them are not of the methods alone/);
  assert.match(await text_in(page.locator("#overall tbody")), /box2d \(WebAssembly\)/);
  assert.match(await text_in(page.locator("#failures")), /<b>wild<\/b> failed in 1 of 1 job, first in heap\/plain: crashed: ended by signal 11/);
  await page.close();
});

test("every method has its curve in each case, and its mark over all cases", async () => {
  const { page } = await open(sample_page);
  await draw_all(page);
  const labels = (locator) => locator.evaluateAll((all) => all.map((mark) => mark.getAttribute("aria-description")).sort());
  assert.deepEqual(await labels(page.locator("article").first().locator("g.line")), ["box2d", "impulse"]);
  assert.deepEqual(await labels(page.locator("#overall g.factor")), ["box2d", "impulse"]);
  assert.match(await page.locator("#overall figcaption").innerText(), /In no case: never/);
  assert.equal(await page.locator("article").first().locator("g.front path").count(), 1);
  assert.match(await page.locator("article").nth(1).locator("svg").last().innerHTML(), /error of the reference/);
  await page.close();
});

test("bounds differ from readings, and unreached targets are left out", async () => {
  const { page } = await open(sample_page);
  const said = await text_in(page.locator("article").first().locator(".table").first());
  assert.match(said, /\u2264 300/);
  assert.match(said, /to 1\u202fcm/);
  assert.match(said, /never/);
  assert.doesNotMatch(said, /to 0\.1\u202fmm/, "a column that nobody reaches is left out");
  await page.close();
});

test("in print the table of all runs shows the lines that its buttons copy", async () => {
  const { page } = await open(sample_page);
  await page.emulateMedia({ media: "print" });
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  const cells = page.locator('td[data-label="command line"]');
  assert.ok((await cells.count()) > 0);
  for (const said of await cells.allInnerTexts()) assert.match(said, /^\.\/plumb run /);
  await page.setViewportSize({ width: 718, height: 1000 }); // the width of A4 within its margins
  const cut = await page.evaluate(() => [...document.querySelectorAll("table")].filter((table) => table.getBoundingClientRect().right > innerWidth).length);
  assert.equal(cut, 0);
  await page.close();
});

test("a click on a point copies its command line, and so does the table of all runs", async () => {
  const { page, trouble } = await open(sample_page);
  await page.evaluate(() => Object.defineProperty(navigator, "clipboard", { value: { writeText: async (text) => (window.copied = text) } }));
  await draw_all(page);
  const article = page.locator("article").nth(1);
  const chart = article.locator("figure svg");
  const mark = chart.locator('g[aria-hidden="true"] path[transform]').last();
  await mark.scrollIntoViewIfNeeded();
  await drawn(page);
  const { x, y, width, height } = await mark.boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await until(() => chart.evaluate(({ value }) => typeof value), "object");
  await page.mouse.click(x + width / 2, y + height / 2);
  await until(() => page.evaluate(() => window.copied), /^\.\/plumb run heap:plain --engine (box2d|impulse):substeps=4 --dt 1\/(30|60|120) --converged$/);
  assert.equal(await text_in(article.locator(".chosen code")), await page.evaluate(() => window.copied));
  await article.locator("summary", { hasText: "All 6 runs" }).press("Enter");
  const buttons = article.locator("details").last().getByRole("button");
  await until(() => buttons.count(), 6);
  await buttons.first().press("Enter");
  await until(() => page.evaluate(() => window.copied), /--engine box2d:substeps=4 --dt 1\/30 /);
  assert.deepEqual(trouble, []);
  await page.close();
});

test("a legend isolates a curve in all charts, adds others, and shows all again; axes follow", async () => {
  const { page } = await open(sample_page);
  await draw_all(page);
  const article = page.locator("article").first();
  const curves = () => article.locator("g.line").evaluateAll((all) => all.map((mark) => mark.getAttribute("aria-description")).sort().join());
  const ticks = () => article.locator('svg g[aria-label="y-axis tick label"]').first().textContent();
  const before = await ticks();
  const button = (name) => article.locator(".legend").getByRole("button", { name });
  assert.equal(await curves(), "box2d,impulse");
  await button("impulse").click();
  await until(curves, "impulse");
  assert.notEqual(await ticks(), before, "the axis fits what is shown");
  assert.equal(await button("box2d").getAttribute("aria-pressed"), "false");
  assert.equal(await page.locator("article").nth(1).locator(".legend").getByRole("button", { name: "box2d" }).getAttribute("aria-pressed"), "false");
  await button("box2d").click();
  await until(curves, "box2d,impulse");
  await button("box2d").click();
  await button("All").click();
  await until(curves, "box2d,impulse");
  await page.close();
});

test("unfinished jobs are listed as text", async () => {
  const { page } = await open(sample_page);
  assert.match(await page.locator("#endings").innerText(), /<b>wild<\/b>.*crashed.*signal 11/s);
  await page.close();
});

test("orders have their interval, and exactness is in words", async () => {
  const { page } = await open(sample_page);
  const said = await page.locator("#orders").innerText();
  assert.match(said, /1\.01 \u00b1 0\.02/);
  assert.match(said, /exact to round-off/);
  await page.close();
});

test("a study that does not fit is refused with the path of the problem", async () => {
  const broken = study_sample();
  broken.study.results[0].values = 3;
  const { page } = await open(await write(broken));
  assert.match(await page.locator("body").innerText(), /study\.results\[0\]\.values: expected names with values/);
  const later = study_sample();
  later.study.plumb = 3;
  const other = await open(await write(later));
  assert.match(await other.page.locator("body").innerText(), /the study is of format 3, this page reads format 2/);
  await page.close();
  await other.page.close();
});
