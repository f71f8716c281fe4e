// The motion of one run: poses, velocities, energies and contacts at any time.
import type { Engine } from "../model";
import { unpack } from "../packed";
import { Numbers, type ReplayRun } from "./data";

const per_body = 3; // x, y, angle
const per_touch = 4; // x, y, impulse x, impulse y

export interface Energies {
  linear: number; // J, as are the others
  rotational: number;
  potential: number;
}

export class Film {
  readonly times: Float64Array; // s
  private readonly poses: Float64Array; // moment by moment, body by body
  private readonly energies: Float64Array; // moment by moment
  private readonly touches: Float64Array[]; // by moment
  /** m, rad: the poses at the current time. */
  readonly now: Float64Array;
  /** m/s, from the displacement between the kept moments around the current time. */
  readonly velocity: Float64Array;
  /** The lowest potential energy and the largest total energy, J. */
  readonly energy_range: { floor: number; top: number };
  private moment = 0;
  private fraction = 0; // of the time to the next moment

  private constructor(
    readonly engine: Engine,
    readonly run: ReplayRun,
    readonly bodies: number,
    poses: Numbers,
    touches: Numbers | undefined,
  ) {
    const { moments } = run;
    this.times = new Float64Array(moments);
    this.poses = new Float64Array(moments * bodies * per_body);
    this.energies = new Float64Array(moments * 3);
    this.now = new Float64Array(bodies * per_body);
    this.velocity = new Float64Array(bodies * 2);
    poses.smooth(moments, 1e-6, this.times);
    for (let k = 0; k < bodies * per_body; ++k) {
      poses.smooth(moments, k % per_body === 2 ? run.angle : run.length, this.poses, k, bodies * per_body);
    }
    for (let k = 0; k < 3; ++k) poses.smooth(moments, run.energy, this.energies, k, 3);
    if (!poses.ended) throw new Error("a packed column is too long");
    this.touches = touches ? touches_of(touches, run) : [];
    this.energy_range = range_of(this.energies);
  }

  static of(engine: Engine, run: ReplayRun, bodies: number): Film {
    const touches = run.touches ? new Numbers(unpack(run.touches)) : undefined;
    return new Film(engine, run, bodies, new Numbers(unpack(run.poses)), touches);
  }

  get end(): number {
    return this.times[this.times.length - 1] ?? 0;
  }

  /** The last kept moment up to a time, within a microsecond. */
  moment_at(time: number): number {
    let low = 0;
    let high = this.times.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if ((this.times[middle] ?? 0) <= time + 1e-6) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** Sets the current time. */
  go_to(time: number): void {
    this.moment = this.moment_at(time);
    const next = Math.min(this.moment + 1, this.times.length - 1);
    const start = this.times[this.moment] ?? 0;
    const span = (this.times[next] ?? 0) - start;
    this.fraction = span > 0 ? Math.min(1, Math.max(0, (time - start) / span)) : 0;
    const size = this.bodies * per_body;
    const before = this.poses.subarray(this.moment * size, (this.moment + 1) * size);
    const after = this.poses.subarray(next * size, (next + 1) * size);
    for (let k = 0; k < size; ++k) {
      const from = before[k] ?? 0;
      this.now[k] = from + this.fraction * ((after[k] ?? 0) - from);
    }
    for (let body = 0; body < this.bodies; ++body) {
      for (let axis = 0; axis < 2; ++axis) {
        const k = body * per_body + axis;
        this.velocity[body * 2 + axis] = span > 0 ? ((after[k] ?? 0) - (before[k] ?? 0)) / span : 0;
      }
    }
  }

  energy(): Energies {
    const next = Math.min(this.moment + 1, this.times.length - 1);
    const at = (k: number): number => {
      const from = this.energies[this.moment * 3 + k] ?? 0;
      return from + this.fraction * ((this.energies[next * 3 + k] ?? 0) - from);
    };
    return { linear: at(0), rotational: at(1), potential: at(2) };
  }

  /** The contacts of the last step: x, y (m) and impulse x, y (N s) of each point. */
  contacts(): Float64Array | undefined {
    return this.touches[this.moment];
  }

  largest_impulse(): number {
    let largest = 0;
    for (const moment of this.touches) {
      for (let i = 0; i < moment.length; i += per_touch) largest = Math.max(largest, Math.hypot(moment[i + 2] ?? 0, moment[i + 3] ?? 0));
    }
    return largest;
  }

  /** Visits every recorded position. */
  each_position(visit: (body: number, x: number, y: number) => void): void {
    for (let k = 0; k < this.poses.length; k += per_body) {
      visit((k / per_body) % this.bodies, this.poses[k] ?? 0, this.poses[k + 1] ?? 0);
    }
  }
}

function range_of(energies: Float64Array): Film["energy_range"] {
  let floor = Infinity;
  let top = -Infinity;
  for (let i = 0; i < energies.length; i += 3) {
    floor = Math.min(floor, energies[i + 2] ?? 0);
    top = Math.max(top, (energies[i] ?? 0) + (energies[i + 1] ?? 0) + (energies[i + 2] ?? 0));
  }
  return { floor, top };
}

function touches_of(numbers: Numbers, { moments, length, impulse }: ReplayRun): Float64Array[] {
  const found: number[][] = Array.from({ length: moments }, () => []);
  for (let points = numbers.next(); points > 0; --points) {
    let moment = 0;
    for (let intervals = numbers.next(); intervals > 0; --intervals) {
      moment += numbers.next();
      const count = numbers.next();
      if (count < 1 || moment + count > moments) throw new Error("a contact lasts longer than its run");
      const columns = new Float64Array(count * per_touch);
      for (let k = 0; k < per_touch; ++k) numbers.steady(count, k < 2 ? length : impulse, columns, k, per_touch);
      for (let i = 0; i < count; ++i) found[moment + i]?.push(...columns.subarray(i * per_touch, (i + 1) * per_touch));
      moment += count;
    }
  }
  if (!numbers.ended) throw new Error("packed contacts are too long");
  return found.map((one) => Float64Array.from(one));
}
