/** How long the clock runs on without news of the run [s]. */
const longestGuess = 0.5;
/** An error beyond this many seconds of the clock is jumped over; a smaller one fades with `fade` [s]. */
const jump = 0.3, fade = 0.2;

/** The time of the run between two news of it, so that axes move evenly; all instants are seconds of the page's clock. */
export class RunClock {
  private time = 0;
  private at = 0;
  private shown = 0;
  private readAt = 0;
  private rate = 0;

  /** Whether it moves. */
  get moves(): boolean {
    return this.rate > 0;
  }

  /** The run is at `time`, and goes on with `rate` seconds in one of the clock; 0 while it stands. */
  observe(time: number, rate: number, at: number): void {
    this.time = time;
    this.at = at;
    this.rate = rate;
  }

  /** Another run begins at `time`. */
  restart(time: number, at: number): void {
    this.observe(time, this.rate, at);
    this.shown = time;
    this.readAt = at;
  }

  /** Time of the run at an instant not before the last; it never goes back by less than a jump. */
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
