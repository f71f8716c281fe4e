// Modules of the page that need no browser.
import assert from "node:assert/strict";
import { test } from "node:test";
import { build } from "esbuild";
import { fileURLToPath } from "node:url";
import { constants, deflateSync } from "node:zlib";

/** A source of the page as a module. */
async function source(name) {
  const entry = fileURLToPath(new URL(`../src/${name}`, import.meta.url));
  const bundle = await build({ entryPoints: [entry], bundle: true, write: false, format: "esm" });
  return import(`data:text/javascript;base64,${Buffer.from(bundle.outputFiles[0].text).toString("base64")}`);
}

const format = await source("format.ts");
const { unpack } = await source("packed.ts");

const plain = (text) => text.replaceAll("\u202f", " ");

test("a number has significant digits and its unit", () => {
  assert.equal(plain(format.number(3.14159, "m")), "3.14 m");
  assert.equal(plain(format.number(-0.0421, "kg m^2/s")), "\u22120.0421 kg m\u00b2/s");
  assert.equal(plain(format.number(1.5e-7, "J")), "1.50 \u00d7 10\u207b\u2077 J");
  assert.equal(plain(format.number(0.744, "us")), "0.744 \u00b5s");
  assert.equal(format.number(9.996), "10.0");
  assert.equal(format.number(123456), "123456");
  assert.equal(format.number(0), "0");
});

test("a value that is not finite is never shown as a number", () => {
  assert.equal(format.number(null), "not finite");
  assert.equal(format.number(Infinity, "m"), "not finite");
  assert.equal(format.to_within(null, 0.1, "m"), "not finite");
});

test("a value that is compared with another shows two digits of the difference", () => {
  assert.equal(plain(format.to_within(-5.08333, 0.0833, "m")), "\u22125.083 m");
  assert.equal(plain(format.to_within(-0.00001, 0.0833, "m")), "0.000 m");
  assert.equal(plain(format.to_within(0, 0.0833, "m")), "0 m");
  assert.equal(plain(format.to_within(1234.5678, 20, "J")), "1235 J");
});

test("a time step is shown as a fraction if it is one", () => {
  assert.equal(plain(format.time_step(1 / 60)), "1/60 s");
  assert.equal(plain(format.time_step(0.003)), "0.00300 s");
});

test("error / tolerance stays short", () => {
  assert.deepEqual([0, 1e-9, 0.0421, 0.9984, 3.2308, 12345, Infinity, NaN].map(format.ratio_text), [
    "0", "< 0.001", "0.042", "1.00", "3.23", "> 1000", "\u221e", "\u2013",
  ]);
});

test("a command line is quoted for a shell", () => {
  assert.equal(format.shell(["./plumb", "run", "slope:it's 20\u00b0"]), "./plumb run 'slope:it'\\''s 20\u00b0'");
});

const { factors_over } = await source("studies/speed_model.ts");

const box2d = { label: "box2d" };
const impulse = { label: "impulse" };
/** Cases in which box2d takes 10 us to a target and impulse that many. */
const cases = (...times) =>
  times.map((time) => ({ curves: [{ engine: box2d, time_for_error: [{ value: 10 }] }, { engine: impulse, time_for_error: [time === null ? null : { value: time }] }] }));

test("a method's time over the fastest is the median over the cases that it reaches, with the middle half", () => {
  assert.deepEqual(factors_over(cases(20, null, 40, 5), 0), [
    { engine: box2d, median: 1, low: 1, high: 1.25, cases: 4, reached: 4, fastest: 3 },
    { engine: impulse, median: 2, low: 1.5, high: 3, cases: 4, reached: 3, fastest: 1 },
  ]);
});

test("a method that gets there in no case says so, and all cases count", () => {
  assert.deepEqual(factors_over(cases(null, null), 0)[1], { engine: impulse, median: null, low: null, high: null, cases: 2, reached: 0, fastest: 0 });
  assert.deepEqual(factors_over([], 0), []);
});

test("the engines that Plumb knows have colours of their own, and their methods have marks of their own", async () => {
  const { look_of } = await source("looks.ts");
  const engines = ["impulse", "box2d", "chipmunk", "box2d-v3", "rapier", "planck", "matter", "mine"];
  assert.equal(new Set(engines.map((name) => look_of(name).color)).size, engines.length);
  assert.equal(look_of("impulse").color, "var(--engine-1)");
  const methods = ["", ":solver=article", ":solver=exact", ":solver=soft-step", ":iterations=4"].map((method) => look_of(`impulse${method}`));
  assert.equal(new Set(methods.map(({ symbol, dash }) => symbol + dash)).size, methods.length);
  for (const { color } of methods) assert.match(color, /^var\(--engine-1(-deep)?\)$/);
  assert.match(look_of("box2d3-wasm").color, /^var\(--engine-4/);
  assert.match(look_of("mine:fast=on").color, new RegExp(`${look_of("mine").color.match(/engine-\d+/)[0]}\\b`));
});

/** Reproducible bytes: random letters of an alphabet, with runs and repetitions. */
function bytes_of(size, alphabet) {
  let state = size + alphabet;
  const next = () => (state = (1103515245 * state + 12345) % 2 ** 31) >> 16;
  const bytes = new Uint8Array(size);
  for (let i = 0; i < size; ++i) bytes[i] = i > 300 && next() % 3 ? bytes[i - 1 - (next() % 300)] : next() % alphabet;
  return bytes;
}

const inputs = [0, 1, 2, 257, 5000, 200_000].flatMap((size) => [1, 2, 20, 256].map((alphabet) => bytes_of(size, alphabet)));
const packings = { "stored": { level: 0 }, "of fixed codes": { strategy: constants.Z_FIXED }, "without repetitions": { strategy: constants.Z_HUFFMAN_ONLY }, "fast": { level: 1 }, "best": { level: 9 } };

for (const [name, options] of Object.entries(packings)) {
  test(`what zlib packed unpacks to what it was: ${name}`, () => {
    for (const bytes of inputs) assert.ok(Buffer.from(unpack(deflateSync(bytes, options).toString("base64"))).equals(Buffer.from(bytes)));
  });

  test(`damaged data never unpacks to something else: ${name}`, () => {
    const bytes = Buffer.from(bytes_of(500, 20));
    const whole = deflateSync(bytes, options);
    for (let bit = 16; bit < 8 * whole.length; ++bit) {
      const broken = Buffer.from(whole);
      broken[bit >> 3] ^= 1 << (bit & 7);
      let found = bytes; // some bits mean nothing, such as those that fill the last byte
      try {
        found = Buffer.from(unpack(broken.toString("base64")));
      } catch {}
      assert.ok(found.equals(bytes), `bit ${bit}`);
    }
    for (let size = 0; size < whole.length; ++size) assert.throws(() => unpack(whole.subarray(0, size).toString("base64")), undefined, `${size} bytes`);
  });
}
