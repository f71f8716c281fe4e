// Numbers and words for reading: significant digits, units, commands.

const minus = "\u2212";
const thin = "\u202f";
const superscripts = "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079";

function raised(exponent: number): string {
  const digits = [...String(Math.abs(exponent))].map((digit) => superscripts[Number(digit)]).join("");
  return (exponent < 0 ? "\u207b" : "") + digits;
}

const signed = (text: string): string => text.replace("-", minus);

/** The unit "1" is left out. */
const with_unit = (text: string, unit: string): string => (unit && unit !== "1" ? `${text}${thin}${pretty_unit(unit)}` : text);

/** "kg m^2/s" -> "kg m²/s" with no-break spaces; "us" -> "µs" */
export function pretty_unit(unit: string): string {
  return unit.replace(/^us\b/, "\u00b5s").replaceAll(" ", thin).replace(/\^(-?\d+)/g, (_, power: string) => raised(Number(power)));
}

/** "truth_error_rms" -> "truth error rms": report.json uses identifiers as names. */
export const words = (name: string): string => name.replaceAll("_", " ");

/** Rounded to significant digits; very small and large values as powers of ten. */
export function number(value: number | null | undefined, unit = "", digits = 3): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "not finite";
  if (value === 0) return with_unit("0", unit);
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-3) {
    const [mantissa = "", exponent = "0"] = value.toExponential(digits - 1).split("e");
    const factor = mantissa === "1" ? "" : `${signed(mantissa)}${thin}\u00d7${thin}`;
    return with_unit(`${factor}10${raised(Number(exponent))}`, unit);
  }
  const rounded = Math.abs(Number(value.toPrecision(digits)));
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(rounded)));
  return with_unit(signed(value.toFixed(decimals)), unit);
}

const least_percent = 0.001;

/** A ratio in percent with two digits; a dash if there is none or it is not finite. */
export function percent(ratio: number | null | undefined): string {
  if (typeof ratio !== "number" || !Number.isFinite(ratio)) return "\u2013";
  if (ratio > 0 && 100 * ratio < least_percent) return with_unit(`< ${least_percent}`, "%");
  return number(100 * ratio, "%", 2);
}

/** The share of a whole in percent, rounded down: 100 % means all. */
export const share = (part: number, whole: number): string => (whole ? with_unit(String(Math.floor((100 * part) / whole)), "%") : "\u2013");

/** A parameter as it was entered, without added digits. */
export function given(value: number, unit = "", digits = 6): string {
  const short = Number(value.toPrecision(digits));
  const plain = short === 0 || (Math.abs(short) >= 1e-4 && Math.abs(short) < 1e7);
  return plain ? with_unit(signed(String(short)), unit) : number(short, unit, 2);
}

/** A value that is compared with another: shows two digits of their difference, and no further digits. */
export function to_within(value: number | null, difference: number, unit: string): string {
  if (value === null || !Number.isFinite(value)) return "not finite";
  if (value === 0) return with_unit("0", unit);
  if (!(difference > 0) || !Number.isFinite(difference) || Math.abs(value) >= 1e6) return number(value, unit, 6);
  const decimals = Math.min(6, Math.max(0, 1 - Math.floor(Math.log10(difference))));
  const text = value.toFixed(decimals);
  return with_unit(signed(Number(text) === 0 ? text.replace("-", "") : text), unit);
}

/** "1/60 s" rather than "0.0167 s" */
export function time_step(dt: number): string {
  const rate = Math.round(1 / dt);
  return dt > 0 && Math.abs(rate * dt - 1) < 1e-9 ? with_unit(rate === 1 ? "1" : `1/${rate}`, "s") : number(dt, "s");
}

/** "1/60", as --dt takes it */
export function step_word(dt: number): string {
  const rate = Math.round(1 / dt);
  return dt > 0 && Math.abs(rate * dt - 1) < 1e-9 ? (rate === 1 ? "1" : `1/${rate}`) : String(dt);
}

/** error / tolerance; NaN means nothing was judged, infinity a tolerance of 0 or an error that is not finite. */
export function ratio_text(ratio: number): string {
  if (Number.isNaN(ratio)) return "\u2013";
  if (ratio === 0) return "0";
  if (ratio === Infinity) return "\u221e";
  if (ratio < 0.001) return "< 0.001";
  if (ratio < 10) return ratio.toFixed(ratio < 0.0995 ? 3 : 2);
  return ratio < 1000 ? ratio.toPrecision(3) : "> 1000";
}

/** "3.2 times" */
export const times = (ratio: number): string => (ratio >= 1000 ? "more than 1000 times" : `${ratio_text(ratio)} times`);

/** A command line, quoted for a shell. */
export function shell(words: string[]): string {
  return words.map((word) => (/^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`)).join(" ");
}

/** "a, b and c" */
export function enumerate(parts: string[]): string {
  return parts.length < 2 ? parts.join("") : `${parts.slice(0, -1).join(", ")} and ${parts[parts.length - 1]}`;
}

export const count = (many: number, one: string): string => `${many} ${one}${many === 1 ? "" : "s"}`;
