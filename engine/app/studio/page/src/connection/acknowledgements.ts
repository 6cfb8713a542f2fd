import type {Frame} from "./frame";

/** Of one view: sequences that the server still waits for, and since when the timer runs. */
interface Paced {
  pause: number; // ms
  held: number[];
  timer: ReturnType<typeof setTimeout> | undefined;
}

/**
 * When the server hears that a frame was drawn. It sends a view no third frame before; so a view that is to have one frame in each pause
 * holds back the newest acknowledgement, and sends the one before when the pause is over.
 */
export class Acknowledgements {
  private readonly views = new Map<number, Paced>();

  constructor(private readonly send: (sequence: number) => void) {}

  /** Another wish for a view: what is held back goes at once, so that its first frame does not wait. */
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

  /** The connection was lost. */
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
