// Numbers as people read them.

const minus = "\u2212";

/** Beyond these a number is written with a power of ten. */
const largest = 1e6, smallest = 1e-4;

/** The shortest text with at most `digits` that count: "49.77", "1.2e-7", "–" for no number. */
export function numberText(value: number, digits = 5): string {
  if (Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : `${minus}∞`;
  const magnitude = Math.abs(value);
  const text = magnitude !== 0 && (magnitude >= largest || magnitude < smallest)
    ? value.toExponential(digits - 1).replace(/\.?0+e/, "e").replace("e+", "e")
    : String(Number(value.toPrecision(digits)));
  return text.replace(/-/g, minus);
}

/** With a fixed number of decimals, so that a column of them, or one that changes, does not jump. */
export function fixedText(value: number, decimals: number): string {
  return (Math.abs(value) < 0.5 * 10 ** -decimals ? 0 : value).toFixed(decimals).replace("-", minus);
}

/** How many decimals multiples of `step` need. */
export function decimalsOf(step: number): number {
  if (!(step > 0) || !Number.isFinite(step)) return 0;
  for (let decimals = 0; decimals < 12; ++decimals) {
    const whole = step * 10 ** decimals;
    if (whole > 0.5 && Math.abs(whole - Math.round(whole)) < 1e-6 * whole) return decimals;
  }
  return 12;
}

/** For files: 12 digits that count, an ordinary minus. */
export function plainNumber(value: number, digits = 6): string {
  return String(Number(value.toPrecision(digits)));
}

/** A value with its unit: "49.8 mm". */
export function quantityText(value: number, unit: string, digits = 5): string {
  return unit === "" || unit === "1" ? numberText(value, digits) : `${numberText(value, digits)} ${unit}`;
}

/** A stretch of time, from microseconds to seconds: "12.5 ms". */
export function durationText(seconds: number, digits = 4): string {
  const magnitude = Math.abs(seconds);
  if (magnitude === 0 || magnitude >= 1) return quantityText(seconds, "s", digits);
  return magnitude >= 1e-3 ? quantityText(seconds * 1e3, "ms", digits) : quantityText(seconds * 1e6, "µs", digits);
}
