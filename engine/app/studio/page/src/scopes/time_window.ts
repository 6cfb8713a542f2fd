import type {Range} from "./y_range";

/** Minimum and maximum width of a window [s]. */
const narrowest = 1e-6, widest = 1e6;
/** Maximum pause between two frames [ms]. */
const longestPause = 100;

const bounded = (width: number) => Math.min(widest, Math.max(narrowest, width));

/** Time window of a scope: the newest data, or a selected interval. Times in s of the run. */
export class TimeWindow {
  private chosen: Range | undefined;

  /** `width`: of the window that follows the newest data. */
  constructor(public width: number, private readonly changed: () => void = () => {}) {}

  get isFollowing(): boolean {
    return this.chosen === undefined;
  }

  /** Returns the interval shown when the run is at `newest`. A new run fills the window from its left. */
  at(newest: number): Range {
    if (this.chosen) return this.chosen;
    return {low: Math.max(0, newest - this.width), high: Math.max(this.width, newest)};
  }

  /** Returns the pause between frames [ms]: the time in which the window moves by a share of its width at a rate (0: as fast as possible). */
  framePause(share: number, rate: number): number {
    return this.isFollowing && rate > 0 ? Math.round(Math.min(longestPause, (1000 * share * this.width) / rate)) : 0;
  }

  /** Follows the newest data again, optionally with a new width. */
  follow(width = this.width): void {
    this.width = bounded(width);
    this.chosen = undefined;
    this.changed();
  }

  /** Shows a fixed interval. */
  look(range: Range): void {
    const width = bounded(range.high - range.low), middle = (range.low + range.high) / 2;
    this.chosen = {low: middle - width / 2, high: middle + width / 2};
    this.changed();
  }

  /** Multiplies the width by `factor`; `center` keeps its position. */
  zoom(factor: number, center: number, newest: number): void {
    const {low, high} = this.at(newest), kept = bounded((high - low) * factor) / (high - low);
    this.look({low: center - (center - low) * kept, high: center + (high - center) * kept});
  }

  /** Pans by a share of the width; later if positive. */
  pan(share: number, newest: number): void {
    const {low, high} = this.at(newest), by = share * (high - low);
    this.look({low: low + by, high: high + by});
  }

  /** State to store; `from` and `to` are null while following. */
  get kept(): {width: number; from: number | null; to: number | null} {
    return {width: this.width, from: this.chosen?.low ?? null, to: this.chosen?.high ?? null};
  }
}
