// Formatting of numbers for people.

const minus = "\u2212";

/** Limits beyond which a number is written with a power of ten. */
const largest = 1e6, smallest = 1e-4;

/** Returns the shortest text with at most `digits` significant digits: "49.77", "1.2e-7", "–" for NaN. */
export function numberText(value: number, digits = 5): string {
  if (Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : `${minus}∞`;
  const magnitude = Math.abs(value);
  const text = magnitude !== 0 && (magnitude >= largest || magnitude < smallest)
    ? value.toExponential(digits - 1).replace(/\.?0+e/, "e").replace("e+", "e")
    : String(Number(value.toPrecision(digits)));
  return text.replace(/-/g, minus);
}

/** Formats with a fixed number of decimals, so that columns and changing numbers do not jump. */
export function fixedText(value: number, decimals: number): string {
  return (Math.abs(value) < 0.5 * 10 ** -decimals ? 0 : value).toFixed(decimals).replace("-", minus);
}

/** Returns the number of decimals of multiples of `step`. */
export function decimalsOf(step: number): number {
  if (!(step > 0) || !Number.isFinite(step)) return 0;
  for (let decimals = 0; decimals < 12; ++decimals) {
    const whole = step * 10 ** decimals;
    if (whole > 0.5 && Math.abs(whole - Math.round(whole)) < 1e-6 * whole) return decimals;
  }
  return 12;
}

/** Formats a number for files: significant digits, and an ASCII minus. */
export function plainNumber(value: number, digits = 6): string {
  return String(Number(value.toPrecision(digits)));
}

/** Formats a value with its unit: "49.8 mm". */
export function quantityText(value: number, unit: string, digits = 5): string {
  return unit === "" || unit === "1" ? numberText(value, digits) : `${numberText(value, digits)} ${unit}`;
}

/** Formats a duration, from microseconds to seconds: "12.5 ms". */
export function durationText(seconds: number, digits = 4): string {
  const magnitude = Math.abs(seconds);
  if (magnitude === 0 || magnitude >= 1) return quantityText(seconds, "s", digits);
  return magnitude >= 1e-3 ? quantityText(seconds * 1e3, "ms", digits) : quantityText(seconds * 1e6, "µs", digits);
}
