import type {Fault} from "../connection/connection";
import type {Context, View} from "../shell/context";
import {openDialog} from "../shell/dialog";
import {h} from "../shell/dom";
import {FigureElement} from "./figure_element";
import type {Figure} from "./spec";
import "./figures.css";

const soonest = 250; // ms between two drawings while the run is playing
const around = 34; // px beside a figure
const share = 5; // a drawing uses at most one fifth of the time

/** Figures of the file from the records so far; they grow during the run. */
export class FiguresView implements View {
  private readonly list = h("div", {class: "figure-list"});
  private readonly note = h("p", {class: "empty"});
  private readonly root = h("div", {class: "figures", tabindex: 0, "data-focus": true, role: "region", "aria-label": "Figures"}, this.note, this.list);
  private readonly ends: (() => void)[];
  private readonly sizes: ResizeObserver;
  private elements: FigureElement[] = [];
  private large: {element: FigureElement; index: number} | undefined;
  private figures: Figure[] = [];
  private timer: number | undefined;
  private isSeen = true;
  private isAsking = false;
  private isDue = false;

  constructor(host: HTMLElement, private readonly context: Context) {
    host.append(this.root);
    const {run, theme} = context;
    this.ends = [
      run.on("loaded", () => this.restart()), run.on("state", () => this.later()), run.on("set", () => this.later()), theme.on(() => this.draw()),
    ];
    this.sizes = new ResizeObserver(() => this.draw());
    this.sizes.observe(this.root);
    this.restart();
  }

  shown(isShown: boolean): void {
    this.isSeen = isShown;
    if (isShown) this.later();
  }

  dispose(): void {
    clearTimeout(this.timer);
    this.sizes.disconnect();
    for (const end of this.ends) end();
    for (const element of this.elements) element.dispose();
  }

  private restart(): void {
    const {loaded} = this.context.run;
    if (!loaded) return this.say("No diagram is loaded yet. Its figures appear here as soon as its text has no faults.");
    if (loaded.figures === 0) {
      this.take([]);
      return this.say("This diagram has no figures. A section such as “figure: {plot: lines, x: time in s, y: NAME in mm}” in its text draws one.");
    }
    this.say(this.figures.length === 0 ? "Figures are drawn…" : "");
    this.later(0);
  }

  private say(text: string): void {
    this.note.textContent = text;
    this.note.hidden = text === "";
  }

  /** Requests the figures after a pause; at most one request is pending. */
  private later(pause = soonest): void {
    if (!this.isSeen || !this.context.run.loaded?.figures) return;
    if (this.isAsking || this.timer !== undefined) return void (this.isDue = true);
    this.timer = window.setTimeout(() => void this.ask(), pause);
  }

  private async ask(): Promise<void> {
    this.timer = undefined;
    [this.isAsking, this.isDue] = [true, false];
    const from = performance.now();
    try {
      const {figures} = await this.context.connection.call<{figures: Figure[]}>("figures");
      this.say("");
      this.take(figures);
    } catch (thrown) {
      this.say(`The figures cannot be drawn: ${(thrown as Fault).message}`);
    }
    this.isAsking = false;
    const pause = Math.max(soonest, (share - 1) * (performance.now() - from));
    if (this.isDue || this.context.run.news.state === "playing") this.later(pause);
  }

  private take(figures: Figure[]): void {
    this.figures = figures;
    while (this.elements.length > figures.length) this.elements.pop()?.dispose();
    while (this.elements.length < figures.length) this.elements.push(this.another(this.elements.length));
    const now = this.elements.map(({element}) => element);
    if (now.length !== this.list.children.length || now.some((element, i) => element !== this.list.children[i])) this.list.replaceChildren(...now);
    this.draw();
  }

  private another(index: number): FigureElement {
    return new FigureElement(index + 1, () => this.enlarge(index));
  }

  /** Shows one figure in the size of a report; it keeps growing. */
  private enlarge(index: number): void {
    const element = new FigureElement(index + 1);
    this.large = {element, index};
    openDialog(`Figure ${index + 1}`, [element.element], undefined, () => {
      element.dispose();
      this.large = undefined;
    });
    this.draw();
  }

  private draw(): void {
    const room = this.root.clientWidth - around, tall = this.root.clientHeight - around, {isDark} = this.context.theme, {large} = this;
    if (room > 0) this.figures.forEach((figure, i) => this.elements[i].show(figure, isDark, room, tall));
    if (large && this.figures[large.index]) large.element.show(this.figures[large.index], isDark, window.innerWidth - 2 * around);
  }
}
