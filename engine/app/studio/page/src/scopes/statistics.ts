import {type DisplayUnit, perSecond, shownOf} from "./display_unit";
import {durationText, numberText, quantityText} from "./numbers";

/** Statistics of all samples in an interval, from the server; SI, slope per second. */
export interface Statistics {
  column: number;
  min: number;
  max: number;
  mean: number;
  rms: number;
  slope: number;
  first: number;
  last: number;
}

export type Reduction = "min" | "max" | "mean" | "rms" | "slope" | "a" | "b" | "difference";

/** Columns of the table, in order. */
export const reductions: {name: Reduction; title: string; needsBoth: boolean}[] = [
  {name: "a", title: "A", needsBoth: false}, {name: "b", title: "B", needsBoth: true}, {name: "difference", title: "B − A", needsBoth: true},
  {name: "min", title: "min", needsBoth: true}, {name: "max", title: "max", needsBoth: true}, {name: "mean", title: "mean", needsBoth: true},
  {name: "rms", title: "rms", needsBoth: true}, {name: "slope", title: "slope", needsBoth: true},
];

/** Returns the values at A and B from the ends of the interval, swapped if B is before A. */
function ends({first, last}: Statistics, isTurned: boolean): {a: number; b: number} {
  return isTurned ? {a: last, b: first} : {a: first, b: last};
}

/** Returns one number of the table in the display unit. Differences and slopes have no offset; rms is that of the displayed values. */
export function reduced(statistics: Statistics, reduction: Reduction, unit: DisplayUnit, isTurned = false): number {
  const {a, b} = ends(statistics, isTurned);
  switch (reduction) {
    case "a": return shownOf(a, unit);
    case "b": return shownOf(b, unit);
    case "difference": return (b - a) * unit.scale;
    case "slope": return statistics.slope * unit.scale;
    case "rms": return Math.sqrt(Math.max(0, (statistics.rms * unit.scale) ** 2 + 2 * statistics.mean * unit.scale * unit.offset + unit.offset ** 2));
    default: return shownOf(statistics[reduction], unit);
  }
}

export function reducedUnit(reduction: Reduction, unit: DisplayUnit): string {
  return reduction === "slope" ? perSecond(unit.text) : unit.text;
}

/** Formats a number of the table: "49.8 mm". */
export function reducedText(statistics: Statistics, reduction: Reduction, unit: DisplayUnit, isTurned = false): string {
  return quantityText(reduced(statistics, reduction, unit, isTurned), reducedUnit(reduction, unit));
}

/** Returns "A 1.2 s, B 1.45 s, B − A 250 ms, 1/(B − A) 4 Hz". */
export function marksText(a: number | undefined, b: number | undefined): string {
  if (a === undefined) return "";
  const parts = [`A ${quantityText(a, "s", 7)}`];
  if (b !== undefined) parts.push(`B ${quantityText(b, "s", 7)}`, `B − A ${durationText(b - a, 5)}`);
  if (b !== undefined && b !== a) parts.push(`1/(B − A) ${frequencyText(1 / Math.abs(b - a))}`);
  return parts.join(", ");
}

export function frequencyText(hertz: number): string {
  return hertz >= 1e3 ? `${numberText(hertz / 1e3)} kHz` : `${numberText(hertz)} Hz`;
}
