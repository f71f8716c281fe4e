/** For a logarithmic axis: a domain of a decade at least, with room about the values, and round numbers to label in it. */
export function decades(values: number[], room = 1.5): { domain: [number, number]; ticks: number[] } {
  const low = Math.min(...values) / room;
  const high = Math.max(...values) * room;
  const lack = Math.max(1, Math.sqrt(10 / (high / low)));
  const domain: [number, number] = [low / lack, high * lack];
  const [first, last] = [Math.floor(Math.log10(domain[0])), Math.ceil(Math.log10(domain[1]))];
  const steps = last - first > 3 ? [1] : [1, 2, 5];
  const powers = Array.from({ length: last - first + 1 }, (_, index) => first + index).filter((power) => (last - first < 9 || power % 2 === 0));
  const ticks = powers.flatMap((power) => steps.map((step) => step * 10 ** power));
  return { domain, ticks: ticks.filter((tick) => tick >= domain[0] && tick <= domain[1]) };
}
