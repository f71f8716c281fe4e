// Prints how long pages take to open, the median of seven times: node tests/opening_time.mjs PAGE.html...
// "elapsed" is the time from the start of the navigation to the second frame of the complete page, when it is interactive;
// "page" the CPU time of the page's process until then, with "script" and "layout" (including styles) of its main thread;
// "processors" the CPU time of all of the browser's processes, which depends the least on other load.
import { close, open_blank, drawn, processors } from "./browser.mjs";
import { stat } from "node:fs/promises";

const times = 7;

async function opening(file) {
  const { page, go } = await open_blank({ fresh: true });
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  const before = await processors();
  await go(file);
  await drawn(page);
  const elapsed = await page.evaluate(() => performance.now());
  const after = await processors();
  const { metrics } = await session.send("Performance.getMetrics");
  await page.close();
  const main = Object.fromEntries(metrics.map(({ name, value }) => [name, 1000 * value]));
  const spent = (kind) => [...after].filter(([name]) => name.startsWith(kind)).reduce((sum, [name, time]) => sum + time - (before.get(name) ?? 0), 0);
  return { elapsed, processors: spent(""), page: spent("renderer"), script: main.ScriptDuration, layout: main.LayoutDuration + main.RecalcStyleDuration };
}

const median = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];

for (const file of process.argv.slice(2)) {
  const found = [];
  for (let i = 0; i < times; ++i) found.push(await opening(file));
  const { size } = await stat(file);
  const medians = Object.keys(found[0]).map((name) => `${name} ${median(found.map((one) => one[name])).toFixed(0)} ms`);
  console.log(`${file} (${(size / 1e6).toFixed(1)} MB) opens: ${medians.join(", ")}`);
}
await close();
