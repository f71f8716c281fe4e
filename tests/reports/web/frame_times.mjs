// Prints how long frames of a large replay take: node tests/frame_times.mjs [ROWS [ENGINES]], a pyramid of boxes.
// "script" is the page's own work in a frame; "frame" the time from one frame to the next, including drawing; "processors"
// the CPU time of all of the browser's processes for one frame, which depends the least on other load.
import { close, open, processors, replay, write } from "./browser.mjs";
import { pack, replay_run } from "./pack.mjs";
import { sample } from "./sample.mjs";

const [rows = 100, engines = 1] = process.argv.slice(2).map(Number);
const times = Array.from({ length: 121 }, (_, i) => i / 60);
const boxes = [];
for (let row = 0; row < rows; ++row) {
  for (let i = 0; i < rows - row; ++i) boxes.push([i - (rows - row - 1) / 2, row + 0.5]);
}
const swaying = (t) => boxes.map(([x, y]) => [x + 0.004 * y * Math.sin(3 * t), y, 0.01 * Math.sin(3 * t)]);

const data = sample();
const corners = [[-0.48, -0.5], [0.48, -0.5], [0.48, 0.5], [-0.48, 0.5]];
const [page_replay] = data.replays;
page_replay.scene = pack(
  JSON.stringify({
    outlines: [{ points: corners, radius: 0 }],
    bodies: boxes.map((_, i) => ({ name: `box ${i}`, type: "dynamic", outlines: [0] })),
    joints: [],
  }),
);
const steps = { length: rows / 65536, angle: rows / 65536, impulse: 1, energy: 1 };
page_replay.runs = page_replay.runs
  .slice(0, engines)
  .map(({ engine }) => replay_run({ engine, times, states: times.map(swaying), energies: times.map(() => [0, 0, 0]), steps }));

const { page, trouble } = await open(await write(data));
const began = Date.now();
const stage = await replay(page);
console.log(`${boxes.length} boxes, ${engines} engine(s): ready in ${Date.now() - began} ms`);
await page.evaluate(() => {
  window.frames_seen = [];
  window.script = [];
  const ask = window.requestAnimationFrame.bind(window);
  let spent = 0;
  window.requestAnimationFrame = (act) =>
    ask((now) => {
      const start = performance.now();
      act(now);
      spent += performance.now() - start;
    });
  const tick = (now) => {
    window.frames_seen.push(now);
    window.script.push(spent);
    spent = 0;
    ask(tick);
  };
  ask(tick);
});
await stage.locator("canvas").focus();
await page.keyboard.press("l");
await page.keyboard.press("Space");
await page.waitForTimeout(500);
const before = await processors();
const drawn = await page.evaluate(() => window.frames_seen.length);
await page.waitForTimeout(5000);
const used = await processors();
const drawn_since = (await page.evaluate(() => window.frames_seen.length)) - drawn;
const { frames, script } = await page.evaluate(() => ({ frames: window.frames_seen, script: window.script }));
const print = (name, all) => {
  const sorted = all.slice(10).sort((a, b) => a - b);
  const at = (share) => sorted[Math.floor(share * (sorted.length - 1))].toFixed(1);
  console.log(`${name}: median ${at(0.5)} ms, 90 % within ${at(0.9)} ms, 99 % within ${at(0.99)} ms (${sorted.length} frames)`);
};
print("frame", frames.slice(1).map((time, i) => time - frames[i]));
print("script", script);
const parts = [...used].map(([name, time]) => [name.split(" ")[0], (time - (before.get(name) ?? 0)) / drawn_since]).filter(([, ms]) => ms > 0.05);
console.log(`processors: ${parts.map(([name, ms]) => `${name} ${ms.toFixed(1)} ms`).join(", ")} a frame`);
if (trouble.length) console.log(trouble);
await close();
