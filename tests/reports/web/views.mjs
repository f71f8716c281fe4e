// What every page must be in every view, as tests: it fits, draws everything, makes no requests, and axe-core finds nothing.
import axe from "axe-core";
import assert from "node:assert/strict";
import { test } from "node:test";
import { draw_all, open } from "./browser.mjs";

async function violations(page, options) {
  await page.evaluate(axe.source);
  const found = await page.evaluate((options) => window.axe.run({ resultTypes: ["violations"], ...options }), options);
  return found.violations.map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(({ html, any }) => `${html.slice(0, 160)} ${any[0]?.message ?? ""}`).join("\n  ")}`);
}

async function fits(page, colorScheme) {
  const [inner, outer] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  assert.ok(inner <= outer, `${inner} px of page on ${outer} px of screen`);
  assert.equal(await page.locator(".canvas:not(:has(svg))").count(), 0);
  const background = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.equal(Number(/\d+/.exec(background)[0]) < 128, colorScheme === "dark");
}

/**
 * Tests of a page, at each width in each theme. A width changes the layout and a theme the colours, and neither the
 * content: a large page is seen once at each width and in each theme, and its contrasts once in each theme.
 */
export function looks_right(name, file, { widths = [360, 1280], large = false, accessible = false, also = async () => {} } = {}) {
  const themes = ["light", "dark"];
  const contrasts = new Set();
  for (const [n, width] of widths.entries()) {
    for (const colorScheme of large ? [themes[n % 2]] : themes) {
      const rules = { "color-contrast": { enabled: !large || !contrasts.has(colorScheme) } };
      contrasts.add(colorScheme);
      test(`${name} fits ${width} px in ${colorScheme}, draws everything, makes no requests${accessible ? ", and axe-core finds nothing" : ""}`, async () => {
        const { page, trouble } = await open(file, { width, colorScheme });
        await draw_all(page);
        await fits(page, colorScheme);
        await also(page);
        if (accessible) assert.deepEqual(await violations(page, { rules }), []);
        assert.deepEqual(trouble, []);
        await page.close();
      });
    }
  }
}
