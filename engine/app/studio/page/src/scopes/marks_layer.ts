import {h} from "../shell/dom";
import type {Cursors} from "./cursors";
import type {Range} from "./y_range";

/** Space for the letter of a cursor [px]; at the right end the letter is on the other side. */
const letter = 18;

/** Layer over the plot of a scope with cursors, pointer line and zoom rectangle. Its elements move without redrawing. */
export class MarksLayer {
  private readonly a = h("div", {class: "mark mark-a", hidden: true, "aria-hidden": "true"}, h("span", {}, "A"));
  private readonly b = h("div", {class: "mark mark-b", hidden: true, "aria-hidden": "true"}, h("span", {}, "B"));
  private readonly hair = h("div", {class: "mark hair", hidden: true, "aria-hidden": "true"});
  private readonly chosen = h("div", {class: "chosen", hidden: true, "aria-hidden": "true"});
  private window: Range = {low: 0, high: 1};
  /** Width of the plot [px], from its axes; reading it from the page would force a layout. */
  width = 1;

  constructor(over: HTMLElement) {
    over.append(this.chosen, this.hair, this.a, this.b);
  }

  timeAt(x: number): number {
    return this.window.low + (x / this.width) * (this.window.high - this.window.low);
  }

  xOf(time: number): number {
    return ((time - this.window.low) / (this.window.high - this.window.low)) * this.width;
  }

  /** Returns the cursor within reach of a position [px]. */
  markAt(x: number, cursors: Cursors): "a" | "b" | undefined {
    const near = (time: number | undefined) => time !== undefined && Math.abs(this.xOf(time) - x) < 6;
    return near(cursors.b) ? "b" : near(cursors.a) ? "a" : undefined;
  }

  place(window: Range, width: number, {a, b}: Cursors, hover: number | undefined): void {
    this.window = window;
    this.width = width;
    this.put(this.a, a);
    this.put(this.b, b);
    this.put(this.hair, hover);
  }

  /** Shows the rectangle between two positions [px], or hides it. */
  choose(from?: number, to?: number): void {
    this.chosen.hidden = from === undefined || to === undefined;
    if (from === undefined || to === undefined) return;
    this.chosen.style.setProperty("left", `${Math.min(from, to)}px`);
    this.chosen.style.setProperty("width", `${Math.abs(to - from)}px`);
  }

  private put(mark: HTMLElement, time: number | undefined): void {
    const x = time === undefined ? -1 : this.xOf(time), isSeen = x >= 0 && x <= this.width;
    if (mark.hidden === isSeen) mark.hidden = !isSeen;
    if (!isSeen) return;
    mark.classList.toggle("turned", x > this.width - letter);
    mark.style.setProperty("transform", `translateX(${Math.min(x, this.width - 1.5).toFixed(1)}px)`);
  }
}
