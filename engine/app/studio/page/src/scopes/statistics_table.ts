import {Fault} from "../connection/connection";
import {h} from "../shell/dom";
import {claimText, mayClaim} from "./claim_text";
import {insertText} from "./hand_over";
import {swatch} from "./legend";
import type {Scope} from "./scope";
import type {Shared} from "./shared";
import {marksText, reducedText, type Reduction, reductions, type Statistics} from "./statistics";
import {type Trace, unitOf} from "./trace";

/** Time that the cursors must rest before a request, and interval between requests while the run is between them [ms]. */
const quiet = 60, between = 250;

/** Converts null to NaN, which JSON lacks. */
const numbers = (one: Statistics): Statistics => Object.fromEntries(Object.entries(one).map(([name, value]) => [name, value ?? NaN])) as unknown as Statistics;

/** Table with the statistics between the cursors, for all traces of all scopes, from all samples. A click on a number adds an item to `claims`. */
export class StatisticsTable {
  readonly element = h("section", {class: "statistics", "aria-label": "Between the cursors", hidden: true});
  private readonly head = h("p", {class: "statistics-head"});
  private readonly table = h("table", {class: "values"});
  private timer: number | undefined;
  private asked = "";
  private askedAt = 0;
  /** Time of the run at the last request. */
  private upTo = 0;
  private known = new Map<number, Statistics>();

  constructor(private readonly shared: Shared, private readonly scopes: () => Scope[]) {
    const clear = h("button", {type: "button", class: "plain small", onclick: () => shared.cursors.clear()}, "Clear");
    this.element.append(h("header", {}, this.head, clear), h("div", {class: "scrolled"}, this.table));
  }

  /** Requests the statistics again for a new time of the run, unless the run had already passed the cursors. */
  passed(): void {
    const {context: {run: {news: {time}}}, cursors: {stretch}} = this.shared, hasPassed = stretch && Math.min(this.upTo, time) >= stretch.high;
    if (stretch && !hasPassed && time !== this.upTo && performance.now() - this.askedAt > between) void this.ask();
  }

  /** Updates the table after a change of the cursors or the signals. */
  update(): void {
    const {a, b} = this.shared.cursors;
    this.element.hidden = a === undefined;
    if (a === undefined) return;
    this.head.textContent = marksText(a, b);
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.ask(), quiet);
  }

  private get traces(): [Scope, Trace][] {
    return this.scopes().flatMap((scope) => scope.traces.filter(({column}) => column >= 0).map((trace): [Scope, Trace] => [scope, trace]));
  }

  private async ask(): Promise<void> {
    const {stretch} = this.shared.cursors, columns = [...new Set(this.traces.map(([, {column}]) => column))];
    if (!stretch || columns.length === 0) return this.table.replaceChildren();
    const wanted = JSON.stringify([stretch, columns]);
    this.asked = wanted;
    this.askedAt = performance.now();
    this.upTo = this.shared.context.run.news.time;
    try {
      const {statistics} = await this.shared.context.connection.call<{statistics: Statistics[]}>("data.statistics", {columns, from: stretch.low, to: stretch.high});
      if (this.asked !== wanted) return;
      this.known = new Map(statistics.map((one) => [one.column, numbers(one)]));
      this.show();
    } catch (thrown) {
      this.head.textContent = `no statistics: ${Fault.from(thrown).message}`;
    }
  }

  private show(): void {
    const hasBoth = this.shared.cursors.b !== undefined, shown = reductions.filter(({needsBoth}) => hasBoth || !needsBoth);
    const head = h("tr", {}, h("th", {scope: "col"}, "signal"), ...shown.map(({title}) => h("th", {scope: "col"}, title)));
    this.table.replaceChildren(h("thead", {}, head), h("tbody", {}, ...this.traces.map(([scope, trace]) => this.row(scope, trace, shown.map(({name}) => name)))));
  }

  private row(scope: Scope, trace: Trace, shown: Reduction[]): HTMLElement {
    const name = h("th", {scope: "row", title: trace.source}, swatch(trace.style), trace.label);
    return h("tr", {}, name, ...shown.map((reduction) => h("td", {}, this.cell(scope, trace, reduction))));
  }

  /** True for a value at a cursor that the run has not reached yet. */
  private isBeyond(reduction: Reduction): boolean {
    const {cursors: {a = 0, b = a}, context: {run}} = this.shared, at = {a, b, difference: Math.max(a, b)}[reduction as "a" | "b" | "difference"];
    return at !== undefined && at > run.news.time + (run.loaded?.step ?? 0);
  }

  private cell(scope: Scope, trace: Trace, reduction: Reduction): HTMLElement | string {
    const statistics = this.known.get(trace.column), {a, b} = this.shared.cursors;
    if (!statistics || a === undefined || this.isBeyond(reduction)) return "–";
    const seen = scope.groups.find(({traces}) => traces.includes(trace))?.unit, unit = seen ?? unitOf(trace, Math.max(-statistics.min, statistics.max));
    const text = reducedText(statistics, reduction, unit, b !== undefined && b < a);
    if (!mayClaim(reduction)) return text;
    const claim = () => insertText(this.element, this.shared.context, "claims", claimText({...trace, statistics, unit, a, b}, reduction)!);
    return h("button", {type: "button", class: "plain small", title: "Add it as a claim", onclick: claim}, text);
  }
}
