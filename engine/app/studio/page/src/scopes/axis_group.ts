import type {Fan} from "../run/run_types";
import {type DisplayUnit, shownOf} from "./display_unit";
import type {Pin} from "./pins";
import type {YAxis} from "./plot";
import {extent, type Samples} from "./samples";
import {scaleKey, type Trace, unitOf} from "./trace";
import {joined, type Range, YRange} from "./y_range";

/** Traces of one unit, which share an axis. The axis keeps its range when traces are added or removed. */
export interface AxisGroup {
  key: string;
  traces: Trace[];
  range: YRange;
  /** Present display unit. */
  unit: DisplayUnit;
}

/** Groups traces in the order of the first one of each group; existing groups keep their ranges. */
export function grouped(traces: Trace[], before: AxisGroup[]): AxisGroup[] {
  const groups = new Map<string, AxisGroup>();
  for (const trace of traces) {
    const key = scaleKey(trace), known = groups.get(key) ?? before.find((group) => group.key === key);
    const unit = known?.unit ?? unitOf(trace, 0), group = groups.get(key) ?? {key, traces: [], range: known?.range ?? new YRange(1 / unit.scale), unit};
    group.traces.push(trace);
    groups.set(key, group);
  }
  return [...groups.values()];
}

const magnitude = ({low, high}: Range) => Math.max(Math.abs(low), Math.abs(high));

/** Updates the range of a group with the visible data, and returns its axis. */
export function axisOf(group: AxisGroup, data: Range | undefined, at: number): YAxis {
  const range = group.range.update(data, at);
  group.unit = unitOf(group.traces[0], magnitude(range));
  return {key: group.key, unit: group.unit.text, range: {low: shownOf(range.low, group.unit), high: shownOf(range.high, group.unit)}};
}

/** Returns the range of the visible data of a group, including pinned runs and a fan. */
export function visible(group: AxisGroup, samplesOf: (trace: Trace) => Samples | undefined, pins: Pin[], fan: Fan | undefined, window: Range): Range | undefined {
  let all: Range | undefined;
  for (const trace of group.traces) {
    const sources = [samplesOf(trace), ...pins.map(({samples}) => samples.get(trace.source))];
    for (const samples of sources) {
      const own = samples && extent(samples, window);
      if (own) all = joined(all, own);
    }
    for (const samples of fan ? fanSamples(fan, trace.column) : []) {
      const own = extent(samples, window);
      if (own) all = joined(all, own);
    }
  }
  return all;
}

const fans = new WeakMap<Fan, Map<number, Samples[]>>();

/** Returns the curves of a fan for a column; creates them only once. */
export function fanSamples(fan: Fan, column: number): Samples[] {
  const known = fans.get(fan) ?? new Map<number, Samples[]>(), at = fan.columns.indexOf(column);
  fans.set(fan, known);
  if (!known.has(column)) known.set(column, at < 0 ? [] : fan.points.map(({time, columns}) => everySample(time, columns[at])));
  return known.get(column)!;
}

function everySample(time: number[], values: number[]): Samples {
  const own = Float64Array.from(values, (value) => value ?? NaN);
  return {time: Float64Array.from(time), low: own, high: own};
}

/** Zooms an axis about a share of its range, and fixes the new range. */
export function zoomAxis(group: AxisGroup, factor: number, share: number): void {
  const {low, high} = group.range.now, center = low + share * (high - low);
  group.range.choose({low: center - (center - low) * factor, high: center + (high - center) * factor});
}
