// What the server says of a real-time loop (protocol, "A real-time loop"). Times in s.

/** Bins of a fourth of an octave; one edge more than counts. */
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
  /** Deadlines that were served. */
  served: number;
  /** late + dropped */
  missed: number;
  late: number;
  dropped: number;
  /** The longest row of misses. */
  longest: number;
  /** How late the thread woke. */
  lateness: Histogram;
  /** Until outputs were written. */
  response: Histogram;
  /** All of a wake-up. */
  step: Histogram;
  /** The dearest first. */
  costs: {type: string; blocks: string[] | number; mean: number}[];
  /** Ticks that did not come to the page. */
  lost: number;
  policy: string;
  refused: string[];
}

/** A time with three digits in the unit that suits it. */
export function timeText(seconds: number): string {
  const [scale, unit] = seconds >= 1 ? [1, "s"] : seconds >= 1e-3 ? [1e3, "ms"] : seconds >= 1e-6 ? [1e6, "µs"] : [1e9, "ns"];
  return `${Number((seconds * scale).toPrecision(3))} ${unit}`;
}
