// Opens the page from a file in a headless Chromium.
import { chromium } from "playwright-core";
import assert from "node:assert/strict";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout as delay } from "node:timers/promises";
import { pathToFileURL } from "node:url";
import { inspect, isDeepStrictEqual } from "node:util";
import { pack } from "./pack.mjs";

const patience = 300_000; // ms, to end tests that would wait forever: a busy machine takes a minute for what takes a second
const template = new URL("../dist/page.html", import.meta.url);
const folder = await mkdtemp(join(tmpdir(), "plumb-page-"));
const browser = await chromium.launch({
  timeout: patience,
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"],
});

export async function close() {
  await browser.close();
  await rm(folder, { recursive: true });
}

let pages = 0;

/** A report's data as the C++ side packs it: the report, and the series by case. */
function packed({ report, series, ...others }) {
  const of = (item) => JSON.stringify([item.scenario, item.variant]);
  const curves = [...new Set(series.map(of))].map((key) => {
    const [scenario, variant] = JSON.parse(key);
    return { scenario, variant, series: pack(JSON.stringify(series.filter((item) => of(item) === key))) };
  });
  return { report: pack(JSON.stringify(report)), curves, ...others };
}

/** Writes data (an object, or text) into the template, as the C++ side does; returns the file. */
export async function write(data) {
  const json = (typeof data === "string" ? data : JSON.stringify(data.series ? packed(data) : data)).replaceAll("<", "\\u003c");
  const element = `<script type="application/json" id="plumb-data">${json}</script>`;
  const file = join(folder, `${++pages}.html`);
  await writeFile(file, (await readFile(template, "utf8")).replace("<!--plumb-data-->", () => element));
  return file;
}

const watched = ["console", "pageerror", "request"];
const idle = new Map(); // pages that tests have closed, by resolution

/** A page that no file has been opened in, or, five times as quick, one that is blank again. */
async function page_at(deviceScaleFactor, fresh) {
  const pages = idle.get(deviceScaleFactor) ?? [];
  idle.set(deviceScaleFactor, pages);
  if (!fresh && pages.length) return pages.pop();
  const page = await browser.newPage({ deviceScaleFactor });
  page.setDefaultTimeout(patience);
  if (fresh) return page;
  page.close = async () => {
    for (const event of watched) page.removeAllListeners(event);
    await page.mouse.move(0, 0);
    await page.goto("about:blank");
    pages.push(page);
  };
  return page;
}

/**
 * A blank page. `trouble` collects errors and warnings on the console, and requests other than for the page's file.
 * `fresh`: nothing has been opened in it before, nor will be after it.
 */
export async function open_blank({ width = 1280, height = 900, colorScheme = "light", deviceScaleFactor = 1, fresh = false } = {}) {
  const page = await page_at(deviceScaleFactor, fresh);
  await page.setViewportSize({ width, height });
  await page.emulateMedia({ media: null, colorScheme, reducedMotion: "reduce" });
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
    for (const [one, open] of before) one.open = open || one.querySelector(".canvas, .stage") !== null;
  });
}

/** Scrolls through the whole page, because charts and replays are drawn when they come near the screen. */
export async function draw_all(page) {
  await make_all(page);
  // In the page, as a message for each of its hundreds of charts takes longer than to draw it. It counts frames, not
  // seconds: a slow machine draws fewer.
  const missing = await page.evaluate(async () => {
    const made = { canvas: (canvas) => canvas.style.minHeight === "", stage: (stage) => "ready" in stage.dataset };
    for (const [kind, done] of Object.entries(made)) {
      for (const one of document.getElementsByClassName(kind)) {
        for (let frames = 0; !done(one); ++frames) {
          if (frames === 2000) return `${kind}: ${one.parentElement.textContent.slice(0, 200)}`;
          one.scrollIntoView({ block: "center", behavior: "instant" });
          await new Promise(requestAnimationFrame);
        }
      }
    }
    return "";
  });
  assert.equal(missing, "", "was not drawn within 2000 frames");
}
