import type {DisplayUnit} from "./display_unit";
import {plainNumber} from "./numbers";
import {reduced, type Reduction, type Statistics} from "./statistics";
import {flowMapping, yamlScalar} from "./yaml_text";

/** Reductions that claims support. */
const claimed: Partial<Record<Reduction, {key: string; words: string}>> = {
  min: {key: "min", words: "the minimum of"}, max: {key: "max", words: "the maximum of"}, mean: {key: "mean", words: "the mean of"}, rms: {key: "rms", words: "the rms of"},
};

export const mayClaim = (reduction: Reduction): boolean => reduction in claimed || reduction === "a" || reduction === "b";

/** Formats a number for the file: "49.8 mm", "3". */
function quantity(value: number, unit: string): string {
  return unit === "" || unit === "1" ? plainNumber(value) : `${plainNumber(value)} ${unit}`;
}

const seconds = (time: number) => `${plainNumber(time, 9)} s`;

/** Removes the unit after " in " from a source; returns the expression. */
export const expressionOf = (source: string): string => source.replace(/\s+in\s+[^()]*$/, "");

interface Measured {
  source: string;
  label: string;
  statistics: Statistics;
  unit: DisplayUnit;
  a: number;
  b: number | undefined;
}

/** Returns an item of the section `claims` for a measurement between the cursors, within 1 %; undefined for an unsupported reduction. */
export function claimText({source, label, statistics, unit, a, b}: Measured, reduction: Reduction): string | undefined {
  if (!mayClaim(reduction)) return undefined;
  const value = reduced(statistics, reduction, unit, b !== undefined && b < a), expression = yamlScalar(expressionOf(source));
  const compared: [string, string][] = [["equals", quantity(value, unit.text)], ["within", withinOf(value, unit)]];
  if (reduction === "a" || reduction === "b") {
    const time = seconds(reduction === "a" ? a : b ?? a), that = yamlScalar(`${label} is ${quantity(value, unit.text)} at ${time}`);
    return flowMapping([["that", that], ["at", `{time: ${time}, value: ${expression}}`], ...compared]);
  }
  const {key, words} = claimed[reduction]!, from = seconds(Math.min(a, b ?? a)), to = seconds(Math.max(a, b ?? a));
  const that = yamlScalar(`${words} ${label} from ${from} to ${to} is ${quantity(value, unit.text)}`);
  return flowMapping([["that", that], ["where", `time >= ${from} && time <= ${to}`], [key, expression], ...compared]);
}

/** Returns the tolerance: 1 %, or a small absolute bound for 0 and for units with an offset (degC), where a percentage is meaningless. */
function withinOf(value: number, unit: DisplayUnit): string {
  return value !== 0 && unit.offset === 0 ? "1 %" : quantity(1e-6, unit.text);
}
