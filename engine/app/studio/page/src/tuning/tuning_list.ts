import "./tuning.css";
import type {Loaded, Parameter} from "../run/run_types";
import type {Context, View} from "../shell/context";
import {h, listen} from "../shell/dom";
import {TuningRow} from "./tuning_row";

/** Limit of listed parameters; a search narrows them down. */
const most = 60, key = "tuning.pinned";

/** Returns the parameters that match a search: pinned ones first, then those of the file, of its parts, and numbers of blocks. */
export function listed(parameters: Parameter[], search: string, pinned: Set<string>): Parameter[] {
  const words = search.toLowerCase().split(/\s+/).filter(Boolean);
  const fits = ({name, doc}: Parameter) => words.every((word) => name.toLowerCase().includes(word) || doc.toLowerCase().includes(word));
  const rank = ({name, block}: Parameter) => (pinned.has(name) ? 0 : block ? 3 : name.includes(".") ? 2 : 1);
  return parameters.filter(fits).map((one, i) => ({one, i})).sort((a, b) => rank(a.one) - rank(b.one) || a.i - b.i).map(({one}) => one);
}

/** List of live parameters. */
export class TuningList implements View {
  private readonly search = h("input", {type: "search", placeholder: "parameter or number of a block", "aria-label": "Search parameters", "data-focus": ""});
  private readonly list = h("ul", {class: "tuned-list"});
  private readonly more = h("p", {class: "tuned-more", hidden: true});
  private rows = new Map<string, TuningRow>();
  private readonly pinned: Set<string>;
  private readonly ends: (() => void)[];

  constructor(host: HTMLElement, private readonly context: Context) {
    const {run, settings} = context;
    this.pinned = new Set(settings.get<string[]>(key, []));
    host.classList.add("tuning");
    host.append(h("div", {class: "tuned-search"}, this.search), this.list, this.more);
    listen(this.search, "input", () => this.show());
    this.ends = [run.on("loaded", (loaded) => this.load(loaded)), run.on("set", (echo) => this.rows.get(echo.name)?.took(echo))];
    if (run.loaded) this.load(run.loaded);
    else this.list.append(h("li", {class: "empty"}, "Parameters appear here once the diagram loads."));
  }

  dispose(): void {
    for (const end of this.ends) end();
  }

  private load(_: Loaded): void {
    this.rows.clear();
    this.show();
  }

  private show(): void {
    const parameters = this.context.run.loaded?.parameters ?? [], all = listed(parameters, this.search.value, this.pinned);
    this.list.replaceChildren(...all.slice(0, most).map((parameter) => this.row(parameter).element));
    if (parameters.length === 0) this.list.append(h("li", {class: "empty"}, "This diagram has no parameters or numbers to tune."));
    this.more.hidden = all.length <= most;
    this.more.textContent = `${all.length - most} more; search by name`;
  }

  private row(parameter: Parameter): TuningRow {
    const known = this.rows.get(parameter.name);
    if (known) return known;
    const row = new TuningRow(parameter, this.context, this.pinned.has(parameter.name), () => this.pin(parameter.name));
    this.rows.set(parameter.name, row);
    return row;
  }

  /** Pins a parameter to the top, or unpins it. */
  private pin(name: string): void {
    if (!this.pinned.delete(name)) this.pinned.add(name);
    this.context.settings.set(key, [...this.pinned]);
    this.rows.get(name)?.setPinned(this.pinned.has(name));
    this.show();
  }
}
