// Unpacks what reports/writers/packed.h packs: base64 of bytes that zlib has deflated (RFC 1950, RFC 1951). By hand, since
// DecompressionStream answers later only, and the page is complete, and can be printed, once its script has run.

const [first_length, first_distance] = [257, 30];
const length_bits = [0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0];
const distance_bits = Array.from({ length: first_distance }, (_, code) => Math.max(0, (code >> 1) - 1));
const sums = (bits: number[], start: number): number[] => bits.map((_, code) => bits.slice(0, code).reduce((sum, one) => sum + (1 << one), start));
const lengths = [...sums(length_bits.slice(0, 28), 3), 258];
const distances = sums(distance_bits, 1);
const order = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];

const damaged = (): Error => new Error("packed data is damaged");

/** For the next `bits` bits of the input the symbol, times 16, plus the length of its code; 0 where no code begins so. */
interface Codes {
  bits: number;
  table: Uint16Array;
}

function codes_of(lengths: ArrayLike<number>): Codes {
  const counts = new Uint16Array(17);
  for (let symbol = 0; symbol < lengths.length; ++symbol) ++counts[lengths[symbol] ?? 0]!;
  counts[0] = 0;
  let bits = 15;
  while (bits > 1 && !counts[bits]) --bits;
  const next = new Uint16Array(17);
  for (let length = 1; length <= 15; ++length) next[length + 1] = (next[length]! + counts[length]!) << 1;
  const table = new Uint16Array(1 << bits);
  for (let symbol = 0; symbol < lengths.length; ++symbol) {
    const length = lengths[symbol]!;
    if (!length) continue;
    let code = next[length]!++;
    let turned = 0; // codes come highest bit first, in a stream whose lowest bit is the first
    for (let i = 0; i < length; ++i, code >>= 1) turned = (turned << 1) | (code & 1);
    for (; turned < table.length; turned += 1 << length) table[turned] = symbol * 16 + length;
  }
  return { bits, table };
}

const fixed = {
  letters: codes_of(Array.from({ length: 288 }, (_, symbol) => (symbol < 144 ? 8 : symbol < 256 ? 9 : symbol < 280 ? 7 : 8))),
  distances: codes_of(new Array<number>(30).fill(5)),
};

/** The checksum behind the data (Adler-32). */
function checksum(bytes: Uint8Array): number {
  let [low, high] = [1, 0];
  for (let begin = 0; begin < bytes.length; begin += 4096) {
    const end = Math.min(begin + 4096, bytes.length); // sums that a small integer holds
    for (let i = begin; i < end; ++i) high += low += bytes[i]!;
    low %= 65521;
    high %= 65521;
  }
  return high * 65536 + low;
}

/** Throws if the data is damaged. */
function inflated(bytes: Uint8Array): Uint8Array {
  let [at, hold, held] = [2, 0, 0]; // the next byte, and the bits before it that are not used yet
  let out = new Uint8Array(8 * bytes.length + 64);
  let size = 0;

  const take = (count: number): number => {
    for (; held < count; held += 8) hold |= bytes[at++]! << held;
    if (at > bytes.length) throw damaged();
    const value = hold & ((1 << count) - 1);
    hold >>>= count;
    held -= count;
    return value;
  };
  const symbol = ({ bits, table }: Codes): number => {
    for (; held < bits; held += 8) hold |= bytes[at++]! << held; // may read bits of the checksum behind the last block
    const found = table[hold & ((1 << bits) - 1)]!;
    const used = found & 15;
    if (!used) throw damaged();
    hold >>>= used;
    held -= used;
    return found >> 4;
  };
  const reserve = (needed: number): void => {
    if (needed <= out.length) return;
    const larger = new Uint8Array(2 * needed);
    larger.set(out);
    out = larger;
  };
  // Nearly all of the time is spent here, where variables of its own are twice as fast as those that are shared.
  const block = (letters: Codes, far: Codes): void => {
    const [letter_table, far_table, letter_mask, far_mask] = [letters.table, far.table, (1 << letters.bits) - 1, (1 << far.bits) - 1];
    let [from, to, bits, many, room] = [at, size, hold, held, out];
    for (;;) {
      if (from > bytes.length + 8) throw damaged();
      if (to + 258 > room.length) {
        reserve(to + 258);
        room = out;
      }
      for (; many < 15; many += 8) bits |= bytes[from++]! << many; // may read bits of what follows the last block
      const letter = letter_table[bits & letter_mask]!;
      if (!(letter & 15)) throw damaged();
      bits >>>= letter & 15;
      many -= letter & 15;
      if (letter < 256 << 4) {
        room[to++] = letter >> 4;
        continue;
      }
      if (letter >> 4 === 256) break;
      const kind = (letter >> 4) - first_length;
      for (; many < 20; many += 8) bits |= bytes[from++]! << many;
      const length = lengths[kind]! + (bits & ((1 << length_bits[kind]!) - 1));
      bits >>>= length_bits[kind]!;
      many -= length_bits[kind]!;
      for (; many < 15; many += 8) bits |= bytes[from++]! << many;
      const code = far_table[bits & far_mask]!;
      if (!(code & 15)) throw damaged();
      bits >>>= code & 15;
      many -= code & 15;
      const extra = distance_bits[code >> 4]!;
      for (; many < extra; many += 8) bits |= bytes[from++]! << many;
      const distance = distances[code >> 4]! + (bits & ((1 << extra) - 1));
      bits >>>= extra;
      many -= extra;
      if (!(distance <= to)) throw damaged();
      for (const end = to + length; to < end; ++to) room[to] = room[to - distance]!;
    }
    [at, size, hold, held] = [from, to, bits, many];
  };
  const described = (): [Codes, Codes] => {
    const [letters, far, described] = [take(5) + 257, take(5) + 1, take(4) + 4];
    const first = new Uint8Array(19);
    for (let i = 0; i < described; ++i) first[order[i]!] = take(3);
    const codes = codes_of(first);
    const found: number[] = [];
    while (found.length < letters + far) {
      const length = symbol(codes);
      if (length < 16) found.push(length);
      else if (length === 16) found.push(...new Array<number>(3 + take(2)).fill(found[found.length - 1] ?? 0));
      else found.push(...new Array<number>(length === 17 ? 3 + take(3) : 11 + take(7)).fill(0));
    }
    return [codes_of(found.slice(0, letters)), codes_of(found.slice(letters))];
  };

  for (let last = false; !last; ) {
    last = take(1) === 1;
    const kind = take(2);
    if (kind === 1) block(fixed.letters, fixed.distances);
    else if (kind === 2) block(...described());
    else if (kind === 0) {
      at -= held >> 3;
      hold = held = 0;
      const length = bytes[at]! | (bytes[at + 1]! << 8);
      at += 4;
      reserve(size + length);
      out.set(bytes.subarray(at, at + length), size);
      at += length;
      size += length;
    } else throw damaged();
  }
  at -= held >> 3;
  const whole = out.subarray(0, size);
  if (bytes.length !== at + 4 || new DataView(bytes.buffer, bytes.byteOffset).getUint32(at) !== checksum(whole)) throw damaged();
  return whole;
}

/** The bytes of a packed text; throws if it is damaged. */
export function unpack(text: string): Uint8Array {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return inflated(bytes);
}

/** The JSON value in a packed text. */
export const unpack_json = (text: string): unknown => JSON.parse(new TextDecoder().decode(unpack(text)));
