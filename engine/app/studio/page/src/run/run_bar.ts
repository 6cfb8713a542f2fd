import "./run.css";
import type {Context, View} from "../shell/context";
import {h, listen} from "../shell/dom";
import {icon} from "./icons";
import type {Loaded} from "./run_types";
import {measuredText, nextRate, rates, rateText} from "./rates";
import {Scrub} from "./scrub";
import {Verdicts} from "./verdicts";

/** Pause between updates of numbers that change during the run [ms]. */
const pause = 90;

const seconds = (time: number, step: number) => time.toFixed(Math.min(6, Math.max(3, Math.ceil(-Math.log10(step) - 1e-9))));

/** Bar with play, pause, single tick, restart, rate, time of the run, and timing. */
export class RunBar implements View {
  private readonly play = h("button", {type: "button", class: "main play"});
  private readonly tick = h("button", {type: "button", title: "Step by one tick (.)", "aria-label": "One tick"}, icon("tick"));
  private readonly restart = h("button", {type: "button", title: "Restart (R)", "aria-label": "Restart"}, icon("restart"));
  private readonly kept = h("button", {type: "button", title: "Keep this run (K)"}, icon("keep"));
  private readonly rate = h("select", {"aria-label": "Speed: simulated seconds per second", title: "Speed ([ slower, ] faster)"});
  private readonly time = h("span", {class: "run-time"});
  private readonly facts = h("span", {class: "run-facts"});
  private readonly fault = h("span", {class: "run-fault", role: "alert", hidden: true});
  private readonly stale = h("span", {class: "run-stale", hidden: true}, "text changed");
  private readonly scrub: Scrub;
  private readonly verdicts: Verdicts;
  private readonly ends: (() => void)[];

  constructor(host: HTMLElement, private readonly context: Context) {
    const {run} = context;
    this.scrub = new Scrub(run);
    this.verdicts = new Verdicts((text) => context.announce(text));
    host.classList.add("run-bar");
    host.append(h("div", {class: "run-buttons", role: "group", "aria-label": "Run"}, this.play, this.tick, this.restart, this.kept, this.rate),
      h("div", {class: "run-line"}, this.scrub.element, this.time), this.facts, this.stale, this.fault, this.verdicts.element);
    this.rate.replaceChildren(...rates.map((rate) => h("option", {value: rate, selected: rate === 1}, rateText(rate))));
    listen(this.play, "click", () => void run.toggle());
    listen(this.tick, "click", () => void run.tick());
    listen(this.restart, "click", () => void run.restart());
    listen(this.kept, "click", () => void this.keep());
    listen(this.rate, "change", () => void run.setRate(Number(this.rate.value)));
    this.ends = [
      run.on("loaded", (loaded) => { this.verdicts.load(loaded); this.scrub.reset(); this.offer(loaded); }), run.on("claims", (verdicts) => this.verdicts.judge(verdicts)),
      run.on("state", () => this.show()), run.on("fault", (fault) => context.notify(fault.message, "fault")),
      run.on("stale", (isStale) => { this.stale.hidden = !isStale; }), ...this.keys(),
    ];
    if (run.loaded) this.verdicts.load(run.loaded);
    this.stale.hidden = !run.stale;
    this.show();
  }

  dispose(): void {
    for (const end of this.ends) end();
  }

  private keys(): (() => void)[] {
    const {shortcuts, run} = this.context, group = "Run";
    const pace = (by: 1 | -1) => () => void run.setRate(nextRate(run.rate, by));
    return [
      shortcuts.add({key: "Space", text: "play, pause", group, action: () => void run.toggle()}),
      shortcuts.add({key: ".", text: "one tick", group, action: () => void run.tick()}),
      shortcuts.add({key: "R", text: "restart", group, action: () => void run.restart()}),
      shortcuts.add({key: "K", text: "keep this run in a folder", group, action: () => void this.keep()}),
      shortcuts.add({key: "[", text: "slower", group, action: pace(-1)}),
      shortcuts.add({key: "]", text: "faster", group, action: pace(1)}),
      shortcuts.add({key: "Left", text: "back in time; in a scope: cursor A (Shift: B, Alt: by a tick)", group, action: () => this.scrub.step(-1)}),
      shortcuts.add({key: "Right", text: "forward to where the run was", group, action: () => this.scrub.step(1)}),
    ];
  }

  private async keep(): Promise<void> {
    const folder = await this.context.run.keep();
    if (folder !== undefined) this.context.notify(`The run up to ${this.time.textContent} is kept. To replay it bit by bit: stepwire verify ${folder}`);
  }

  /** Hides the controls that a real-time loop does not have: its rate is fixed, and it cannot go back. */
  private offer({loop}: Loaded): void {
    for (const element of [this.tick, this.rate, this.scrub.element]) element.hidden = loop !== undefined;
  }

  /** Shows the state. Numbers that change with every picture are updated ten times per second, other changes at once. */
  private show(): void {
    const {state} = this.context.run.news, now = performance.now();
    if (state === "playing" && state === this.shownState && now - this.shownAt < pause) return;
    this.shownState = state;
    this.shownAt = now;
    this.showNow();
  }
  private shownState = "";
  private shownAt = 0;

  private showNow(): void {
    const {news, rate, loaded, latency} = this.context.run, isPlaying = news.state === "playing";
    if (this.play.dataset.shows !== news.state) this.play.replaceChildren(icon(isPlaying ? "pause" : "play"));
    this.play.dataset.shows = news.state;
    this.play.setAttribute("aria-label", isPlaying ? "Pause" : "Play");
    this.play.title = `${isPlaying ? "Pause" : "Play"} (Space)`;
    if (this.rate.value !== String(rate)) this.rate.value = String(rate);
    this.time.textContent = `${seconds(news.time, loaded?.step ?? 0.001)} s`;
    this.time.title = `tick ${news.tick}${loaded?.stop == null ? "" : ` of ${Math.round(loaded.stop / loaded.step)}`}, ${news.state}, ${news.compiled ? "generated code" : "interpreted"}`;
    this.showFacts(measuredText(news.rate, isPlaying), news.missed, latency.median);
    this.fault.hidden = !news.fault;
    this.fault.textContent = news.fault ?? "";
    this.scrub.show();
  }

  private showFacts(measured: string, missed: number, latency: number | undefined): void {
    const facts = [["pace", measured, "Simulated seconds per second, measured"],
      ...(this.context.run.loaded?.loop ? [["missed", String(missed), "Deadlines missed"]] : []),
      ["input", latency === undefined ? "–" : `${latency.toFixed(0)} ms`, "Median time from an input to the first frame that shows it"]];
    if (this.facts.childElementCount !== facts.length)
      this.facts.replaceChildren(...facts.map(([name, , title]) => h("span", {class: "fact", title}, `${name} `, h("b", {}))));
    facts.forEach(([, value], i) => {
      const place = this.facts.children[i].querySelector("b")!;
      if (place.textContent !== value) place.textContent = value;
    });
  }
}
