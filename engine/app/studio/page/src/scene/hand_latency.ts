import type {Sample} from "./hand";
import type {SceneNews} from "./scene_info";

const kept = 31;

/** How long it takes from a sample of the pointer to the first picture in which it acts; instants in s of the page's clock. */
export class HandLatency {
  private readonly samples: number[] = [];
  private newestSent = -Infinity;
  private newestDrawn = -Infinity;

  sent(samples: readonly Sample[]): void {
    this.newestSent = samples[samples.length - 1]?.time ?? this.newestSent;
  }

  /** A picture is on its way to the screen. Returns how long its newest sample took [s]; undefined where it has none that is new. */
  drawn({input}: SceneNews, at: number): number | undefined {
    if (input === undefined || input === null || input <= this.newestDrawn || input > this.newestSent) return undefined;
    this.newestDrawn = input;
    this.samples.push(at - input);
    this.samples.splice(0, this.samples.length - kept);
    return at - input;
  }

  /** Median of the last samples [s]; undefined before the first. */
  get median(): number | undefined {
    return [...this.samples].sort((a, b) => a - b)[this.samples.length >> 1];
  }
}
