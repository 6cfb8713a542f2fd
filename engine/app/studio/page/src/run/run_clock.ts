/** Time for which the clock continues without news of the run [s]. */
const longestGuess = 0.5;
/** Error above which the clock jumps [s of the clock]; smaller errors decay with the time constant `fade` [s]. */
const jump = 0.3, fade = 0.2;

/** Time of the run, interpolated between its news so that axes move smoothly. All instants are seconds of the page's clock. */
export class RunClock {
  private time = 0;
  private at = 0;
  private shown = 0;
  private readAt = 0;
  private rate = 0;

  /** True while the time advances. */
  get moves(): boolean {
    return this.rate > 0;
  }

  /** Records news: the run is at `time` and advances by `rate` seconds per second of the clock; 0 while paused. */
  observe(time: number, rate: number, at: number): void {
    this.time = time;
    this.at = at;
    this.rate = rate;
  }

  /** Starts another run at `time`. */
  restart(time: number, at: number): void {
    this.observe(time, this.rate, at);
    this.shown = time;
    this.readAt = at;
  }

  /** Returns the time of the run at an instant, which must not be before the last one. It goes back only by jumps. */
  read(at: number): number {
    const passed = Math.max(0, at - this.readAt);
    this.readAt = at;
    if (this.rate === 0) return (this.shown = this.time);
    const meant = this.time + this.rate * Math.min(Math.max(0, at - this.at), longestGuess);
    const guess = this.shown + this.rate * passed, error = meant - guess;
    if (Math.abs(error) > jump * this.rate) return (this.shown = meant);
    return (this.shown = Math.max(this.shown, guess + error * (1 - Math.exp(-passed / fade))));
  }
}
