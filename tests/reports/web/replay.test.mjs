import assert from "node:assert/strict";
import { after, test } from "node:test";
import { close, draw_all, drawn, open, replay, write } from "./browser.mjs";
import { ball, sample } from "./sample.mjs";

after(close);

const file = await write(sample());
const impulse_off = 0.5;

const time_of = (stage) => stage.locator("input[type=range]").evaluate((slider) => Number(slider.value));
/** The button of an engine in the legend of the replay's case. */
const legend = (stage, engine) => stage.locator("xpath=ancestor::article").locator(".legend").getByRole("button", { name: engine });
const near = (value, expected, within, what = "") => assert.ok(Math.abs(value - expected) <= within, `${what} ${value}, expected ${expected}`);

/** The bounds of the drawing above the scale bar, CSS px: {left, right, top, bottom, many}. */
const extent = (stage) =>
  stage.locator("canvas").evaluate((canvas) => {
    const ratio = devicePixelRatio;
    // Chromium warns about canvases that are read often, so this reads a copy.
    const copy = new OffscreenCanvas(canvas.width, canvas.height - 40 * ratio).getContext("2d", { willReadFrequently: true });
    copy.drawImage(canvas, 0, 0);
    const { data, width } = copy.getImageData(0, 0, copy.canvas.width, copy.canvas.height);
    const found = { left: Infinity, right: -Infinity, top: Infinity, bottom: -Infinity, many: 0 };
    for (let i = 3; i < data.length; i += 4) {
      if (data[i] < 128) continue;
      const [x, y] = [((i - 3) / 4) % width, Math.floor((i - 3) / 4 / width)];
      found.left = Math.min(found.left, x / ratio);
      found.right = Math.max(found.right, (x + 1) / ratio);
      found.top = Math.min(found.top, y / ratio);
      found.bottom = Math.max(found.bottom, (y + 1) / ratio);
      ++found.many;
    }
    return found;
  });

async function scrub(page, stage, time) {
  await stage.locator("input[type=range]").evaluate((slider, time) => {
    slider.value = String(time);
    slider.dispatchEvent(new Event("input"));
  }, time);
  await drawn(page);
}

test("scrubbing moves a body to the trace's position, to half a pixel", async () => {
  const { page, trouble } = await open(file, { deviceScaleFactor: 4 });
  const stage = await replay(page, 1);
  await legend(stage, "impulse").click();
  for (const name of ["Truth", "Contacts and impulses"]) await stage.getByLabel(name).uncheck();
  for (const moment of [0, 13, 60, 117]) {
    const time = moment / 60;
    await scrub(page, stage, time);
    const [scale, origin_x, origin_y] = (await stage.locator("canvas").getAttribute("data-view")).split(" ").map(Number);
    const { left, right, top, bottom } = await extent(stage);
    near((left + right) / 2, origin_x, 0.5, `x at ${time} s:`);
    near((top + bottom) / 2, origin_y - scale * ball.y(50, impulse_off, time), 0.5, `y at ${time} s:`);
    near(right - left, 2 * ball.radius * scale + 1.75, 0.75, "its outer edges:");
  }
  assert.deepEqual(trouble, []);
  await page.close();
});

test("engines differ in shape on the canvas, not only in colour", async () => {
  const { page, trouble } = await open(file, { deviceScaleFactor: 4 });
  const stage = await replay(page, 1);
  for (const name of ["Side by side", "Contacts and impulses"]) await stage.getByLabel(name).setChecked(name === "Side by side");
  const time = 1;
  await scrub(page, stage, time);
  const canvas = stage.locator("canvas");
  const [scale, origin_x, origin_y] = (await canvas.getAttribute("data-view")).split(" ").map(Number);
  const width = await canvas.evaluate(({ clientWidth }) => clientWidth);
  /** Whether the mark in an engine's pane covers the point at (off, off) from its centre, px. */
  const reaches = (pane, y, off) =>
    canvas.evaluate((canvas, [x, y, off]) => {
      const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
      copy.drawImage(canvas, 0, 0);
      const at = (x, y) => copy.getImageData(Math.round(x * devicePixelRatio), Math.round(y * devicePixelRatio), 1, 1).data.join();
      return at(x + off, y + off) === at(x, y);
    }, [origin_x + (pane * width) / 2, origin_y - scale * y, off]);
  // With equal areas, a disc of radius 4 px ends at 2.8 px on the diagonal, a square at 3.5 px.
  for (const [off, disc, square] of [[2.2, true, true], [3.2, false, true], [4, false, false]]) {
    assert.equal(await reaches(0, ball.y(50, impulse_off, time), off), disc, `the disc of impulse, ${off} px`);
    assert.equal(await reaches(1, ball.y(50, -impulse_off, time), off), square, `the square of box2d, ${off} px`);
  }
  assert.deepEqual(trouble, []);
  await page.close();
});

test("the keyboard plays, steps, jumps, and changes the view", async () => {
  const { page, trouble } = await open(file);
  const stage = await replay(page);
  const press = async (key) => {
    await page.keyboard.press(key);
    await drawn(page);
  };
  await stage.locator("canvas").focus();
  assert.equal(await time_of(stage), 0, "nothing plays by itself");
  await press("ArrowRight");
  near(await time_of(stage), 1 / 60, 1e-6);
  await press("Shift+ArrowRight");
  near(await time_of(stage), 11 / 60, 1e-6);
  await press("ArrowLeft");
  near(await time_of(stage), 10 / 60, 1e-6);
  await press("End");
  near(await time_of(stage), 2, 1e-6);
  await press("1");
  near(await time_of(stage), 0.25, 1e-6, "first divergence:");
  await press("2");
  near(await time_of(stage), 2, 1e-6, "largest error:");
  await press("3");
  near(await time_of(stage), 0.5, 1e-6, "worst overlap:");
  await press("Home");
  for (let slower = 0; slower < 4; ++slower) await press("[");
  await press("Space");
  await page.waitForFunction(() => Number(document.querySelector(".stage input[type=range]").value) > 0.02);
  assert.equal(await stage.getByRole("button", { name: "Pause" }).count(), 1);
  await press("Space");
  const held = await time_of(stage);
  await drawn(page);
  assert.equal(await time_of(stage), held);
  for (const [key, name] of Object.entries({ o: "Side by side", c: "Contacts and impulses", v: "Velocities", e: "Energy", l: "Loop" })) {
    const before = await stage.getByLabel(name).isChecked();
    await press(key);
    assert.equal(await stage.getByLabel(name).isChecked(), !before, name);
  }
  const view = () => stage.locator("canvas").getAttribute("data-view");
  const whole = await view();
  for (const key of ["+", "d", "w"]) {
    const before = await view();
    await press(key);
    assert.notEqual(await view(), before, key);
  }
  await press("0");
  assert.equal(await view(), whole);
  assert.deepEqual(trouble, []);
  await page.close();
});

test("a jump goes to the worst moment of the shown runs, and is disabled if there is none", async () => {
  const { page } = await open(file);
  const stage = await replay(page);
  const overlap = stage.getByRole("button", { name: "Worst overlap" });
  assert.match(await overlap.innerText(), /0\.5\ss \(0\.010\sm, impulse\)/);
  await legend(stage, "box2d").click();
  assert.match(await overlap.innerText(), /none/);
  assert.ok(await overlap.isDisabled());
  await stage.getByRole("button", { name: "Largest error" }).click();
  near(await time_of(stage), 2, 1e-6);
  await page.close();
});

test("the engines that a legend chooses are those of the replay and of its energy bars, which count from the same zero as the chart", async () => {
  const { page, trouble } = await open(file);
  const stage = await replay(page);
  const shown = () => stage.locator(".bar:visible > span:first-child").allInnerTexts();
  assert.deepEqual(await shown(), ["impulse", "box2d", "truth"]);
  await legend(stage, "box2d").click();
  assert.deepEqual(await shown(), ["box2d", "truth"]);
  await stage.getByLabel("Truth").uncheck();
  assert.deepEqual(await shown(), ["box2d"]);
  assert.match(await stage.locator(".bar:visible .sum").innerText(), /^50\.\d\sJ$/, "m g h at 5 m, not from the lowest point");
  assert.deepEqual(trouble, []);
  await page.close();
});

test("contacts are shown while they last, with an arrow for the impulse", async () => {
  const { page } = await open(file);
  const stage = await replay(page, 1);
  await stage.getByLabel("Side by side").setChecked(false);
  const width = async (time) => {
    await scrub(page, stage, time);
    const { left, right } = await extent(stage);
    return right - left;
  };
  const alone = await width(29 / 60);
  assert.ok((await width(31 / 60)) > alone + 30, "two thirds of the arrow's 60 px lie outside the ball");
  near(await width(33 / 60), alone, 2);
  await page.close();
});

test("charts and replay share one time", async () => {
  const { page, trouble } = await open(file);
  const stage = await replay(page);
  const article = page.locator("article").first();
  await draw_all(page);
  await scrub(page, stage, 1);
  const places = () => article.locator(".playhead").evaluateAll((lines) => lines.map((line) => Number(line.getAttribute("x1"))));
  const at_one = await places();
  assert.ok(at_one.length >= 3, "energy, pose difference, momentum");
  const chart = article.locator(".charts svg:has(.playhead)").first();
  await chart.scrollIntoViewIfNeeded();
  await drawn(page);
  const box = await chart.boundingBox();
  await page.mouse.click(box.x + at_one[0] + 40, box.y + box.height / 2);
  await drawn(page);
  const time = await time_of(stage);
  assert.ok(time > 1 && time < 2, `${time} s`);
  const moved = await places();
  moved.forEach((x, i) => near(x - at_one[i], 40, 1.5, "all lines move by the same distance:"));
  assert.deepEqual(trouble, []);
  await page.close();
});

test("a damaged replay says so, and the rest of the page works", async () => {
  const data = sample();
  const [first, second] = data.replays;
  first.runs[0].poses = "AAAA" + first.runs[0].poses.slice(4);
  second.runs[1].poses = second.runs[0].touches;
  const { page, trouble } = await open(await write(data));
  assert.match(await (await replay(page, 0)).innerText(), /This replay cannot be shown/);
  assert.match(await (await replay(page, 1)).innerText(), /This replay cannot be shown: a packed column ends too early/);
  assert.ok((await page.locator("article").first().locator("figure").count()) > 3);
  assert.deepEqual(trouble, []);
  await page.close();
});

if (process.env.PLUMB_REPORT) {
  test("every replay of the real report can be opened and played to its end", async () => {
    const { page, trouble } = await open(process.env.PLUMB_REPORT);
    const many = await page.locator(".stage").count();
    assert.ok(many > 0);
    for (let n = 0; n < many; ++n) {
      const stage = await replay(page, n);
      assert.equal(await stage.locator("[role=alert]").count(), 0, await stage.innerText());
      await stage.locator("canvas").focus();
      await page.keyboard.press("End");
      await drawn(page);
      assert.ok((await extent(stage)).many > 100);
    }
    assert.deepEqual(trouble, []);
    await page.close();
  });
}
