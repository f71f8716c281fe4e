// The other end of reports/writers/packed.h.

/** Base64 of deflated bytes -> bytes. Throws where it is damaged. */
export async function unpack(text: string): Promise<Uint8Array> {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Whole numbers in turn, and columns of them. */
export class Numbers {
  private place = 0;

  constructor(private readonly bytes: Uint8Array) {}

  get ended(): boolean {
    return this.place === this.bytes.length;
  }

  next(): number {
    let value = 0;
    let weight = 1;
    for (;;) {
      const byte = this.bytes[this.place++];
      if (byte === undefined) throw new Error("a packed column ends too early");
      value += (byte & 127) * weight;
      if (byte < 128) break;
      weight *= 128;
    }
    return value % 2 ? -(value + 1) / 2 : value / 2;
  }

  /** Into every stride-th place of `out` from `start` on. */
  smooth(count: number, step: number, out: Float64Array, start = 0, stride = 1): void {
    let before = 0;
    let last = 0;
    for (let i = 0; i < count; ++i) {
      const now = this.next() + 2 * last - before;
      out[start + i * stride] = now * step;
      before = last;
      last = now;
    }
  }

  steady(count: number, step: number, out: Float64Array, start = 0, stride = 1): void {
    let last = 0;
    for (let i = 0; i < count; ++i) {
      last += this.next();
      out[start + i * stride] = last * step;
    }
  }
}
