/** Unit of an axis: shown = SI * scale + offset. */
export interface DisplayUnit {
  text: string;
  scale: number;
  offset: number;
}

const prefixes: [string, number][] = [["µ", 1e-6], ["m", 1e-3], ["", 1], ["k", 1e3], ["M", 1e6]];
/** Units that accept a prefix; none of them has a prefix or exponent yet. */
const bare = new Set(["m", "s", "N", "A", "V", "W", "J", "Pa", "Hz", "T", "H", "F", "ohm", "K", "g"]);
/** Units that accept only submultiples: no kiloseconds, no megakelvin. */
const noMultiples = new Set(["s", "K"]);

/** Returns the first unit of a text, "N" for "N s/m", if it is in `bare` and has no exponent. */
function firstUnit(unit: string): string | undefined {
  const first = /^[A-Za-z]+/.exec(unit)?.[0];
  return first && bare.has(first) && unit[first.length] !== "^" ? first : undefined;
}

/** Returns the unit with the prefix for which the largest magnitude [SI] is between 1 and 1000: "mm" for 0.04 of "m". */
export function prefixed(unit: string, magnitude: number): DisplayUnit {
  const first = firstUnit(unit);
  if (!first || !(magnitude > 0) || !Number.isFinite(magnitude)) return {text: unit, scale: 1, offset: 0};
  const allowed = prefixes.filter(([, factor]) => factor <= 1 || !noMultiples.has(first));
  const fitting = allowed.filter(([, factor]) => magnitude >= factor * (1 - 1e-9));
  const [prefix, factor] = fitting.at(-1) ?? allowed[0];
  return {text: prefix + unit, scale: 1 / factor, offset: 0};
}

/** Converts SI to the display unit. */
export const shownOf = (value: number, unit: DisplayUnit): number => value * unit.scale + unit.offset;

/** Returns a unit divided by time: "mm/s", "(N s/m)/s". */
export function perSecond(unit: string): string {
  if (unit === "" || unit === "1") return "1/s";
  return /[ /]/.test(unit) ? `(${unit})/s` : `${unit}/s`;
}
