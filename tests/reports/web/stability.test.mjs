import assert from "node:assert/strict";
import { after, test } from "node:test";
import { close, draw_all, open, text_in, write } from "./browser.mjs";
import { looks_right } from "./views.mjs";

after(close);

const outcomes = [
  ["-", "not supported"],
  ["h", "holds"],
  ["d", "drifts"],
  ["o", "topples"],
  ["x", "diverges"],
].map(([letter, name]) => ({ letter, name, about: `what ${name} means` }));

const xs = [1, 3, 10, 30];

/** A row that holds up to `limit`, and topples beyond. */
function row(map, engine, option, y, typical, limit, theory) {
  const cells = xs.map((x) => (x <= limit ? "h" : x > 20 ? "o" : "d"));
  const supported = limit !== null;
  const bracketed = supported && limit < 30;
  return {
    key: `stability|${map}|${engine}|${y}`,
    ending: "done",
    reason: "",
    values: {
      map,
      engine,
      method: "",
      option,
      y,
      typical,
      outcomes: supported ? cells.join("") : "----",
      why: supported ? "" : "holds no <b>boxes</b>",
      since: cells.map((letter) => (letter === "h" ? null : 1.5)),
      bodies: cells.map((letter) => (letter === "h" ? "" : "box 2")),
      stands_low: supported ? (bracketed ? limit : 30) : null,
      stands_high: bracketed ? limit * 1.01 : null,
      stands_outcome: bracketed ? "drifts" : "",
      stands_time: bracketed ? 1.5 : null,
      stands_body: bracketed ? "box 2" : "",
      stands_theory: theory,
      ...(theory === null ? {} : { stands_agrees: limit === theory, stands_off: 0.004 }),
    },
  };
}

function sample() {
  const results = [];
  for (const y of [1, 4, 16]) results.push(row("tower", "impulse", "substeps", y, y === 4, 2 * y, null));
  for (const y of [1, 8]) results.push(row("tower", "box2d", "velocity", y, y === 8, 100, null));
  results.push(row("tower", "small", "", 0, true, null, null));
  for (const y of [0.1, 0.5, 0.9]) results.push(row("hill", "impulse", "", y, y === 0.5, 20 * y, 20 * y));
  // It holds beyond the law of physics, which is wrong.
  results.push(row("hill", "box2d", "", 0.5, true, 12, 10));
  results.push({ key: "stability|hill|<b>wild</b>|y=1", ending: "crashed", reason: "ended by signal 11", values: {} });
  const x = { name: "boxes", unit: "", from: 1, to: 30, logarithmic: true, whole: false, values: xs };
  const boundary = { name: "stands", failing: [], resolution: 0.01, source: "", agreement: 0, natural: false };
  const agreement = { engine: "impulse", boundary: "stands", rows: 3, agree: 3, measured: 3, worst: 0.004 };
  const map = (name, y, more) => ({ name, question: `How high is the ${name}?`, x, y, typical: 0.5, metrics: ["topples: turns by more than 11 deg"], boundaries: [boundary], agreements: [], limits: [], best: [], ...more });
  return {
    study: {
      plumb: 2,
      study: "stability",
      about: "Where each method fails",
      configuration: { cells: 4 },
      environment: { processor: "one" },
      results,
      findings: {
        sentence: "impulse is the best or among the best in 1 of 2 maps.",
        outcomes,
        maps: [
          map("tower", null, { best: ["box2d"] }),
          map("hill", { name: "friction", unit: "", from: 0.1, to: 0.9, logarithmic: false, whole: false }, {
            boundaries: [{ ...boundary, source: "Coulomb", agreement: 0.1, natural: true }],
            best: ["impulse"],
            limits: [{ engine: "<b>wild</b>", failed: "crashed, ended by signal 11" }],
            agreements: [agreement, { ...agreement, engine: "box2d", rows: 1, agree: 0, worst: 0.1 }],
          }),
        ],
      },
      timings: { results: {} },
    },
  };
}

const pages = { "the sample": await write(sample()) };
if (process.env.PLUMB_STABILITY) pages["the real study"] = process.env.PLUMB_STABILITY;

for (const [name, file] of Object.entries(pages)) {
  looks_right(name, file, { large: name === "the real study" });

  test(`${name} draws every supported cell, and a boundary for every bracket`, async () => {
    const { page } = await open(file);
    await draw_all(page);
    const [cells, boundaries, expected] = await page.evaluate(() => {
      const { study } = JSON.parse(document.getElementById("plumb-data").textContent);
      const done = study.results.filter(({ ending }) => ending === "done").map(({ values }) => values);
      const label = ({ map, engine, method }) => `${map} ${engine}:${method}`;
      const able = new Set(done.filter(({ outcomes }) => /[^-]/.test(outcomes)).map(label));
      const drawn = done.filter((values) => able.has(label(values)));
      const names = Object.fromEntries(study.findings.maps.map(({ name, boundaries }) => [name, boundaries.map((one) => one.name)]));
      const closed = (values, name) => values[`${name}_low`] !== null && values[`${name}_high`] !== null;
      return [
        document.querySelectorAll("g.cells rect").length,
        document.querySelectorAll("g.boundary rect").length,
        {
          cells: drawn.reduce((sum, { outcomes }) => sum + outcomes.length, 0),
          boundaries: drawn.reduce((sum, values) => sum + names[values.map].filter((one) => closed(values, one)).length, 0),
        },
      ];
    });
    assert.equal(cells, expected.cells);
    assert.equal(boundaries, expected.boundaries);
    assert.ok(cells > 0 && boundaries > 0);
    await page.close();
  });
}

test("the head has the result in a sentence", async () => {
  const { page } = await open(pages["the sample"]);
  const said = await page.locator("h1").innerText();
  assert.match(said, /^impulse is the best or among the best in 1 of 2 maps\.$/);
  await page.close();
});

test("outcomes differ in letter and colour, and have a legend", async () => {
  const { page } = await open(pages["the sample"]);
  await draw_all(page);
  const tower = page.locator("#tower");
  await tower.locator(".legend").scrollIntoViewIfNeeded();
  assert.deepEqual((await tower.locator(".legend li").allInnerTexts()).map((text) => text.split("\n").pop()), ["not supported", "holds", "drifts", "topples"]);
  const letters = await tower.locator("g.letters text").allTextContents();
  assert.ok(letters.includes("d") && letters.includes("o"), letters.join());
  const fills = await tower.locator("g.cells rect").evaluateAll((all) => [...new Set(all.map((rect) => getComputedStyle(rect).fill))]);
  assert.equal(fills.length, 3);
  await page.close();
});

test("the boundary by theory is a line of its own, if there is one", async () => {
  const { page } = await open(pages["the sample"]);
  await draw_all(page);
  assert.equal(await page.locator("#hill g.theory path").count(), 2, "one for each method");
  assert.equal(await page.locator("#tower g.theory path").count(), 0);
  assert.match(await text_in(page.locator("#hill figcaption").first()), /stands at friction 0\.5: 10 \(10\.1: drifts\); theory: 10/);
  await page.close();
});

test("one table has the limits of each method, with the best in bold", async () => {
  const { page } = await open(pages["the sample"]);
  const text = await page.locator("#limits table").innerText();
  assert.match(text, /impulse\s+8\s+10/);
  assert.match(text, /box2d\s+\u2265 30\s+12/);
  assert.deepEqual(await page.locator("#limits strong").allInnerTexts(), ["10", "\u2265 30"]);
  await page.close();
});

test("engines that do not support a map are named apart from those that fail in it, and unfinished jobs are listed as text", async () => {
  const { page } = await open(pages["the sample"]);
  assert.match(await text_in(page.locator("#hill .absence")), /<b>wild<\/b> has no limit here: crashed, ended by signal 11\./);
  assert.match(await text_in(page.locator("#tower .absence")), /Not supported by small\./);
  assert.match(await page.locator("#endings").innerText(), /<b>wild<\/b>.*crashed.*signal 11/s);
  await page.close();
});
