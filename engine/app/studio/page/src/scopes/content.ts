import type {Wanted} from "../connection/connection";
import type {AxisGroup} from "./axis_group";
import type {DisplayUnit} from "./display_unit";
import type {Feed} from "./feed";
import type {Stroke} from "./paint";
import {traceStyle} from "./palette";
import type {Plot, YAxis} from "./plot";
import {rowsWithin, type Samples} from "./samples";
import type {Shared} from "./shared";
import type {Trace} from "./trace";
import type {Range} from "./y_range";

/** Part of a scope that its content needs. */
export interface Subject {
  traces: Trace[];
  feed: Feed;
  shared: Shared;
  groups: AxisGroup[];
}

export interface Axes {
  x: Range;
  unitOfX: string;
  ys: YAxis[];
}

/** Visible curve for a picture: `x` in the unit of its axis, values in SI. `axis` is the index of its vertical axis. */
export interface Curve {
  trace: Trace;
  axis: number;
  unit: DisplayUnit;
  x: Float64Array;
  low: Float64Array;
  high: Float64Array;
}

/** Content of a scope: curves over time, one signal against another, or the difference to a pinned run. */
export interface Content {
  wanted(window: Range, isFollowing: boolean, pixels: number): Omit<Wanted, "columns">;
  /** Returns the axes for the data visible at `at` [s of the page's clock]. */
  axes(window: Range, at: number): Axes;
  paint(plot: Plot, window: Range): void;
  curves(window: Range): Curve[];
  /** Returns a line for below the plot. */
  note(): string;
}

export const strokeOf = (subject: Subject, trace: Trace, ratio: number, alpha = 1): Stroke =>
  ({...traceStyle(trace.style, subject.shared.colors), alpha, ratio});

export const samplesOf = (subject: Subject, trace: Trace): Samples | undefined => subject.feed.samples.get(trace.column);

/** Returns the rows of a window over time. */
export function curveOver(trace: Trace, axis: number, unit: DisplayUnit, {time, low, high}: Samples, window: Range): Curve {
  const {from, to} = rowsWithin(time, window), seen = low.subarray(from, to);
  return {trace, axis, unit, x: time.subarray(from, to), low: seen, high: high === low ? seen : high.subarray(from, to)};
}
