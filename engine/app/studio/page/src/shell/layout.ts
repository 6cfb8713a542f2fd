// Layout of the panes. Wide: text, drawing above tabs, tuning beside them. Medium: tuning is a tab. Narrow: each pane is a tab.

import {h, listen} from "./dom";
import type {View} from "./context";
import type {Settings} from "./settings";
import {Splitter} from "./splitter";

export interface Pane {
  id: string;
  title: string;
  /** True if the pane is hidden until it is offered. */
  isKept?: boolean;
  /** Creates the view when the pane is shown for the first time. */
  make(host: HTMLElement): Promise<View>;
}

type Size = "wide" | "medium" | "narrow";
const sizes: [Size, string][] = [["narrow", "(max-width: 719px)"], ["medium", "(max-width: 1199px)"]];

interface Placed extends Pane {
  section: HTMLElement;
  tab: HTMLButtonElement;
  view?: Promise<View>;
}

export class Layout {
  readonly element = h("main", {class: "panes"});
  private readonly tabs = h("div", {class: "tabs", role: "tablist", "aria-label": "Panes"});
  private readonly panes: Placed[];
  private size: Size = "wide";
  private front: string;

  constructor(panes: Pane[], private readonly settings: Settings) {
    this.panes = panes.map((pane) => this.place(pane));
    const kept = settings.get("pane", "scopes");
    this.front = panes.some(({id, isKept}) => id === kept && !isKept) ? kept : "scopes";
    this.element.append(...this.panes.map(({section}) => section), this.tabs, ...this.splitters());
    this.tabs.append(...this.panes.map(({tab}) => tab));
    listen(this.tabs, "keydown", (event: KeyboardEvent) => this.press(event));
    settings.on((key) => { if (key === "pane") this.restore(); });
    for (const [, query] of sizes) matchMedia(query).addEventListener("change", () => this.measure());
    this.measure();
  }

  /** Brings a pane to the front; with `focus` it also gets the focus. */
  show(id: string, focus = false): void {
    const pane = this.panes.find((one) => one.id === id);
    if (!pane || pane.isKept) return;
    if (this.isTab(id)) {
      this.front = id;
      this.settings.set("pane", id);
    }
    this.update();
    if (focus) this.focus(pane);
  }

  /** Makes a hidden pane available and brings it to the front. */
  offer(id: string): void {
    const pane = this.panes.find((one) => one.id === id);
    if (!pane) return;
    pane.isKept = false;
    this.show(id);
  }

  /** Moves the focus to the next or previous visible pane. */
  cycle(step: number): void {
    const seen = this.panes.filter(({section}) => !section.hidden);
    const now = seen.findIndex(({section}) => section.contains(document.activeElement));
    this.focus(seen[(now + step + seen.length) % seen.length]);
  }

  private place(pane: Pane): Placed {
    const isLower = !["text", "drawing", "tuning"].includes(pane.id);
    const section = h("section", {class: `pane pane-${pane.id}${isLower ? " pane-lower" : ""}`, id: `pane-${pane.id}`, "aria-label": pane.title, tabindex: -1});
    const tab = h("button", {class: "tab", role: "tab", type: "button", id: `tab-${pane.id}`, "aria-controls": `pane-${pane.id}`, onclick: () => this.show(pane.id)}, pane.title);
    return {...pane, section, tab};
  }

  private splitters(): HTMLElement[] {
    const bar = (name: string, label: string, axis: "x" | "y", least: number, most: number, fromEnd = false) =>
      new Splitter(this.element, {name, label, axis, least, most, fromEnd}, this.settings).element;
    return [bar("text", "Width of the text", "x", 0.15, 0.75), bar("drawing", "Height of the drawing", "y", 0.1, 0.85),
      bar("tuning", "Width of tuning", "x", 0.12, 0.4, true)];
  }

  private isTab(id: string): boolean {
    if (this.size === "narrow") return true;
    return id !== "text" && id !== "drawing" && (id !== "tuning" || this.size === "medium");
  }

  private canBeFront(id: string): boolean {
    return this.panes.some((pane) => pane.id === id && !pane.isKept) && this.isTab(id);
  }

  private measure(): void {
    this.size = sizes.find(([, query]) => matchMedia(query).matches)?.[0] ?? "wide";
    document.body.dataset.layout = this.size;
    if (!this.canBeFront(this.front)) this.front = "scopes";
    this.update();
  }

  private restore(): void {
    const kept = this.settings.get("pane", "scopes");
    if (kept === this.front || !this.canBeFront(kept)) return;
    this.front = kept;
    this.update();
  }

  private update(): void {
    for (const pane of this.panes) {
      const asTab = this.isTab(pane.id), isShown = !asTab || pane.id === this.front, was = !pane.section.hidden;
      pane.tab.hidden = !asTab || pane.isKept === true;
      pane.tab.setAttribute("aria-selected", String(asTab && isShown));
      pane.tab.tabIndex = pane.id === this.front ? 0 : -1;
      pane.section.hidden = !isShown;
      if (asTab) pane.section.setAttribute("role", "tabpanel");
      else pane.section.removeAttribute("role");
      if (isShown) this.fill(pane);
      if (isShown !== was) void pane.view?.then((view) => view.shown?.(isShown));
    }
  }

  private fill(pane: Placed): void {
    if (pane.view) return;
    const host = h("div", {class: "view"});
    pane.section.append(host);
    pane.view = pane.make(host);
    pane.view.catch((thrown) => host.append(h("p", {class: "empty"}, `${pane.title} cannot be shown: ${thrown?.message ?? thrown}`)));
  }

  /** Focuses the element marked for it, else the first focusable one. A view that is still loading gets the focus later. */
  private focus({section, view}: Placed): void {
    const first = (selector: string) => [...section.querySelectorAll<HTMLElement>(selector)].find((one) => one.checkVisibility({visibilityProperty: true}) && !one.matches(":disabled"));
    const inside = first("[data-focus]") ?? first(".cm-content") ?? first("[tabindex='0']") ?? first("button, input, select");
    (inside ?? section).focus();
    if (!inside) void view?.then(() => { if (document.activeElement === section && first("*")) this.focus({section} as Placed); });
  }

  private press(event: KeyboardEvent): void {
    const seen = this.panes.filter(({tab}) => !tab.hidden), now = seen.findIndex(({id}) => id === this.front);
    const steps: Record<string, number> = {ArrowLeft: now - 1, ArrowRight: now + 1, Home: 0, End: seen.length - 1};
    if (!(event.key in steps)) return;
    event.preventDefault();
    const next = seen[(steps[event.key] + seen.length) % seen.length];
    this.show(next.id);
    next.tab.focus();
  }
}
