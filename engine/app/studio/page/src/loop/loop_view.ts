import {Fault} from "../connection/connection";
import type {Context, View} from "../shell/context";
import {h} from "../shell/dom";
import {HistogramChart} from "./histogram_chart";
import type {Histogram, LoopNews} from "./loop_news";
import {timeText} from "./time_text";
import "./loop.css";

const kinds: [keyof Pick<LoopNews, "lateness" | "response" | "step">, string, string][] = [
  ["lateness", "lateness", "how late the thread woke"], ["response", "response", "until outputs were written; it must end before the deadline"], ["step", "step", "total time of a tick"],
];
const many = 12;

/** Timing of a real-time loop: misses, histograms with the deadline, and the most expensive blocks. */
export class LoopView implements View {
  private readonly facts = h("div", {class: "loop-facts"});
  private readonly verdict = h("p", {class: "loop-verdict", role: "status"});
  private readonly refused = h("ul", {class: "loop-refused"});
  private readonly chart = new HistogramChart();
  private readonly times = h("tbody", {});
  private readonly costs = h("tbody", {});
  private readonly note = h("p", {class: "empty", hidden: true});
  private readonly body: HTMLElement;
  private readonly ends: (() => void)[];
  private isSeen = true;
  private news: LoopNews | undefined;

  constructor(host: HTMLElement, private readonly context: Context) {
    const head = (...names: string[]) => h("thead", {}, h("tr", {}, ...names.map((name) => h("th", {scope: "col"}, name))));
    this.body = h("div", {class: "loop-body", hidden: true}, this.verdict, this.facts, this.refused,
      h("h3", {}, "Timing within a tick"), h("div", {class: "loop-picture"}, this.chart.element),
      h("table", {class: "loop-times"}, h("caption", {class: "unseen"}, "Times of the loop"), head("", "p50", "p99", "p99.9", "longest", ""), this.times),
      h("h3", {}, "Cost of a tick"), h("table", {class: "loop-costs"}, h("caption", {class: "unseen"}, "Cost by block type"), head("kind", "blocks", "a tick", "share"), this.costs));
    host.append(h("div", {class: "loop", tabindex: 0, "aria-label": "Real-time loop", "data-focus": true}, this.note, this.body));
    this.ends = [context.connection.on("loop", (news: LoopNews) => this.take(news)), context.run.on("loaded", () => void this.load()), context.run.on("state", () => this.showState())];
    void this.load();
  }

  shown(isShown: boolean): void {
    this.isSeen = isShown;
    if (isShown && this.news) this.show(this.news);
  }

  dispose(): void {
    for (const end of this.ends) end();
  }

  private async load(): Promise<void> {
    try {
      this.take(await this.context.connection.call<LoopNews>("loop"));
    } catch (thrown) {
      this.note.textContent = `No loop to show: ${Fault.from(thrown).message}`;
      [this.note.hidden, this.body.hidden] = [false, true];
    }
  }

  private take(news: LoopNews): void {
    this.news = news;
    if (this.isSeen) this.show(news);
  }

  private show(news: LoopNews): void {
    [this.note.hidden, this.body.hidden] = [true, false];
    const fact = (name: string, value: string, title: string) => h("span", {class: "fact", title}, `${name} `, h("b", {}, value));
    this.facts.replaceChildren(fact("period", timeText(news.period), "From one deadline to the next"), fact("policy", news.policy, "How the system schedules the loop's thread"),
      fact("served", news.served.toLocaleString("en"), "Deadlines that were served"), fact("late", String(news.late), "Outputs were written after the deadline"),
      fact("dropped", String(news.dropped), "Ticks skipped to catch up"), fact("longest series", String(news.longest), "Most consecutive misses"), fact("not shown", String(news.lost), "Ticks that this page did not receive; the loop ran them"));
    this.refused.replaceChildren(...news.refused.map((text) => h("li", {}, text)));
    this.chart.show(kinds.map(([kind]) => [kind, news[kind]]), news.period);
    this.times.replaceChildren(...kinds.map(([kind, name, text]) => this.row(kind, name, text, news[kind])));
    this.showCosts(news);
    this.showState();
  }

  private row(kind: string, name: string, text: string, {p50, p99, p999, max, count}: Histogram): HTMLElement {
    const cells = count === 0 ? ["–", "–", "–", "–"] : [p50, p99, p999, max].map(timeText);
    return h("tr", {title: text}, h("th", {scope: "row"}, h("span", {class: `loop-key loop-${kind}`, "aria-hidden": true}), name), ...cells.map((cell) => h("td", {}, cell)), h("td", {class: "loop-meaning"}, text));
  }

  private showCosts({costs, period}: LoopNews): void {
    const rows = costs.slice(0, many), most = Math.max(...rows.map(({mean}) => mean), 1e-12);
    this.costs.replaceChildren(...rows.map(({type, blocks, mean}) => {
      const bar = h("span", {class: "loop-share", "aria-hidden": true}), names = String(blocks);
      bar.style.setProperty("--share", `${(100 * mean) / most}%`);
      return h("tr", {}, h("th", {scope: "row"}, type), h("td", {class: "loop-blocks", title: names}, names), h("td", {}, timeText(mean)), h("td", {}, bar, ` ${((100 * mean) / period).toPrecision(2)} % of the period`));
    }), ...(rows.length === 0 ? [h("tr", {}, h("td", {colspan: 4}, "no measurement yet"))] : []));
  }

  private showState(): void {
    const {news} = this, {state} = this.context.run.news;
    if (!news) return;
    const isGood = news.missed === 0, text = news.served === 0 ? "The loop has not started; Play starts it." : isGood ? "Every deadline was kept." : `${news.missed} of ${(news.served + news.dropped).toLocaleString("en")} deadlines were missed.`;
    const whole = state === "playing" || news.served === 0 ? text : `${text} The loop is stopped; its outputs have their safe values.`;
    if (this.verdict.textContent !== whole) this.verdict.textContent = whole;
    this.verdict.classList.toggle("loop-missed", !isGood);
  }
}
