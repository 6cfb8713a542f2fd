// Scale of an axis: its range, its ticks and their labels.

import type {Axis} from "./spec";

export interface Tick {
  at: number;
  label: string;
}

/** Axis with values for all optional fields of the spec. */
export interface Scale {
  axis: Axis;
  low: number; // left or lower end
  high: number;
  ticks: Tick[];
  minor: number[];
  label: string; // with its unit
  /** Returns the position of a value: 0 at the left or lower end, 1 at the other; NaN if the axis cannot show it. */
  share(value: number | null | undefined): number;
}

/** "position [mm]". */
export const labelOf = ({label = "", unit = ""}: Axis) => (unit === "" ? label : `${label} [${unit}]`);

/** Formats a number like gnuplot's "%g", with a proper minus sign. */
export function numberText(value: number): string {
  const rounded = Number.parseFloat(value.toPrecision(6));
  if (rounded === 0) return "0";
  const power = Math.floor(Math.log10(Math.abs(rounded)));
  if (power >= -5 + 1 && power < 6) return String(rounded).replace("-", "−");
  const [digits, exponent] = rounded.toExponential().split("e") as [string, string];
  return `${digits}e${exponent[0]}${exponent.slice(1).padStart(2, "0")}`.replaceAll("-", "−");
}

/** Returns gnuplot's tick distance for a range: 1, 2 or 5 times a power of ten, for at most about twenty ticks. */
export function usualStep(span: number): number {
  if (!(span > 0) || !Number.isFinite(span)) return 1;
  const power = 10 ** Math.floor(Math.log10(span)), parts = 20 / (span / power);
  const shares: [number, number][] = [[40, 0.05], [20, 0.1], [10, 0.2], [4, 0.5], [2, 1], [0.5, 2]];
  return power * (shares.find(([least]) => parts > least)?.[1] ?? Math.ceil(span / power));
}

const most = 1000;

function ticksBetween(low: number, high: number, step: number): number[] {
  const [from, to] = low < high ? [low, high] : [high, low], near = 1e-9 * (to - from);
  const first = Math.ceil((from - near) / step), last = Math.floor((to + near) / step);
  if (!(last - first < most)) return [];
  return Array.from({length: Math.max(0, last - first + 1)}, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

const labelled = (values: readonly number[]): Tick[] => values.map((at) => ({at, label: numberText(at)}));

function decadeTicks(low: number, high: number, more: readonly number[]): {ticks: Tick[]; minor: number[]} {
  const [from, to] = [Math.log10(Math.min(low, high)), Math.log10(Math.max(low, high))];
  const step = Math.max(1, Math.round(usualStep(to - from)));
  const inside = (value: number) => value >= 10 ** from * (1 - 1e-9) && value <= 10 ** to * (1 + 1e-9);
  const powers = ticksBetween(from, to, step).map((power) => 10 ** power);
  const minor: number[] = [];
  for (let power = Math.floor(from); power <= Math.ceil(to); ++power)
    for (const digit of step === 1 ? [2, 3, 4, 5, 6, 7, 8, 9] : [1, 2, 5]) minor.push(digit * 10 ** power);
  return {ticks: labelled([...powers, ...more].filter(inside).sort((a, b) => a - b)), minor: minor.filter(inside)};
}

/** Returns the default range of an axis: its values, extended to ticks. */
function usualRange(axis: Axis, [low, high]: readonly [number, number]): [number, number] {
  if (!(low <= high)) return axis.log ? [1, 10] : [-10, 10];
  if (axis.log) return low > 0 ? [10 ** Math.floor(Math.log10(low) + 1e-9), 10 ** Math.ceil(Math.log10(high) - 1e-9)] : [1, 10];
  if (low === high) return low === 0 ? [-1, 1] : [low - 0.01 * Math.abs(low), high + 0.01 * Math.abs(high)];
  const step = axis.step ?? usualStep(high - low);
  return [step * Math.floor(low / step + 1e-9), step * Math.ceil(high / step - 1e-9)];
}

function linearTicks(axis: Axis, low: number, high: number): Tick[] {
  const between = (at: number) => at >= Math.min(low, high) - 1e-9 * Math.abs(high - low) && at <= Math.max(low, high) + 1e-9 * Math.abs(high - low);
  if (axis.named_ticks) return axis.named_ticks.map(({at = 0, label = ""}) => ({at, label})).filter(({at}) => between(at));
  if (axis.line === false) return [];
  return labelled(ticksBetween(low, high, axis.step ?? usualStep(Math.abs(high - low))));
}

/** Returns the scale of an axis; `extent` is the range of the marks along it. */
export function scaleOf(axis: Axis, extent: readonly [number, number]): Scale {
  const [low, high] = axis.range ?? usualRange(axis, extent);
  const log = axis.log === true && low > 0 && high > 0;
  const {ticks, minor} = log && !axis.named_ticks ? decadeTicks(low, high, axis.more_ticks ?? []) : {ticks: linearTicks(axis, low, high), minor: []};
  const place = log ? Math.log10 : (value: number) => value, from = place(low), span = place(high) - from || 1;
  const share = (value: number | null | undefined) =>
    value === null || value === undefined || (log && value <= 0) ? Number.NaN : (place(value) - from) / span;
  return {axis, low, high, ticks, minor, label: labelOf(axis), share};
}
