interface Waiting {
  sentAt: number;
  /** Time of the run at which the input acts [s]; undefined until the server has answered. */
  acts: number | undefined;
}

/** Number of samples for the median. */
const kept = 15;

/** Latency from an input at the page to the first picture with its effect. Instants in ms of the page's clock. */
export class Latency {
  private readonly waiting = new Set<Waiting>();
  private readonly samples: number[] = [];

  /** Records an input. The returned function sets the time of the run at which it acts [s]. */
  sent(at: number): (acts: number) => void {
    const input: Waiting = {sentAt: at, acts: undefined};
    this.waiting.add(input);
    return (acts) => void (input.acts = acts);
  }

  /** Records a picture that shows the run up to `newest` [s]. */
  drawn(newest: number, at: number): void {
    for (const input of this.waiting) {
      if (input.acts === undefined || newest < input.acts) continue;
      this.waiting.delete(input);
      this.measured(at - input.sentAt);
    }
  }

  /** Adds a latency that was measured elsewhere, such as that of a hand in the scene [ms]. */
  measured(duration: number): void {
    this.samples.push(duration);
    this.samples.splice(0, this.samples.length - kept);
  }

  /** Drops pending inputs, after a restart or a refusal. */
  forget(): void {
    this.waiting.clear();
  }

  /** Returns the median of the last inputs [ms]; undefined before the first. */
  get median(): number | undefined {
    const sorted = [...this.samples].sort((a, b) => a - b);
    return sorted[sorted.length >> 1];
  }
}
