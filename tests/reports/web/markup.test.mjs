// A scene file full of markup, run through the program: what it says is text.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, test } from "node:test";
import { close, draw_all, open } from "./browser.mjs";

after(close);

const file = process.env.PLUMB_MARKUP;

test("names and texts of a scene file are text, never markup", { skip: file ? false : "PLUMB_MARKUP is not set" }, async () => {
  const scene = JSON.parse(await readFile(new URL("markup.json", import.meta.url), "utf8"));
  const { page, trouble } = await open(file);
  await draw_all(page);
  assert.equal(await page.locator("h2", { hasText: "<img" }).innerText(), scene.name);
  const said = await page.locator("main").textContent();
  for (const text of [scene.about, scene.bodies[0].name, scene.truth[0].source]) assert.ok(said.includes(text), text);
  assert.equal(await page.locator("img, main b, main style:not(svg style), svg[onload]").count(), 0);
  assert.doesNotMatch(await page.title(), /^bad$/);
  assert.deepEqual(trouble, []);
  await page.close();
});
