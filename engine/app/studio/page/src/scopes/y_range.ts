/** Time for which an extent is kept before the range shrinks [s], and the share of the range above which it does not shrink. */
export const patience = 2;
const worthIt = 0.85;
/** Margin above and below, as a share of the data's range. */
const margin = 0.06;
/** Smallest automatic range as a share of the magnitude: labels could not distinguish less, and it would show rounding errors. */
const leastSpan = 1e-4;

export interface Range {
  low: number;
  high: number;
}

const width = ({low, high}: Range) => high - low;

/** Adds a margin to a range. For a constant it is proportional to the magnitude; for 0 it is `one`. */
export function padded({low, high}: Range, one = 1): Range {
  const span = high - low;
  const size = Math.max(Math.abs(low), Math.abs(high)), least = leastSpan * size;
  const room = span === 0 ? size * 0.1 || one : Math.max(span * margin, (least - span) / 2);
  return {low: low - room, high: high + room};
}

export function joined(a: Range | undefined, b: Range): Range {
  return a ? {low: Math.min(a.low, b.low), high: Math.max(a.high, b.high)} : b;
}

/** Range of an axis: grows at once, and shrinks after the data have needed less for two seconds. Instants in seconds of the page's clock. */
export class YRange {
  private recent: {at: number; data: Range}[] = [];
  private shown: Range | undefined;
  private own: Range | undefined;

  /** `one`: SI value of 1 in the display unit. */
  constructor(private readonly one = 1) {}

  /** Adds the visible data; returns the range to show. */
  update(data: Range | undefined, at: number): Range {
    if (this.own) return this.own;
    if (data) this.remember(data, at);
    const needed = this.recent.reduce<Range | undefined>((all, one) => joined(all, one.data), undefined);
    if (needed) this.follow(needed);
    return this.shown ?? {low: 0, high: 1};
  }

  /** Fixes the range until `fit`. */
  choose(range: Range): void {
    if (width(range) > 0 && Number.isFinite(width(range))) this.own = range;
  }

  /** Fits the range to the data at once. */
  fit(): void {
    this.own = undefined;
    this.shown = undefined;
    this.recent = this.recent.slice(-1);
  }

  get isChosen(): boolean {
    return this.own !== undefined;
  }

  get now(): Range {
    return this.own ?? this.shown ?? {low: 0, high: 1};
  }

  private remember(data: Range, at: number): void {
    this.recent = this.recent.filter((one) => at - one.at <= patience);
    const last = this.recent.at(-1);
    if (last && last.data.low === data.low && last.data.high === data.high) last.at = at;
    else this.recent.push({at, data});
  }

  private follow(needed: Range): void {
    const meant = padded(needed, this.one), shown = this.shown;
    if (!shown) this.shown = meant;
    else if (needed.low < shown.low || needed.high > shown.high) this.shown = joined(shown, meant);
    else if (width(meant) < worthIt * width(shown)) this.shown = meant;
  }
}
