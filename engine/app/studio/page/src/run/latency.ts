interface Waiting {
  sentAt: number;
  /** Time of the run at which it acts [s]; unknown until the server says so. */
  acts: number | undefined;
}

/** Samples of which the middle is shown. */
const kept = 15;

/** How long it takes from an input at the page to the first picture that shows it; instants in ms of the page's clock. */
export class Latency {
  private readonly waiting = new Set<Waiting>();
  private readonly samples: number[] = [];

  /** An input leaves the page; the function that comes back is called with the time of the run at which it acts [s]. */
  sent(at: number): (acts: number) => void {
    const input: Waiting = {sentAt: at, acts: undefined};
    this.waiting.add(input);
    return (acts) => void (input.acts = acts);
  }

  /** A picture that shows the run up to `newest` [s] is on its way to the screen. */
  drawn(newest: number, at: number): void {
    for (const input of this.waiting) {
      if (input.acts === undefined || newest < input.acts) continue;
      this.waiting.delete(input);
      this.measured(at - input.sentAt);
    }
  }

  /** Takes in what was measured elsewhere, such as of a hand in the scene [ms]. */
  measured(duration: number): void {
    this.samples.push(duration);
    this.samples.splice(0, this.samples.length - kept);
  }

  /** What was waited for does not come: another run began, or the input was refused. */
  forget(): void {
    this.waiting.clear();
  }

  /** Median of the last inputs [ms]; undefined before the first. */
  get median(): number | undefined {
    const sorted = [...this.samples].sort((a, b) => a - b);
    return sorted[sorted.length >> 1];
  }
}
