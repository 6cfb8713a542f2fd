import type {Range} from "./y_range";

/** The narrowest and the widest window [s]. */
const narrowest = 1e-6, widest = 1e6;
/** The longest pause between two frames [ms]. */
const longestPause = 100;

const bounded = (width: number) => Math.min(widest, Math.max(narrowest, width));

/** Which stretch of time a scope shows: the newest one, or one that was chosen. Times in s of the run. */
export class TimeWindow {
  private chosen: Range | undefined;

  /** `width`: of the newest stretch. */
  constructor(public width: number, private readonly changed: () => void = () => {}) {}

  get isFollowing(): boolean {
    return this.chosen === undefined;
  }

  /** What is shown while the run is at `newest`. A run that has just begun fills the window from its left. */
  at(newest: number): Range {
    if (this.chosen) return this.chosen;
    return {low: Math.max(0, newest - this.width), high: Math.max(this.width, newest)};
  }

  /** Between two frames [ms]: as long as time takes to move by a share of the window while the run goes at a rate, 0 for as fast as it goes. */
  framePause(share: number, rate: number): number {
    return this.isFollowing && rate > 0 ? Math.round(Math.min(longestPause, (1000 * share * this.width) / rate)) : 0;
  }

  /** Back to the newest; `width` where another one shall follow. */
  follow(width = this.width): void {
    this.width = bounded(width);
    this.chosen = undefined;
    this.changed();
  }

  /** Looks back at a stretch. */
  look(range: Range): void {
    const width = bounded(range.high - range.low), middle = (range.low + range.high) / 2;
    this.chosen = {low: middle - width / 2, high: middle + width / 2};
    this.changed();
  }

  /** Makes the stretch `factor` as wide; what is at `center` stays where it is. */
  zoom(factor: number, center: number, newest: number): void {
    const {low, high} = this.at(newest), kept = bounded((high - low) * factor) / (high - low);
    this.look({low: center - (center - low) * kept, high: center + (high - center) * kept});
  }

  /** Moves by a share of the width, later where positive. */
  pan(share: number, newest: number): void {
    const {low, high} = this.at(newest), by = share * (high - low);
    this.look({low: low + by, high: high + by});
  }

  /** What to keep of it: null for following. */
  get kept(): {width: number; from: number | null; to: number | null} {
    return {width: this.width, from: this.chosen?.low ?? null, to: this.chosen?.high ?? null};
  }
}
