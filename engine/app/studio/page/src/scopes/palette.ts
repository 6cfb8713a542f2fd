// How traces look. The colours are the page's tokens --trace-1 to --trace-6, which who confuses red and green, or sees no blue, tells
// apart; from the seventh on they are dashed.

export interface TraceStyle {
  color: string;
  dash: number[];
}

export const colorCount = 6;
/** A scope has no more traces. */
export const mostTraces = 12;

const dash = [6, 4];

/** The style of the trace with this number, from 0. */
export function traceStyle(number: number, colors: string[]): TraceStyle {
  return {color: colors[number % colorCount], dash: number % mostTraces < colorCount ? [] : dash};
}

/** The colours of the theme now. */
export const traceColors = (token: (name: string) => string): string[] =>
  Array.from({length: colorCount}, (_, i) => token(`--trace-${i + 1}`));

/** The first number that no trace has; undefined where all have one. */
export function freeNumber(taken: Iterable<number>): number | undefined {
  const used = new Set(taken);
  return Array.from({length: mostTraces}, (_, i) => i).find((i) => !used.has(i));
}
