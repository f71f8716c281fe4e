import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { after, test } from "node:test";
import { close, draw_all, open, write } from "./browser.mjs";
import { long_sample, sample } from "./sample.mjs";
import { study_sample } from "./study_sample.mjs";

after(close);

const program = fileURLToPath(new URL("../dist/pictures.cjs", import.meta.url));
const name = "<img src=x onerror=alert(1)>";
const data = sample(name);
data.studies = [{ ...study_sample().study, command: "plumb study speed --dt 1/30" }];
const file = await write(data);
const folder = join(dirname(file), "pictures");
const output = execFileSync(process.execPath, [program, file, folder], { encoding: "utf8" });
const names = readdirSync(folder);
const text_of = (part) => readFileSync(join(folder, names.find((one) => one.includes(part))), "utf8");

test("every chart of the page becomes a picture, with the same marks", async () => {
  const { page } = await open(file);
  await draw_all(page);
  assert.equal(names.length, await page.locator("figure:has(.canvas svg)").count());
  assert.match(output, new RegExp(`^${names.length} pictures in `));
  const cost = text_of("error-against-cost");
  assert.equal(cost.match(/aria-description="(impulse|box2d)"/g).length, 2);
  assert.equal((await page.locator("#overview g.marks").count()), 2);
  await page.close();
});

test("pictures are well-formed, have a title, and stand alone", async () => {
  const { page } = await open(file);
  for (const one of names) {
    const text = readFileSync(join(folder, one), "utf8");
    const [root, title, scripts] = await page.evaluate((svg) => {
      const parsed = new DOMParser().parseFromString(svg, "image/svg+xml");
      return [parsed.documentElement.tagName, parsed.querySelector("title")?.textContent, parsed.querySelectorAll("script, image, img, foreignObject").length];
    }, text);
    assert.equal(root, "svg", one);
    assert.ok(title.length > 5);
    assert.equal(scripts, 0);
    assert.doesNotMatch(text, /var\(|undefined/, `${one}: printing programs know no variables`);
    assert.match(text, /prefers-color-scheme: ?dark/);
  }
  await page.close();
});

test("names are text in pictures, and safe in file names", () => {
  const text = text_of("energy-of-the-whole-scene");
  assert.ok(text.includes("&#60;img src=x onerror=alert(1)&#62;"));
  assert.ok(!text.includes(">All<"), "a button is no curve");
  for (const one of names) assert.match(one, /^[a-z0-9.=+-]+\.svg$/);
});

test("pictures of a long report, whose cases are folded, have the name of their case", async () => {
  const long = await write(long_sample());
  const there = join(folder, "long");
  execFileSync(process.execPath, [program, long, there]);
  const energies = readdirSync(there).filter((one) => one.includes("energy-of-the-whole-scene"));
  assert.ok(energies.length > 20, energies.join(" "));
  for (const one of energies) assert.match(one, /^[\w-]+--[\w.=+-]+--energy/);
});

test("a page without charts, or no page, is an error", async () => {
  const run = (page) => spawnSync(process.execPath, [program, page, folder], { encoding: "utf8" });
  const none = run(await write("{"));
  assert.equal(none.status, 1);
  assert.match(none.stderr, /has no charts/);
  assert.equal(run(join(folder, "nothing.html")).status, 1);
});
