import type {Sample} from "./hand";
import type {SceneNews} from "./scene_info";

const kept = 31, mostSent = 2000;

/** Latency from a sample of the pointer to the first picture with its effect. Instants in s of the page's clock. */
export class HandLatency {
  private readonly durations: number[] = [];
  /** Instants of samples that were sent but not displayed yet. A picture may contain samples of another page. */
  private readonly waiting = new Set<number>();

  sent(samples: readonly Sample[]): void {
    for (const {time} of samples) this.waiting.add(time);
    for (const time of this.waiting) if (this.waiting.size > mostSent) this.waiting.delete(time);
  }

  /** Records a picture. Returns the latency of its newest sample [s]; undefined if it has no new one. */
  drawn({input}: SceneNews, at: number): number | undefined {
    if (input === undefined || input === null || !this.waiting.has(input)) return undefined;
    for (const time of this.waiting) if (time <= input) this.waiting.delete(time);
    this.durations.push(at - input);
    this.durations.splice(0, this.durations.length - kept);
    return at - input;
  }

  /** Returns the median of the last samples [s]; undefined before the first. */
  get median(): number | undefined {
    return [...this.durations].sort((a, b) => a - b)[this.durations.length >> 1];
  }
}
