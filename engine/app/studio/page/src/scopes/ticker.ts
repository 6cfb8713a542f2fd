/** Refresh rate with reduced motion [1/s], and delay of the final picture after the last change [s]. */
const stillRate = 4, afterglow = 2.2;

/** Scheduler of pictures. While time advances it draws at each screen refresh, otherwise on request, and once more later, as axes may have shrunk. */
export class Ticker {
  private frame = 0;
  private timer: number | undefined;
  private last = 0;

  constructor(private readonly moves: () => boolean, private readonly draw: (at: number, isLast: boolean) => void, private readonly isStill: () => boolean) {}

  request(): void {
    if (this.frame === 0) this.frame = requestAnimationFrame((ms) => this.run(ms / 1000));
  }

  stop(): void {
    cancelAnimationFrame(this.frame);
    clearTimeout(this.timer);
    this.frame = 0;
  }

  private run(at: number): void {
    this.frame = 0;
    if (this.isStill() && this.moves() && at - this.last < 1 / stillRate) return this.request();
    this.last = at;
    this.draw(at, false);
    clearTimeout(this.timer);
    if (this.moves()) this.request();
    else this.timer = window.setTimeout(() => this.settle(), afterglow * 1000);
  }

  /** Draws the final picture. */
  private settle(): void {
    requestAnimationFrame((ms) => this.draw(ms / 1000, true));
  }
}
