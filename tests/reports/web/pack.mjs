// Packs columns as reports/writers/packed.h describes.
import { deflateSync } from "node:zlib";

export class Numbers {
  bytes = [];

  put(value) {
    let rest = value < 0 ? -2 * value - 1 : 2 * value;
    for (; rest >= 128; rest = Math.floor(rest / 128)) this.bytes.push((rest % 128) + 128);
    this.bytes.push(rest);
  }

  smooth(values, step) {
    let [before, last] = [0, 0];
    for (const value of values) {
      const now = Math.round(value / step);
      this.put(now - 2 * last + before);
      [before, last] = [last, now];
    }
  }

  steady(values, step) {
    let last = 0;
    for (const value of values) {
      const now = Math.round(value / step);
      this.put(now - last);
      last = now;
    }
  }

  packed() {
    return pack(Uint8Array.from(this.bytes));
  }
}

export const pack = (bytes) => deflateSync(bytes, { level: 9 }).toString("base64");

/**
 * A run of a replay. `states` [moment][body] = [x, y, angle]; `energies` [moment] = [linear, rotational,
 * potential]; `places` are contact points, each a list of intervals {begin, points: [[x, y, jx, jy] ...]}.
 */
export function replay_run({ engine, method = "", times, states, energies, places = [], steps, apart = null, overlap = null }) {
  const poses = new Numbers();
  poses.smooth(times, 1e-6);
  states[0].forEach((_, body) => {
    for (let k = 0; k < 3; ++k) poses.smooth(states.map((moment) => moment[body][k]), k === 2 ? steps.angle : steps.length);
  });
  for (let k = 0; k < 3; ++k) poses.smooth(energies.map((moment) => moment[k]), steps.energy);
  const touches = new Numbers();
  touches.put(places.length);
  for (const stays of places) {
    touches.put(stays.length);
    let end = 0;
    for (const { begin, points } of stays) {
      touches.put(begin - end);
      touches.put(points.length);
      end = begin + points.length;
      for (let k = 0; k < 4; ++k) touches.steady(points.map((point) => point[k]), k < 2 ? steps.length : steps.impulse);
    }
  }
  return {
    engine,
    method,
    moments: times.length,
    every: 1,
    between: 0,
    ...steps,
    contacts: places.length ? "kept" : "none",
    apart,
    overlap,
    poses: poses.packed(),
    touches: places.length ? touches.packed() : "",
  };
}
