import type {Connection} from "../connection/connection";

/** Number of immediate calls; pause between later ones, and between those of a page that holds an input [ms]. */
const first = 5, pause = 5000, held = 100;

/**
 * Synchronisation of the page's clock with the server, so that samples act at their own time although clocks differ and drift. While
 * `holds` is true, the calls are frequent enough that a real-time loop does not release the inputs of the page.
 */
export class ClockSync {
  private timer: number | undefined;
  private calledAt = -Infinity;
  private isBusy = false;
  private isOver = false;

  constructor(private readonly connection: Connection, private readonly holds: () => boolean) {
    void this.begin();
  }

  dispose(): void {
    this.isOver = true;
    clearInterval(this.timer);
  }

  private async begin(): Promise<void> {
    for (let i = 0; i < first && !this.isOver; ++i) await this.call();
    if (!this.isOver) this.timer = window.setInterval(() => this.look(), held);
  }

  private look(): void {
    if (!this.isBusy && (this.holds() || performance.now() - this.calledAt >= pause)) void this.call();
  }

  private async call(): Promise<void> {
    this.calledAt = performance.now();
    this.isBusy = true;
    await this.connection.call("clock", {page: this.calledAt / 1000}).catch(() => {});
    this.isBusy = false;
  }
}
