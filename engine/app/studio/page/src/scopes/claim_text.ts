import type {DisplayUnit} from "./display_unit";
import {plainNumber} from "./numbers";
import {reduced, type Reduction, type Statistics} from "./statistics";
import {flowMapping, yamlScalar} from "./yaml_text";

/** Reductions that a claim has, too. */
const claimed: Partial<Record<Reduction, {key: string; words: string}>> = {
  min: {key: "min", words: "the least"}, max: {key: "max", words: "the greatest"}, mean: {key: "mean", words: "the mean of"}, rms: {key: "rms", words: "the rms of"},
};

export const mayClaim = (reduction: Reduction): boolean => reduction in claimed || reduction === "a" || reduction === "b";

/** A number of the file: "49.8 mm", "3". */
function quantity(value: number, unit: string): string {
  return unit === "" || unit === "1" ? plainNumber(value) : `${plainNumber(value)} ${unit}`;
}

const seconds = (time: number) => `${plainNumber(time, 9)} s`;

/** Without the unit that follows " in ": the expression alone. */
export const expressionOf = (source: string): string => source.replace(/\s+in\s+[^()]*$/, "");

interface Measured {
  source: string;
  label: string;
  statistics: Statistics;
  unit: DisplayUnit;
  a: number;
  b: number | undefined;
}

/** An item of the section `claims` that says what was measured between the cursors, to a percent; undefined where no claim can say it. */
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

/** One percent; around zero, and with an offset (of degC), where a percent means nothing, a small absolute bound. */
function withinOf(value: number, unit: DisplayUnit): string {
  return value !== 0 && unit.offset === 0 ? "1 %" : quantity(1e-6, unit.text);
}
