import type {Connection} from "../connection/connection";

/** Calls at once; ms between later ones, and between those of a page that holds an input. */
const first = 5, pause = 5000, held = 100;

/**
 * Tells the server the page's clock again and again, so that samples act at their own time although clocks differ and drift; and, while
 * `holds` says so, often enough that a real-time loop knows that the page is there and keeps what it holds.
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
