import assert from "node:assert/strict";
import { after, test } from "node:test";
import { close, draw_all, open, write } from "./browser.mjs";
import { looks_right } from "./views.mjs";

after(close);

const statistic = (name, more) => ({ name, unit: "", low: 0, high: 0, resolution: 0.1, source: "0: symmetry", idealisation: false, ...more });
const finding = (engine, name, mean, half, verdict, more) => ({
  engine, control: false, statistic: name, idealisation: false, draws: 40, mean, low: mean - half, high: mean + half, error: half / 3, verdict, off: 0, needed: 0, ...more,
});

function sample() {
  const statistics = [statistic("to the right"), statistic("load", { unit: "kg", low: 1, high: 2 }), statistic("binomial", { idealisation: true })];
  const results = [
    finding("impulse", "to the right", 0.01, 0.05, "agrees"),
    finding("<b>wild</b>", "to the right", 0.4, 0.05, "differs", { off: 24 }),
    finding("impulse", "load", 1.5, 0.3, "undecided", { needed: 120 }),
    finding("<b>wild</b>", "load", 1.5, 0, "agrees"),
    finding("impulse", "binomial", 0.6, 0.1, "differs", { off: 18, idealisation: true }),
  ];
  const ensemble = { name: "fall-board", question: "Do discs fall left as often as right?", dt: 1 / 120, runs: 4, large: 80, control: "leaning", control_about: "leans", statistics, results };
  return {
    study: {
      plumb: 2,
      study: "statistics",
      about: "Ensembles with intervals",
      configuration: { large: false },
      environment: { processor: "one" },
      results: [],
      findings: {
        miss: 0.01,
        looks: 5,
        summary: [{ engine: "impulse", agrees: 1, differs: 0, undecided: 1, unjudged: 0 }, { engine: "<b>wild</b>", agrees: 1, differs: 1, undecided: 0, unjudged: 0 }],
        ensembles: [{ ...ensemble, unjudged: [{ engine: "small", status: "not supported", why: "holds no discs" }] }],
      },
      timings: { results: {}, costs: [{ ensemble: "fall-board", engine: "impulse", execution: "native", seconds: 0.25 }] },
    },
  };
}

const pages = { "the sample": await write(sample()) };
if (process.env.PLUMB_STATISTICS) pages["the real study"] = process.env.PLUMB_STATISTICS;

async function has_every_mean(page) {
  const [means, results] = await page.evaluate(() => [
    document.querySelectorAll("g.means circle").length,
    JSON.parse(document.getElementById("plumb-data").textContent).study.findings.ensembles.flatMap((one) => one.results).length,
  ]);
  assert.equal(means, results, "a mean of each engine in each statistic");
}

for (const [name, file] of Object.entries(pages)) looks_right(name, file, { large: name === "the real study", also: has_every_mean });

test("the head has the result in a sentence, and the table the worst verdict of each ensemble", async () => {
  const { page } = await open(pages["the sample"]);
  assert.equal(await page.locator("h1").innerText(), "impulse agrees with mechanics in 1 of 2 statistics, <b>wild</b> in 1 of 2.");
  const cells = await page.locator("#verdicts tbody td").allInnerTexts();
  assert.deepEqual(cells, ["undecided", "differs"], "an idealisation does not count");
  await page.close();
});

test("numbers say by how much a mean differs and how many draws are missing", async () => {
  const { page } = await open(pages["the sample"]);
  await page.locator("summary", { hasText: "Numbers" }).click();
  const said = await page.locator("#fall-board").innerText();
  assert.match(said, /differs by 24 standard errors/);
  assert.match(said, /undecided, about 120 draws needed/);
  assert.match(said, /small: not supported, holds no discs\./);
  await page.close();
});
