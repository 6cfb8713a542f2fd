import type {Connection} from "../connection/connection";

const first = 5, pause = 5000; // calls at once, and ms between later ones

/** Tells the server the page's clock again and again, so that samples act at their own time although clocks differ and drift. */
export class ClockSync {
  private timer: number | undefined;
  private isOver = false;

  constructor(private readonly connection: Connection) {
    void this.begin();
  }

  dispose(): void {
    this.isOver = true;
    clearTimeout(this.timer);
  }

  private async begin(): Promise<void> {
    for (let i = 0; i < first && !this.isOver; ++i) await this.call();
    this.later();
  }

  private later(): void {
    if (this.isOver) return;
    this.timer = window.setTimeout(() => void this.call().then(() => this.later()), pause);
  }

  private async call(): Promise<void> {
    await this.connection.call("clock", {page: performance.now() / 1000}).catch(() => {});
  }
}
