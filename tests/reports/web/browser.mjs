// Opens the page from a file in a headless Chromium.
import { chromium } from "playwright-core";
import assert from "node:assert/strict";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout as delay } from "node:timers/promises";
import { pathToFileURL } from "node:url";
import { inspect, isDeepStrictEqual } from "node:util";

const patience = 20_000; // ms
const template = new URL("../dist/page.html", import.meta.url);
const folder = await mkdtemp(join(tmpdir(), "plumb-page-"));
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"],
});

export async function close() {
  await browser.close();
  await rm(folder, { recursive: true });
}

let pages = 0;

/** Writes data (an object, or text) into the template, as the C++ side does; returns the file. */
export async function write(data) {
  const json = (typeof data === "string" ? data : JSON.stringify(data)).replaceAll("<", "\\u003c");
  const element = `<script type="application/json" id="plumb-data">${json}</script>`;
  const file = join(folder, `${++pages}.html`);
  await writeFile(file, (await readFile(template, "utf8")).replace("<!--plumb-data-->", () => element));
  return file;
}

/** A blank page. `trouble` collects errors and warnings on the console, and requests other than for the page's file. */
export async function open_blank({ width = 1280, height = 900, colorScheme = "light", deviceScaleFactor = 1 } = {}) {
  const page = await browser.newPage({ viewport: { width, height }, colorScheme, deviceScaleFactor, reducedMotion: "reduce" });
  const trouble = [];
  let address = "about:blank";
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) trouble.push(message.text());
  });
  page.on("pageerror", (error) => trouble.push(error.message));
  page.on("request", (request) => {
    if (request.url().split("#")[0] !== address) trouble.push(`request: ${request.url().slice(0, 200)}`);
  });
  const go = async (file, hash = "") => {
    address = pathToFileURL(file).href;
    await page.goto(address + hash);
  };
  return { page, trouble, go };
}

/** A page with a file open. */
export async function open(file, { hash = "", ...look } = {}) {
  const { page, trouble, go } = await open_blank(look);
  await go(file, hash);
  return { page, trouble };
}

const system = await browser.newBrowserCDPSession();

/** CPU time of each of the browser's processes (ms), by type and id. */
export async function processors() {
  const { processInfo } = await system.send("SystemInfo.getProcessInfo");
  return new Map(processInfo.map(({ id, type, cpuTime }) => [`${type} ${id}`, 1000 * cpuTime]));
}

/** The replay of the n-th case, once it is ready. */
export async function replay(page, n = 0) {
  const stage = page.locator(".stage").nth(n);
  await stage.scrollIntoViewIfNeeded();
  await page.waitForFunction((n) => "ready" in document.querySelectorAll(".stage")[n].dataset, n);
  return stage;
}

/** Waits until all scheduled drawing is done. */
export const drawn = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(done)))));

/** The visible text; cases far from the screen have none before they are laid out. */
export async function text_in(locator) {
  await locator.scrollIntoViewIfNeeded();
  return locator.innerText();
}

/** Waits until a value equals, matches or satisfies what is expected. */
export async function until(read, expected) {
  const fits = (found) => (typeof expected === "function" ? expected(found) : expected instanceof RegExp ? expected.test(found) : isDeepStrictEqual(found, expected));
  let found = await read();
  for (const end = Date.now() + patience; !fits(found) && Date.now() < end; found = await read()) await delay(20);
  if (typeof expected === "function") assert.ok(fits(found), `${expected}: ${inspect(found)}`);
  else if (expected instanceof RegExp) assert.match(found, expected);
  else assert.deepEqual(found, expected);
}

/** Creates all folded parts; leaves those open that were, and those with charts. */
async function make_all(page) {
  await page.evaluate(async () => {
    const before = new Map();
    for (let closed; (closed = [...document.querySelectorAll("details")].filter((one) => !before.has(one))).length; ) {
      for (const one of closed) {
        before.set(one, one.open);
        one.open = true;
      }
      await new Promise(requestAnimationFrame);
    }
    for (const [one, open] of before) one.open = open || one.querySelector(".canvas") !== null;
  });
}

/** Scrolls through the whole page, because charts and replays are drawn when they come near the screen. */
export async function draw_all(page) {
  await make_all(page);
  for (const [kind, made] of [[".canvas", (canvas) => canvas.style.minHeight === ""], [".stage", (stage) => "ready" in stage.dataset]]) {
    for (const one of await page.locator(kind).elementHandles()) {
      await one.scrollIntoViewIfNeeded();
      await page.waitForFunction(made, one);
    }
  }
}
