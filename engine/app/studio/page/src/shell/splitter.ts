import {h, listen} from "./dom";
import type {Settings} from "./settings";

export interface SplitterOptions {
  name: string;
  label: string;
  /** Direction of movement. */
  axis: "x" | "y";
  /** True if the pane after the splitter has the size, false for the one before. */
  fromEnd?: boolean;
  /** Bounds of the pane's size, as shares of the panes' area. */
  least: number;
  most: number;
}

/** Splitter between panes, moved by dragging, arrows, Home and End. The size is a share of the area, stored in the settings. */
export class Splitter {
  readonly element: HTMLElement;
  private share: number | undefined;

  constructor(private readonly area: HTMLElement, private readonly options: SplitterOptions, private readonly settings: Settings) {
    const orientation = options.axis === "x" ? "vertical" : "horizontal";
    this.element = h("div", {
      class: `splitter splitter-${options.name}`, role: "separator", tabindex: 0, "aria-label": options.label, "aria-orientation": orientation,
      "aria-valuemin": Math.round(100 * options.least), "aria-valuemax": Math.round(100 * options.most),
    });
    listen(this.element, "pointerdown", (event: PointerEvent) => this.grab(event));
    listen(this.element, "keydown", (event: KeyboardEvent) => this.press(event));
    listen(this.element, "dblclick", () => this.forget());
    settings.on((key) => { if (key === this.key) this.show(settings.get<number | null>(this.key, null)); });
  }

  private get key(): string {
    return `size.${this.options.name}`;
  }

  private show(share: number | null): void {
    const {name, axis, least, most} = this.options, property = `--${name}-${axis === "x" ? "width" : "height"}`;
    this.share = share === null ? undefined : Math.min(most, Math.max(least, share));
    if (this.share === undefined) return void this.area.style.removeProperty(property);
    this.area.style.setProperty(property, `${(100 * this.share).toFixed(2)}%`);
    this.element.setAttribute("aria-valuenow", String(Math.round(100 * this.share)));
  }

  private put(share: number): void {
    this.settings.set(this.key, Math.min(this.options.most, Math.max(this.options.least, share)));
  }

  private forget(): void {
    this.settings.set(this.key, null);
  }

  private shareAt(event: PointerEvent): number {
    const {left, top, width, height} = this.area.getBoundingClientRect();
    const share = this.options.axis === "x" ? (event.clientX - left) / width : (event.clientY - top) / height;
    return this.options.fromEnd ? 1 - share : share;
  }

  private grab(event: PointerEvent): void {
    if (event.button !== 0) return;
    this.element.setPointerCapture(event.pointerId);
    this.element.classList.add("dragged");
    const ends = [
      listen(this.element, "pointermove", (moved: PointerEvent) => this.put(this.shareAt(moved))),
      listen(this.element, "lostpointercapture", () => {
        this.element.classList.remove("dragged");
        ends.forEach((end) => end());
      }),
    ];
  }

  /** Returns the present share; before the first change it is measured. */
  private now(): number {
    if (this.share !== undefined) return this.share;
    const own = this.element.getBoundingClientRect(), {left, top, width, height} = this.area.getBoundingClientRect();
    const share = this.options.axis === "x" ? (own.left - left) / width : (own.top - top) / height;
    return this.options.fromEnd ? 1 - share : share;
  }

  private press(event: KeyboardEvent): void {
    const [less, more] = this.options.axis === "x" ? ["ArrowLeft", "ArrowRight"] : ["ArrowUp", "ArrowDown"];
    const step = this.options.fromEnd ? -0.02 : 0.02;
    if (event.key === less) this.put(this.now() - step);
    else if (event.key === more) this.put(this.now() + step);
    else if (event.key === "Home") this.put(this.options.least);
    else if (event.key === "End") this.put(this.options.most);
    else return;
    event.preventDefault();
  }
}
