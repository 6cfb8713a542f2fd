import {h, listen} from "../shell/dom";
import {openMenu} from "../shell/menu";
import {Against} from "./against";
import type {AxisGroup} from "./axis_group";
import type {Axes, Content, Curve, Subject} from "./content";
import {DifferenceTo} from "./difference_to";
import {takeDrops} from "./drops";
import {Feed} from "./feed";
import {Gestures} from "./gestures";
import {Legend} from "./legend";
import {MarksLayer} from "./marks_layer";
import {OverTime} from "./over_time";
import {freeNumber, mostTraces} from "./palette";
import type {Pin} from "./pins";
import {fixedText} from "./numbers";
import {Plot} from "./plot";
import {gapOf, valueAt} from "./samples";
import {ScopeGestures} from "./scope_gestures";
import {pressed} from "./scope_keys";
import {entriesOf} from "./scope_menu";
import type {Shared} from "./shared";
import {TimeWindow} from "./time_window";
import type {Trace} from "./trace";
import type {Range} from "./y_range";

/** Interface of the board to a scope. */
export interface ScopeHost {
  /** Adds a name or expression that was dropped or selected. */
  add(scope: Scope, source: string): void;
  remove(scope: Scope): void;
}

/** Curves are redrawn after a movement by this many screen pixels, or this time after new values arrived [s]. */
const leastMove = 0.5, newPause = 0.1;
/** Interval between updates of the legend while time advances [s]. */
const legendPause = 0.2;
/** Step of the requested width in pixels, so that moving a splitter does not cause a request per pixel. */
const pixelStep = 50;

/** Plot of signals, with its window of time and the marks over it. */
export class Scope implements Subject {
  readonly element = h("section", {class: "scope", tabindex: 0, role: "group"});
  readonly feed: Feed;
  groups: AxisGroup[] = [];
  traces: Trace[] = [];
  own: TimeWindow | undefined;
  private content: Content = new OverTime(this);
  private readonly plot: Plot;
  private marks: MarksLayer | undefined;
  private readonly legend = new Legend((trace) => this.removeTrace(trace));
  private readonly head = h("header", {class: "scope-head"});
  private readonly title = h("span", {class: "scope-title"});
  private readonly chip = h("span", {class: "chip", hidden: true});
  private readonly note = h("p", {class: "scope-note", hidden: true});
  private readonly tolerance = h("input", {
    type: "text", class: "tolerance", value: "1 %", "aria-label": "Tolerance", title: "Tolerance: a value in the unit shown, or % of the pinned run's range",
  });
  private readonly area = h("div", {class: "scope-plot"});
  private readonly sizes = new ResizeObserver(() => this.measure());
  private legendAt = 0;
  private drawn: Range = {low: 0, high: 0};
  private drawnAt = 0;
  private axes: Axes = {x: {low: 0, high: 1}, unitOfX: "s", ys: []};
  private isTouched = true;
  private hasNew = false;
  private width = 320;
  isSeen = true;

  constructor(readonly name: string, readonly shared: Shared, readonly host: ScopeHost) {
    this.feed = new Feed(shared.context.connection, () => this.arrived());
    this.plot = new Plot(this.area, shared.look, (plot) => this.content.paint(plot, this.window.at(shared.now)), (over) => this.overlay(over));
    this.title.textContent = name;
    this.tolerance.hidden = true;
    const more = h("button", {type: "button", class: "plain small", "aria-label": "Menu of this scope", title: "More", "aria-haspopup": "menu"}, "⋯");
    listen(more, "click", () => openMenu(more, entriesOf(this), `Scope ${name}`));
    this.head.append(this.title, this.legend.element, this.tolerance, this.chip, more);
    this.element.append(this.head, this.area, this.note);
    listen(this.tolerance, "input", () => shared.redraw());
    listen(this.element, "keydown", (event: KeyboardEvent) => { if (event.target === this.element) pressed(event, this); });
    takeDrops(this.element, (source) => host.add(this, source));
    this.sizes.observe(this.area);
    this.sizes.observe(this.head);
    this.list();
  }

  get window(): TimeWindow {
    return this.own ?? this.shared.window;
  }

  get isAgainst(): boolean {
    return this.content instanceof Against;
  }

  get comparedTo(): Pin | undefined {
    return this.content instanceof DifferenceTo ? this.content.pin : undefined;
  }

  /** Adds a trace; false if the scope is full. */
  add(trace: Trace): boolean {
    const style = freeNumber(this.traces.map((one) => one.style));
    if (style === undefined) {
      this.shared.context.notify(`a scope has at most ${mostTraces} signals; remove one or use another scope`);
      return false;
    }
    const beside = this.traces.find(({si, unit}) => unit && si === trace.si);
    this.traces.push({...trace, style, unit: trace.unit ?? beside?.unit});
    this.list();
    return true;
  }

  removeTrace(trace: Trace): void {
    this.traces = this.traces.filter((one) => one !== trace);
    this.list();
    this.shared.keep();
  }

  /** Replaces the traces by the same ones with the columns of another load. */
  replaceTraces(traces: Trace[]): void {
    this.traces = traces;
    this.list();
  }

  /** Sets the content: curves over time, one signal against another, or the difference to a pinned run. */
  fill(what: "time" | "against" | Pin): void {
    this.content = what === "time" ? new OverTime(this) : what === "against" ? new Against(this) : new DifferenceTo(this, what, () => this.tolerance.value);
    this.tolerance.hidden = !(this.content instanceof DifferenceTo);
    this.groups = [];
    this.feed.renew();
    this.changed();
  }

  /** Switches to a time window of its own. */
  takeOwnTime(): TimeWindow {
    this.own = new TimeWindow(this.shared.window.width, () => this.changed());
    this.changed();
    return this.own;
  }

  /** Switches back to the time window of the board. */
  shareTime(): void {
    this.own = undefined;
    this.changed();
  }

  private changed(): void {
    this.shared.redraw();
    this.shared.keep();
  }

  /** Requests the visible data; none while the scope is out of view. */
  want(isShown: boolean): void {
    const columns = [...new Set(this.traces.map(({column}) => column).filter((column) => column >= 0))].sort((a, b) => a - b), {rate} = this.shared.context.run;
    if (!isShown || !this.isSeen || columns.length === 0) return this.feed.stop();
    const pixels = Math.max(pixelStep, Math.ceil((this.width * devicePixelRatio) / pixelStep) * pixelStep);
    this.feed.want({columns, ...this.content.wanted(this.window.at(this.shared.now), this.window.isFollowing, pixels)}, this.isAgainst ? 0 : this.window.framePause(leastMove / this.plot.box.width, rate));
  }

  /** Draws for the time of the run in `shared`, at `at` [s of the page's clock]. Curves are redrawn only if they would visibly move. */
  draw(at: number): void {
    const window = this.window.at(this.shared.now);
    if (this.isDue(window, at)) this.drawCurves(window, at);
    if (!this.isAgainst) this.marks?.place(window, this.plot.box.width / this.plot.ratio, this.shared.cursors, this.shared.hover);
    if (this.shared.context.run.clock.moves && at - this.legendAt < legendPause) return;
    this.legendAt = at;
    this.tell(window);
  }

  /** Requests a redraw for a change other than time. */
  touch(): void {
    this.isTouched = true;
  }

  private isDue({low, high}: Range, at: number): boolean {
    const moved = this.isAgainst ? 0 : (Math.abs(low - this.drawn.low) / (high - low)) * this.plot.box.width;
    return this.isTouched || moved >= leastMove || (this.hasNew && at - this.drawnAt >= newPause) || high - low !== this.drawn.high - this.drawn.low;
  }

  /** Visible content for a picture: axes in display units, and curves. */
  get picture(): {axes: Axes; curves: Curve[]} {
    return {axes: this.axes, curves: this.content.curves(this.window.at(this.shared.now))};
  }

  private drawCurves(window: Range, at: number): void {
    this.axes = this.content.axes(window, at);
    this.plot.draw(this.axes.x, this.axes.ys, this.axes.unitOfX, this.shared.sides);
    this.drawn = window;
    this.drawnAt = at;
    this.isTouched = this.hasNew = false;
  }

  /** Notes new values; while time advances they are drawn with the next movement. */
  private arrived(): void {
    this.hasNew = true;
    if (!this.window.isFollowing || !this.shared.context.run.clock.moves) this.isTouched = true;
    this.shared.tick();
  }

  /** Returns the value of a trace at a time [s], by default the newest one. */
  valueOf(trace: Trace, time?: number): Range | undefined {
    const samples = this.feed.samples.get(trace.column), {news, loaded} = this.shared.context.run;
    return samples && (time === undefined || time <= news.time + (loaded?.step ?? 0)) ? valueAt(samples, time ?? Infinity) : undefined;
  }

  /** Returns the last value; of an interval its middle. */
  private newest(trace: Trace): Range | undefined {
    const value = this.valueOf(trace), middle = value && (value.low + value.high) / 2;
    return middle === undefined ? undefined : {low: middle, high: middle};
  }

  relook(): void {
    this.plot.relook(this.shared.look);
  }

  dispose(): void {
    this.feed.stop();
    this.sizes.disconnect();
    this.plot.dispose();
    this.element.remove();
  }

  private list(): void {
    this.head.style.removeProperty("min-height");
    this.legend.list(this.traces);
    this.element.setAttribute("aria-label", `Scope ${this.name}: ${this.traces.map(({label}) => label).join(", ") || "empty"}`);
    this.shared.redraw();
  }

  private overlay(over: HTMLElement): void {
    this.marks = new MarksLayer(over);
    new Gestures(over, new ScopeGestures(this, this.marks));
  }

  /** Updates the texts that depend on the drawn data. */
  private tell(window: Range): void {
    const {hover, cursors} = this.shared, time = hover ?? cursors.a, note = [this.content.note(), this.gaps()].filter(Boolean).join("; ");
    this.legend.show(this.groups, (trace) => (time === undefined ? this.newest(trace) : this.valueOf(trace, time)));
    if (this.note.textContent !== note) this.note.textContent = note;
    this.note.hidden = note === "";
    this.chip.hidden = !this.own;
    if (this.own) this.chip.textContent = this.own.isFollowing ? `own time, following ${this.own.width} s` : `own time, ${window.low.toFixed(3)} to ${window.high.toFixed(3)} s`;
  }

  /** Describes traces without samples at the start of the window: they were requested later, and their past may still be computed. */
  private gaps(): string {
    return this.traces.flatMap(({label, column}) => {
      const from = gapOf(this.feed.samples.get(column));
      return from === undefined ? [] : [`${label} is stored from ${fixedText(from, 3)} s on; earlier values are computed again or missing`];
    }).join("; ");
  }

  /** Keeps the height of the legend after wider values have caused a further line, so that the plot does not jump. */
  private measure(): void {
    if (this.width !== this.area.clientWidth) this.head.style.removeProperty("min-height");
    this.head.style.setProperty("min-height", `${this.head.offsetHeight}px`);
    this.width = this.area.clientWidth;
    if (this.width > 0) this.plot.resize(this.width, Math.max(60, this.area.clientHeight));
    this.shared.redraw();
  }
}
