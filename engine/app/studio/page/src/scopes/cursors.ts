/** Two time cursors over all scopes [s of the run]; `b` exists only together with `a`. */
export class Cursors {
  a: number | undefined;
  b: number | undefined;

  constructor(private readonly changed: () => void = () => {}) {}

  /** Sets a cursor to the nearest tick. */
  put(mark: "a" | "b", time: number, step: number): void {
    const snapped = step > 0 ? Math.round(time / step) * step : time;
    if (mark === "b" && this.a === undefined) this.a = snapped;
    else this[mark] = snapped;
    this.changed();
  }

  /** Moves a cursor by a time; a missing cursor starts at `otherwise`. */
  move(mark: "a" | "b", by: number, step: number, otherwise: number): void {
    this.put(mark, (this[mark] ?? otherwise) + by, step);
  }

  clear(): void {
    this.a = this.b = undefined;
    this.changed();
  }

  /** Returns the interval between the cursors; of a single cursor that instant. */
  get stretch(): {low: number; high: number} | undefined {
    if (this.a === undefined) return undefined;
    const b = this.b ?? this.a;
    return {low: Math.min(this.a, b), high: Math.max(this.a, b)};
  }

  /** Returns the signed distance from A to B [s]; undefined without both. */
  get distance(): number | undefined {
    return this.a === undefined || this.b === undefined ? undefined : this.b - this.a;
  }
}
