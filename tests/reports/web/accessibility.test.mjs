// Access by keyboard, and names for what is only seen. views.mjs runs axe-core.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { close, draw_all, open, write } from "./browser.mjs";
import { sample } from "./sample.mjs";
import { study_sample } from "./study_sample.mjs";

after(close);

const data = sample();
data.studies = [{ ...study_sample().study, command: "plumb study speed --dt 1/30" }];
const file = await write(data);

test("the keyboard reaches every link, button, field and fold, in the order of the page", async () => {
  const { page } = await open(file);
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
  const { page } = await open(file);
  await draw_all(page);
  const names = await page.locator(".canvas:has(svg)").evaluateAll((all) => all.map((chart) => [chart.getAttribute("role"), chart.getAttribute("aria-label")]));
  assert.ok(names.length > 8);
  for (const [role, name] of names) {
    assert.equal(role, "img");
    assert.ok(name.length > 20, name);
  }
  await page.close();
});
