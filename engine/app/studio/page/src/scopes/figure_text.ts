import {expressionOf} from "./claim_text";
import {plainNumber} from "./numbers";
import type {Trace} from "./trace";
import type {Range} from "./y_range";
import {flowMapping, yamlScalar} from "./yaml_text";

const shown = ({source, unit}: Trace) => yamlScalar(unit && !/\sin\s/.test(source) ? `${expressionOf(source)} in ${unit.text}` : source);

function panel(title: string, traces: Trace[], range: Range | undefined): string {
  const seconds = range && [`${plainNumber(range.low, 9)} s`, `${plainNumber(range.high, 9)} s`];
  return flowMapping([
    ["plot", "lines"], ["x", "time in s"], ["y", traces.map(shown)],
    ["legend", traces.length > 1 ? `[${traces.map(({label}) => yamlScalar(label)).join(", ")}]` : undefined],
    ["y_label", traces.length === 1 ? yamlScalar(traces[0].label) : undefined],
    ["x_range", seconds && `[${seconds.join(", ")}]`], ["title", title ? yamlScalar(title) : undefined],
  ]);
}

/** Returns a figure of a diagram file with the content of a scope. Each unit has its own panel. `range`: of time [s]. */
export function figureText(title: string, groups: Trace[][], range?: Range): string {
  if (groups.length === 1) return panel(title, groups[0], range);
  const panels = groups.map((traces) => panel("", traces, range)).join(", ");
  return flowMapping([["title", title ? yamlScalar(title) : undefined], ["columns", "1"], ["panels", `[${panels}]`]]);
}

/** Returns a figure of y against x. */
export function figureTextXy(title: string, x: Trace, ys: Trace[]): string {
  return flowMapping([["plot", "xy"], ["x", shown(x)], ["y", ys.map(shown)], ["title", title ? yamlScalar(title) : undefined]]);
}
