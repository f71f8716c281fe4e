// Opens the page in a headless Chromium, from a file, as a person would.
import { chromium } from "playwright-core";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

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

/** Puts data (an object, or text as it is) into the template, as the C++ side does; returns the file. */
export async function write(data) {
  const json = (typeof data === "string" ? data : JSON.stringify(data)).replaceAll("<", "\\u003c");
  const element = `<script type="application/json" id="plumb-data">${json}</script>`;
  const file = join(folder, `${++pages}.html`);
  await writeFile(file, (await readFile(template, "utf8")).replace("<!--plumb-data-->", () => element));
  return file;
}

/** Opens a file. `trouble` collects what must not be: errors on the console, and requests that leave the file. */
export async function open(file, { width = 1280, height = 900, colorScheme = "light", hash = "", deviceScaleFactor = 1 } = {}) {
  const page = await browser.newPage({ viewport: { width, height }, colorScheme, deviceScaleFactor, reducedMotion: "reduce" });
  const trouble = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) trouble.push(message.text());
  });
  page.on("pageerror", (error) => trouble.push(error.message));
  const address = pathToFileURL(file).href;
  page.on("request", (request) => {
    if (request.url().split("#")[0] !== address) trouble.push(`request: ${request.url().slice(0, 200)}`);
  });
  await page.goto(address + hash);
  return { page, trouble };
}

/** The replay of the n-th case, made; on its own, where it is clicked, typed at and looked at. */
export async function replay(page, n = 0) {
  const stage = page.locator(".stage").nth(n);
  await stage.scrollIntoViewIfNeeded();
  await page.waitForFunction((n) => "ready" in document.querySelectorAll(".stage")[n].dataset, n);
  return stage;
}

/** Two frames on, all that was asked for is drawn. */
export const drawn = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(done)))));

/** Charts are drawn when they come near the screen: goes through the whole page, folded parts too. */
export async function draw_all(page) {
  await page.evaluate(() => {
    for (const folded of document.querySelectorAll("details")) folded.open ||= folded.querySelector(".canvas") !== null;
  });
  const canvases = page.locator(".canvas");
  for (let i = 0; i < (await canvases.count()); ++i) {
    await canvases.nth(i).scrollIntoViewIfNeeded();
    await page.waitForFunction((n) => document.querySelectorAll(".canvas")[n].style.minHeight === "", i);
  }
}
