import type {Frame} from "./frame";

/** State of one view: sequence numbers that are not acknowledged yet, and the timer of the pause. */
interface Paced {
  pause: number; // ms
  held: number[];
  timer: ReturnType<typeof setTimeout> | undefined;
}

/**
 * Acknowledgement of drawn frames. The server sends a view no third frame before the first one is acknowledged. A view with a minimum pause
 * between frames therefore delays its newest acknowledgement until the pause has passed.
 */
export class Acknowledgements {
  private readonly views = new Map<number, Paced>();

  constructor(private readonly send: (sequence: number) => void) {}

  /** Sets the pause of a view. A delayed acknowledgement is sent at once, so that the first frame of the new request does not wait. */
  pace(view: number, pause: number): void {
    const known = this.views.get(view);
    if (known) this.release(known, 0);
    if (pause === 0) this.views.delete(view);
    else if (known) known.pause = pause;
    else this.views.set(view, {pause, held: [], timer: undefined});
  }

  add({view, sequence}: Pick<Frame, "view" | "sequence">): void {
    const paced = this.views.get(view);
    if (!paced) return this.send(sequence);
    paced.held.push(sequence);
    paced.timer ??= setTimeout(() => this.release(paced, 1), paced.pause);
  }

  /** Drops all state after the connection was lost. */
  forget(): void {
    for (const paced of this.views.values()) {
      clearTimeout(paced.timer);
      [paced.held, paced.timer] = [[], undefined];
    }
  }

  private release(paced: Paced, kept: number): void {
    clearTimeout(paced.timer);
    paced.timer = undefined;
    for (const sequence of paced.held.splice(0, Math.max(0, paced.held.length - kept))) this.send(sequence);
  }
}
