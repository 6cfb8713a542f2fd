/** How long an extent is held before the range shrinks [s]. It shrinks to at most this share of itself, or not at all. */
export const patience = 2;
const worthIt = 0.85;
/** Free above and below, as a share of what data take. */
const margin = 0.06;
/** Less is not resolved without being asked for, as a share of the magnitude: labels would not tell it apart, and rounding is no signal. */
const leastSpan = 1e-4;

export interface Range {
  low: number;
  high: number;
}

const width = ({low, high}: Range) => high - low;

/** A range with room above and below; a constant gets room in proportion to itself, and 0 that of `one`. */
export function padded({low, high}: Range, one = 1): Range {
  const span = high - low;
  const size = Math.max(Math.abs(low), Math.abs(high)), least = leastSpan * size;
  const room = span === 0 ? size * 0.1 || one : Math.max(span * margin, (least - span) / 2);
  return {low: low - room, high: high + room};
}

export function joined(a: Range | undefined, b: Range): Range {
  return a ? {low: Math.min(a.low, b.low), high: Math.max(a.high, b.high)} : b;
}

/** The range of an axis: grows at once, shrinks when data have needed less for two seconds. Instants in seconds of the page's clock. */
export class YRange {
  private recent: {at: number; data: Range}[] = [];
  private shown: Range | undefined;
  private own: Range | undefined;

  /** `one`: what is 1 in the shown unit. */
  constructor(private readonly one = 1) {}

  /** The data now visible. Returns what to show. */
  update(data: Range | undefined, at: number): Range {
    if (this.own) return this.own;
    if (data) this.remember(data, at);
    const needed = this.recent.reduce<Range | undefined>((all, one) => joined(all, one.data), undefined);
    if (needed) this.follow(needed);
    return this.shown ?? {low: 0, high: 1};
  }

  /** Chosen by hand; stays until `fit`. */
  choose(range: Range): void {
    if (width(range) > 0 && Number.isFinite(width(range))) this.own = range;
  }

  /** Fits to data again, at once. */
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
