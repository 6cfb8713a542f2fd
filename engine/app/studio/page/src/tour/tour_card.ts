import type {Context} from "../shell/context";
import {h, listen} from "../shell/dom";
import type {Stop} from "./stops";

const gap = 10; // px between the target and its card

/** Card beside its target. It covers nothing else and does not block clicks on the page; Esc or its cross ends the tour. */
export class TourCard {
  private readonly ring = h("div", {class: "tour-ring", "aria-hidden": true});
  private readonly title = h("h2", {id: "tour-title"});
  private readonly text = h("p", {id: "tour-text"});
  private readonly count = h("span", {class: "tour-count"});
  private readonly back = h("button", {type: "button", onclick: () => this.show(this.index - 1)}, "Back");
  private readonly next = h("button", {type: "button", class: "main", onclick: () => this.show(this.index + 1)}, "Next");
  private readonly card = h("section", {class: "tour-card", role: "dialog", "aria-labelledby": "tour-title", "aria-describedby": "tour-text", tabindex: -1},
    h("button", {type: "button", class: "plain tour-close", "aria-label": "End the tour", onclick: () => this.close()}, "×"), this.title, this.text,
    h("div", {class: "tour-foot"}, this.count, this.back, this.next));
  private readonly before = document.activeElement;
  private readonly ends: (() => void)[];
  private index = 0;

  constructor(private readonly context: Context, private readonly stops: readonly Stop[]) {
    document.querySelectorAll(".tour-card, .tour-ring").forEach((old) => old.remove());
    document.body.append(this.ring, this.card);
    this.ends = [listen(this.card, "keydown", (event: KeyboardEvent) => this.press(event)), listen(window, "resize", () => this.place())];
  }

  show(index: number): void {
    if (index < 0) return;
    const stop = this.stops[index];
    if (!stop) return this.close();
    this.index = index;
    if (stop.pane) this.context.show(stop.pane);
    this.title.textContent = stop.title;
    this.text.textContent = stop.text;
    this.count.textContent = `${index + 1} of ${this.stops.length}`;
    this.back.disabled = index === 0;
    this.next.textContent = index + 1 === this.stops.length ? "Done" : "Next";
    this.place();
    requestAnimationFrame(() => this.place());
    this.next.focus();
    this.context.announce(`${stop.title}. ${stop.text}`);
  }

  private close(): void {
    for (const end of this.ends) end();
    this.ring.remove();
    this.card.remove();
    if (this.before instanceof HTMLElement) this.before.focus();
  }

  private press(event: KeyboardEvent): void {
    const action = {Escape: () => this.close(), ArrowRight: () => this.show(this.index + 1), ArrowLeft: () => this.show(this.index - 1)}[event.key];
    if (!action) return;
    event.preventDefault();
    event.stopPropagation();
    action();
  }

  /** Places the card beside the target if there is space, else over its lower end. */
  private place(): void {
    const target = document.querySelector(this.stops[this.index].target), box = target?.getBoundingClientRect();
    const {offsetWidth: width, offsetHeight: height} = this.card, {innerWidth, innerHeight} = window;
    this.ring.hidden = !box || box.width === 0;
    const {left, top, right, bottom} = box && box.width > 0 ? box : new DOMRect(0.5 * innerWidth, 0.4 * innerHeight, 0, 0);
    const inside = (value: number, size: number, room: number) => Math.max(gap, Math.min(value, room - size - gap));
    const isBeside = right + gap + width <= innerWidth, isBefore = left - gap - width >= 0, isBelow = bottom + gap + height <= innerHeight, isAbove = top - gap - height >= 0;
    const x = isBelow || isAbove ? inside(left, width, innerWidth) : isBeside ? right + gap : isBefore ? left - gap - width : inside(0.5 * (left + right - width), width, innerWidth);
    const y = isBelow ? bottom + gap : isAbove ? top - gap - height : isBeside || isBefore ? inside(top + gap, height, innerHeight) : inside(bottom - height - gap, height, innerHeight);
    this.put(this.card, {left: x, top: y});
    this.put(this.ring, {left: left - 2, top: top - 2, width: right - left + 4, height: bottom - top + 4});
  }

  private put(element: HTMLElement, sizes: Record<string, number>): void {
    for (const [name, value] of Object.entries(sizes)) element.style.setProperty(name, `${Math.round(value)}px`);
  }
}
