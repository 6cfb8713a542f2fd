import type {Frame} from "../connection/frame";
import type {Range} from "./y_range";

/** Values of one signal in SI. Complete samples have the same array as `low` and `high`; otherwise these are the extremes of intervals. */
export interface Samples {
  time: Float64Array;
  low: Float64Array;
  high: Float64Array;
}

/** Returns the signals of a frame, in the requested order. */
export function samplesOf({kind, time, columns}: Pick<Frame, "kind" | "time" | "columns">): Samples[] {
  if (kind === "samples") return columns.map((values) => ({time, low: values, high: values}));
  return Array.from({length: columns.length >> 1}, (_, i) => ({time, low: columns[2 * i], high: columns[2 * i + 1]}));
}

export const isEvery = (samples: Samples): boolean => samples.low === samples.high;

/** Returns the first row at or after `at`; the number of rows if there is none. */
export function rowFrom(time: Float64Array, at: number): number {
  let low = 0, high = time.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (time[middle] < at) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Returns the row nearest to a time; -1 without rows. */
export function nearestRow(time: Float64Array, at: number): number {
  const row = rowFrom(time, at);
  if (row === 0) return time.length > 0 ? 0 : -1;
  return row === time.length || at - time[row - 1] <= time[row] - at ? row - 1 : row;
}

/** Returns the rows of a window and one on either side. `to` is exclusive. */
export function rowsWithin(time: Float64Array, {low, high}: Range): {from: number; to: number} {
  return {from: Math.max(0, rowFrom(time, low) - 1), to: Math.min(time.length, rowFrom(time, high) + 1)};
}

/** Returns the range of values in a window, without NaN; undefined if there are none. */
export function extent(samples: Samples, window: Range): Range | undefined {
  const {from, to} = rowsWithin(samples.time, window);
  let low = Infinity, high = -Infinity;
  for (let row = from; row < to; ++row) {
    if (samples.low[row] < low) low = samples.low[row];
    if (samples.high[row] > high) high = samples.high[row];
  }
  return low <= high && Number.isFinite(high - low) ? {low, high} : undefined;
}

/** Returns the value of a signal at a time, or the range of its interval. */
export function valueAt(samples: Samples, at: number): Range | undefined {
  const row = nearestRow(samples.time, at);
  return row < 0 ? undefined : {low: samples.low[row], high: samples.high[row]};
}

/** Returns the time of the first sample if earlier ones are missing; undefined otherwise. */
export function gapOf(samples: Samples | undefined): number | undefined {
  if (!samples || samples.low.length === 0 || !Number.isNaN(samples.low[0])) return undefined;
  const first = samples.low.findIndex((value) => !Number.isNaN(value));
  return samples.time[first < 0 ? samples.time.length - 1 : first];
}
