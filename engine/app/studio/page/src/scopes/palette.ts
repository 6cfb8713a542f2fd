// Styles of traces. The six colours are the page's tokens --trace-1 to --trace-6, which are colour-blind-safe; further traces are dashed.

export interface TraceStyle {
  color: string;
  dash: number[];
}

export const colorCount = 6;
/** Maximum number of traces in a scope. */
export const mostTraces = 12;

const dash = [6, 4];

/** Returns the style of a trace by its number from 0. */
export function traceStyle(number: number, colors: string[]): TraceStyle {
  return {color: colors[number % colorCount], dash: number % mostTraces < colorCount ? [] : dash};
}

/** Returns the colours of the present theme. */
export const traceColors = (token: (name: string) => string): string[] =>
  Array.from({length: colorCount}, (_, i) => token(`--trace-${i + 1}`));

/** Returns the first free number; undefined if all are taken. */
export function freeNumber(taken: Iterable<number>): number | undefined {
  const used = new Set(taken);
  return Array.from({length: mostTraces}, (_, i) => i).find((i) => !used.has(i));
}
