// The checks of axe-core in both themes at three widths, and access by keyboard.
import axe from "axe-core";
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { close, draw_all, open, write } from "./browser.mjs";
import { sample } from "./sample.mjs";
import { study_sample } from "./study_sample.mjs";

after(close);

const data = sample();
data.studies = [{ ...study_sample().study, command: "plumb study speed --dt 1/30" }];
const files = { "the sample": await write(data), "a study": await write(study_sample()), "a damaged report": await write("{") };
if (process.env.PLUMB_REPORT) files["the real report"] = process.env.PLUMB_REPORT;

async function violations(page) {
  await page.evaluate(axe.source);
  const found = await page.evaluate(() => window.axe.run({ resultTypes: ["violations"] }));
  return found.violations.map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(({ html, any }) => `${html.slice(0, 160)} ${any[0]?.message ?? ""}`).join("\n  ")}`);
}

// The width changes the layout, not the content: large pages are checked once at each width.
const views = [[360, "light"], [1280, "dark"], [2560, "light"]];
for (const [name, file] of Object.entries(files)) {
  for (const [width, colorScheme] of name === "the sample" ? [...views, [360, "dark"], [1280, "light"], [2560, "dark"]] : views) {
    test(`axe-core finds nothing in ${name} at ${width} px in ${colorScheme}`, async () => {
      const { page, trouble } = await open(file, { width, colorScheme });
      await draw_all(page);
      assert.deepEqual(await violations(page), []);
      assert.deepEqual(trouble, []);
      await page.close();
    });
  }
}

test("the keyboard reaches every link, button, field and fold, in the order of the page", async () => {
  const { page } = await open(files["the sample"]);
  await draw_all(page);
  const wanted = await page.evaluate(() => {
    const all = [...document.querySelectorAll("a[href], button, input, select, summary, [tabindex='0']")].filter((element) => element.checkVisibility());
    all.forEach((element, index) => (element.dataset.stop = String(index)));
    return all.length;
  });
  const reached = [];
  for (let i = 0; i < wanted; ++i) {
    await page.keyboard.press("Tab");
    reached.push(await page.evaluate(() => Number(document.activeElement.dataset.stop)));
  }
  assert.deepEqual(reached, Array.from({ length: wanted }, (_, index) => index));
  await page.close();
});

test("every chart is an image with a name", async () => {
  const { page } = await open(files["the sample"]);
  await draw_all(page);
  const names = await page.locator(".canvas:has(svg)").evaluateAll((all) => all.map((chart) => [chart.getAttribute("role"), chart.getAttribute("aria-label")]));
  assert.ok(names.length > 8);
  for (const [role, name] of names) {
    assert.equal(role, "img");
    assert.ok(name.length > 20, name);
  }
  await page.close();
});
