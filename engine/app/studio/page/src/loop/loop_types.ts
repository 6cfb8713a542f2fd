// Types of the protocol section "A real-time loop". Times in s.

/** Histogram with bins of a quarter octave; there is one edge more than counts. */
export interface Histogram {
  count: number;
  p50: number;
  p99: number;
  p999: number;
  max: number;
  edges: number[];
  counts: number[];
}

export interface LoopNews {
  run: number;
  period: number;
  /** Number of executed steps. */
  served: number;
  /** late + dropped */
  missed: number;
  late: number;
  dropped: number;
  /** Longest run of successive misses. */
  longest: number;
  /** Delay of the wake-up. */
  lateness: Histogram;
  /** Time until outputs are written. */
  response: Histogram;
  /** Duration of a whole wake-up. */
  step: Histogram;
  /** Cost by block type, most expensive first. */
  costs: {type: string; blocks: string[] | number; mean: number}[];
  /** Ticks that were lost on the way to the page. */
  lost: number;
  policy: string;
  refused: string[];
}

/** Formats a time with three digits in a suitable unit. */
export function timeText(seconds: number): string {
  const [scale, unit] = seconds >= 1 ? [1, "s"] : seconds >= 1e-3 ? [1e3, "ms"] : seconds >= 1e-6 ? [1e6, "µs"] : [1e9, "ns"];
  return `${Number((seconds * scale).toPrecision(3))} ${unit}`;
}
