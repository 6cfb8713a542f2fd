import {h, listen} from "../shell/dom";
import type {RunModel} from "./run_model";

const parts = 1000;
/** Share of the slider by which a key press moves. */
const keyShare = 0.01;

/** Slider of the time of the run. Dragging it back returns the run to a checkpoint, from which it can continue. */
export class Scrub {
  readonly element = h("input", {type: "range", class: "scrub", min: 0, max: parts, step: 1, value: 0, "aria-label": "Time of the run", title: "Drag to go back; Play continues from there"});
  private isHeld = false;
  private due: number | undefined;
  private isBusy = false;

  constructor(private readonly run: RunModel) {
    listen(this.element, "input", () => this.moved());
    listen(this.element, "change", () => { this.isHeld = false; });
  }

  /** Shows the present time of the run. */
  show(): void {
    if (this.isHeld || this.isBusy) return;
    const {time} = this.run.news, value = String(Math.round((time / this.end) * parts));
    if (this.element.value !== value) this.element.value = value;
    this.element.setAttribute("aria-valuetext", `${time.toFixed(3)} s`);
  }

  /** Moves by a share of the slider, for a key press. */
  step(sign: 1 | -1): void {
    void this.seek(Math.min(this.reached, Math.max(0, this.run.news.time + sign * keyShare * this.end)));
  }

  /** Length of the slider [s]: the stop time of the run, or the furthest time reached if it has none. */
  private get end(): number {
    return this.run.loaded?.stop ?? Math.max(this.reached, 1);
  }
  private get reached(): number {
    return Math.max(this.furthest, this.run.news.time);
  }
  private furthest = 0;

  /** Resets the slider for another diagram. */
  reset(): void {
    this.furthest = 0;
    this.show();
  }

  private moved(): void {
    this.isHeld = true;
    void this.seek((Number(this.element.value) / parts) * this.end);
  }

  /** Seeks with one call at a time; only the last pending one follows. */
  private async seek(time: number): Promise<void> {
    this.furthest = this.reached;
    this.due = time;
    if (this.isBusy) return;
    this.isBusy = true;
    while (this.due !== undefined) {
      const next: number = this.due;
      this.due = undefined;
      await this.run.seek(next);
    }
    this.isBusy = false;
    this.show();
  }
}
