import "./scopes.css";
import {Fault} from "../connection/connection";
import type {Loaded} from "../run/run_types";
import type {Context, View} from "../shell/context";
import {h, listen} from "../shell/dom";
import {BoardBar} from "./board_bar";
import {speechOf} from "./cursor_speech";
import {Cursors} from "./cursors";
import {takeDrops} from "./drops";
import {BoardFilling} from "./board_filling";
import {layoutOf} from "./board_layout";
import {addressOf} from "./kept_layout";
import {copyText} from "./hand_over";
import {traceColors} from "./palette";
import {historyOf, type LogEvent} from "./pin_history";
import {Pins} from "./pins";
import {resolve} from "./resolve";
import {Scope, type ScopeHost} from "./scope";
import type {Shared} from "./shared";
import {SignalList} from "./signal_list";
import {StatisticsTable} from "./statistics_table";
import {Ticker} from "./ticker";
import {TimeWindow} from "./time_window";

/** Time that the cursors must rest before they are announced [ms]. */
const spoken = 250;

/** All scopes of the page, with their shared state: time window, cursors, pinned runs, a fan. */
export class ScopeBoard implements View, ScopeHost {
  readonly shared: Shared;
  scopes: Scope[] = [];
  readonly signals = new SignalList((source, inNew) => this.addSource(inNew ? undefined : this.target, source), () => this.leaveSignals());
  private readonly grid = h("div", {class: "scope-grid"});
  private readonly statistics: StatisticsTable;
  private readonly bar: BoardBar;
  private readonly ticker: Ticker;
  private readonly filling = new BoardFilling(this);
  private readonly ends: (() => void)[];
  private readonly sight = new IntersectionObserver((entries) => this.see(entries));
  private isShown = true;
  private target: Scope | undefined;
  private speaking: number | undefined;

  constructor(host: HTMLElement, private readonly context: Context) {
    const {run} = context, tick = () => this.ticker.request();
    const redraw = () => {
      for (const scope of this.scopes) scope.touch();
      tick();
    };
    this.shared = {
      context, redraw, tick, fan: undefined, colors: [], look: {ink: "", line: "", font: ""}, sides: 1, now: 0, hover: undefined, keep: () => this.keep(),
      cursors: new Cursors(() => this.moved()), window: new TimeWindow(10, () => { redraw(); this.keep(); }),
      pins: new Pins(context.connection, () => { this.bar.update(); redraw(); }),
    };
    this.ticker = new Ticker(() => run.clock.moves, (at, isLast) => this.draw(at, isLast), () => context.theme.isStill);
    this.statistics = new StatisticsTable(this.shared, () => this.scopes);
    this.bar = new BoardBar(this);
    host.classList.add("scopes");
    host.append(this.bar.element, h("div", {class: "scope-body"}, this.grid, this.signals.element), this.statistics.element);
    run.fanColumns = () => [...new Set(this.scopes.flatMap(({traces}) => traces.map(({column}) => column).filter((column) => column >= 0)))];
    this.ends = [
      run.on("loaded", (loaded) => void this.load(loaded)), run.on("state", () => { this.bar.update(); tick(); }),
      run.on("fan", (fan) => { this.shared.fan = fan.points.length > 0 ? fan : undefined; redraw(); }),
      context.theme.on(() => this.relook()), ...this.keys(),
    ];
    takeDrops(host, (source) => this.add(undefined, source));
    this.relook();
    if (run.loaded) void this.load(run.loaded);
  }

  shown(isShown: boolean): void {
    this.isShown = isShown;
    this.ticker.request();
    if (!isShown) for (const scope of this.scopes) scope.want(false);
  }

  dispose(): void {
    for (const end of this.ends) end();
    for (const scope of this.scopes) scope.dispose();
    this.sight.disconnect();
    this.ticker.stop();
  }

  // Requests of a scope.
  add(scope: Scope | undefined, source: string): void {
    void this.addSource(scope, source).then((fault) => { if (fault) this.context.notify(`${source}: ${fault}`, "fault"); });
  }

  remove(scope: Scope): void {
    this.scopes = this.scopes.filter((one) => one !== scope);
    if (this.target === scope) this.target = undefined;
    scope.dispose();
    this.keep();
    this.moved();
  }


  /** Opens an empty scope and makes it the target of the next selection. */
  open(title = `Scope ${this.scopes.length + 1}`): Scope {
    const scope = new Scope(title, this.shared, this);
    listen(scope.element, "focusin", () => { this.target = scope; });
    this.scopes.push(scope);
    this.grid.append(scope.element);
    this.sight.observe(scope.element);
    return scope;
  }

  /** Adds a signal or expression to a scope, or to a new one. Resolves to the reason of a failure, else undefined. */
  async addSource(scope: Scope | undefined, source: string): Promise<string | undefined> {
    try {
      const trace = await resolve(source, this.context.run.loaded?.columns ?? [], this.context.connection, 0);
      (scope ?? this.open(trace.label)).add(trace);
      this.context.announce(`${trace.label} is in ${scope ? scope.name : "a new scope"}`);
      const {news, loaded} = this.context.run, isLate = loaded?.loop !== undefined && news.time > 0 && !loaded.columns.some(({column, recorded}) => column === trace.column && recorded);
      if (isLate) this.context.notify(`${trace.label} is stored from now on; a real-time loop cannot be run again for earlier values. Record it in the file`);
      this.keep();
      this.moved();
      return undefined;
    } catch (thrown) {
      return Fault.from(thrown).message;
    }
  }

  private leaveSignals(): void {
    this.bar.showSignals(false);
    (this.target ?? this.scopes[0])?.element.focus();
  }

  /** Follows the newest data again, with the former width and fitted values. */
  follow(width?: number): void {
    for (const scope of this.scopes) {
      scope.own?.follow();
      for (const {range} of scope.groups) range.fit();
    }
    this.shared.window.follow(width);
    this.bar.update();
  }

  /** Pins this run for comparison with later ones. */
  async pin(): Promise<void> {
    const {news, loaded} = this.context.run;
    if (news.time === 0 || !loaded) return this.context.notify("the run has not started: there is nothing to pin");
    const {events} = await this.context.connection.call<{events: LogEvent[]}>("run.log").catch(() => ({events: []}));
    const history = historyOf(loaded.parameters, events.filter(({tick}) => tick * loaded.step <= news.time), loaded.step);
    const pin = await this.shared.pins.take(this.scopes.flatMap(({traces}) => traces), news.time, history.join("; "));
    this.context.announce(`pinned ${pin.label}`);
  }

  /** Restores the scopes of the file. */
  reset(): void {
    if (this.context.run.loaded) this.filling.reset(this.context.run.loaded);
  }

  /** Removes all scopes. */
  clear(): void {
    for (const scope of [...this.scopes]) this.remove(scope);
  }

  copyAddress(): void {
    void copyText(this.context, addressOf(layoutOf(this), location.href), "the address of this view");
  }

  private keep(): void {
    this.bar.update();
    this.filling.keep();
  }

  private async load(loaded: Loaded): Promise<void> {
    this.signals.fill(loaded.columns);
    this.shared.fan = undefined;
    await this.filling.load(loaded);
    this.moved();
    this.bar.update();
  }

  private draw(at: number, isLast: boolean): void {
    if (!this.isShown) return;
    if (isLast) for (const scope of this.scopes) scope.touch();
    const {run} = this.context;
    this.shared.now = run.time;
    this.shared.sides = Math.min(2, Math.max(1, ...this.scopes.map(({groups}) => groups.length)));
    let newest = -Infinity;
    for (const scope of this.scopes) {
      scope.want(true);
      if (!scope.isSeen) continue;
      scope.draw(at);
      newest = Math.max(newest, scope.feed.frame?.newest ?? -Infinity);
    }
    this.statistics.passed();
    run.latency.drawn(newest, performance.now());
  }

  private relook(): void {
    const {theme} = this.context;
    this.shared.colors = traceColors((name) => theme.token(name));
    this.shared.look = {ink: theme.token("--ink-soft"), line: theme.token("--line"), font: `12px ${theme.token("--font") || "sans-serif"}`};
    for (const scope of this.scopes) scope.relook();
    this.ticker.request();
  }

  private see(entries: IntersectionObserverEntry[]): void {
    for (const {target, isIntersecting} of entries) {
      const scope = this.scopes.find(({element}) => element === target);
      if (scope) scope.isSeen = isIntersecting;
    }
    this.ticker.request();
  }

  /** Handles a change of the cursors, or of the data at them. */
  private moved(): void {
    this.statistics.update();
    this.ticker.request();
    clearTimeout(this.speaking);
    if (this.shared.cursors.a !== undefined) this.speaking = window.setTimeout(() => this.speak(), spoken);
  }

  private speak(): void {
    this.context.announce(speechOf(this.shared.cursors, this.target ?? this.scopes[0]));
  }

  private keys(): (() => void)[] {
    const {shortcuts} = this.context, group = "Scopes", within = () => this.isShown;
    const only = {key: "", text: "", action: () => {}, group};
    return [
      shortcuts.add({...only, key: "F", text: "follow the newest again", within, action: () => this.follow()}),
      shortcuts.add({...only, key: "N", text: "new scope", within, action: () => { this.open().element.focus(); this.keep(); }}),
      shortcuts.add({...only, key: "A", text: "add a signal", within, action: () => this.bar.showSignals(true)}),
      shortcuts.add({...only, key: "P", text: "pin this run to compare with", within, action: () => void this.pin()}),
      shortcuts.add({...only, key: "Esc", text: "remove the cursors", within: () => this.isShown && this.shared.cursors.a !== undefined, action: () => this.shared.cursors.clear()}),
    ];
  }
}
