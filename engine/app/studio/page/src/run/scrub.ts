import {h, listen} from "../shell/dom";
import type {RunModel} from "./run_model";

const parts = 1000;
/** A key press moves by this share. */
const keyShare = 0.01;

/** The time of the run as a slider: dragged back, the run returns to a snapshot and goes on from there. */
export class Scrub {
  readonly element = h("input", {type: "range", class: "scrub", min: 0, max: parts, step: 1, value: 0, "aria-label": "Time of the run", title: "Drag to go back; play goes on from there"});
  private isHeld = false;
  private due: number | undefined;
  private isBusy = false;

  constructor(private readonly run: RunModel) {
    listen(this.element, "input", () => this.moved());
    listen(this.element, "change", () => { this.isHeld = false; });
  }

  /** The run went on. */
  show(): void {
    if (this.isHeld || this.isBusy) return;
    const {time} = this.run.news, value = String(Math.round((time / this.end) * parts));
    if (this.element.value !== value) this.element.value = value;
    this.element.setAttribute("aria-valuetext", `${time.toFixed(3)} s`);
  }

  /** By a share of what was reached, from a key. */
  step(sign: 1 | -1): void {
    void this.seek(Math.min(this.reached, Math.max(0, this.run.news.time + sign * keyShare * this.end)));
  }

  /** The length of the slider [s]: the run's own, or what was reached of one without an end. */
  private get end(): number {
    return this.run.loaded?.stop ?? Math.max(this.reached, 1);
  }
  private get reached(): number {
    return Math.max(this.furthest, this.run.news.time);
  }
  private furthest = 0;

  /** Another diagram. */
  reset(): void {
    this.furthest = 0;
    this.show();
  }

  private moved(): void {
    this.isHeld = true;
    void this.seek((Number(this.element.value) / parts) * this.end);
  }

  /** One call at a time; of those that come meanwhile the last. */
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
