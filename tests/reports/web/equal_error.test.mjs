import assert from "node:assert/strict";
import { test } from "node:test";
import { source } from "./source.mjs";

const { factors_over } = await source("studies/equal_error.ts");

const box2d = { label: "box2d" };
const impulse = { label: "impulse" };
const cases = (...factors) => factors.map((factor) => ({ curves: [{ engine: box2d, factor: 1 }, { engine: impulse, factor }] }));

test("a method's factor is the median over the cases where it gets there, with the middle half", () => {
  assert.deepEqual(factors_over(cases(0.4, null, 0.1, 0.2)), [
    { engine: box2d, median: 1, low: 1, high: 1, cases: 4, reached: 4 },
    { engine: impulse, median: 0.2, low: 0.15000000000000002, high: 0.30000000000000004, cases: 4, reached: 3 },
  ]);
  assert.equal(factors_over(cases(0.1, 0.3))[1].median, 0.2);
});

test("a method that never gets there has no factor", () => {
  assert.deepEqual(factors_over(cases(null, null))[1], { engine: impulse, median: null, low: null, high: null, cases: 2, reached: 0 });
  assert.deepEqual(factors_over([]), []);
});
