import {h, listen} from "../shell/dom";
import type {Column} from "../run/run_types";

/** Limit of listed signals; a search narrows them down. */
const most = 200;

/** Returns the signals whose names contain all words of a search; names that begin with the first word are first. */
export function found(columns: Column[], search: string): Column[] {
  const words = search.toLowerCase().split(/\s+/).filter(Boolean);
  const fitting = columns.filter(({name}) => words.every((word) => name.toLowerCase().includes(word)));
  const starts = ({name}: Column) => (words.length > 0 && name.toLowerCase().startsWith(words[0]) ? 0 : 1);
  return fitting.map((column, i) => ({column, i})).sort((a, b) => starts(a.column) - starts(b.column) || a.i - b.i).map(({column}) => column);
}

/** Signals of the run, for searching, dragging into a scope, or selecting; a text that is no name is used as an expression. */
export class SignalList {
  readonly element = h("div", {class: "signals", role: "group", "aria-label": "Signals of the run"});
  private readonly search = h("input", {type: "search", placeholder: "name, or expression: cart.position in mm", "aria-label": "Signal or expression with units"});
  private readonly list = h("ul", {class: "signal-names"});
  private readonly fault = h("p", {class: "signal-fault", role: "alert", hidden: true});
  private columns: Column[] = [];

  /** `add` resolves to the reason of a failure, else undefined; `leave` closes the list. */
  constructor(private readonly add: (source: string, inNew: boolean) => Promise<string | undefined>, leave: () => void) {
    this.element.append(h("div", {class: "signal-search"}, this.search), this.fault, this.list);
    listen(this.search, "input", () => this.show());
    listen(this.search, "keydown", (event: KeyboardEvent) => this.press(event));
    listen(this.list, "keydown", (event: KeyboardEvent) => this.walk(event));
    listen(this.element, "keydown", (event: KeyboardEvent) => { if (event.key === "Escape") leave(); });
  }

  fill(columns: Column[]): void {
    this.columns = columns;
    this.show();
  }

  focus(): void {
    this.search.focus();
  }

  private show(): void {
    const all = found(this.columns, this.search.value), more = all.length - most;
    this.fault.hidden = true;
    this.list.replaceChildren(...all.slice(0, most).map((column) => this.entry(column)), ...(more > 0 ? [h("li", {class: "more"}, `${more} more`)] : []),
      ...(all.length === 0 ? [h("li", {class: "more"}, "no such name; Enter adds the text as an expression")] : []));
  }

  private entry({name, unit, recorded}: Column): HTMLElement {
    const text = recorded ? "" : "not recorded";
    const entry = h("button", {type: "button", class: "plain signal", draggable: "true", title: "Drag into a scope; click adds it, Shift+click in a scope of its own"},
      h("span", {class: "signal-name"}, name), h("span", {class: "signal-unit"}, unit === "1" ? "" : unit), text && h("span", {class: "unseen"}, text));
    listen(entry, "click", (event: MouseEvent) => void this.take(name, event.shiftKey));
    listen(entry, "dragstart", (event: DragEvent) => {
      event.dataTransfer?.setData("text/plain", name);
      if (event.dataTransfer) event.dataTransfer.effectAllowed = "copy";
    });
    return h("li", {}, entry);
  }

  private async take(source: string, inNew: boolean): Promise<void> {
    const fault = await this.add(source, inNew);
    this.fault.hidden = fault === undefined;
    this.fault.textContent = fault ?? "";
  }

  private press(event: KeyboardEvent): void {
    const text = this.search.value.trim();
    if (event.key === "ArrowDown") this.list.querySelector("button")?.focus();
    else if (event.key === "Enter" && text) void this.take(this.chosen(text), event.shiftKey);
    else return;
    event.preventDefault();
  }

  /** Returns the only matching name, or the text as typed. */
  private chosen(text: string): string {
    const all = found(this.columns, text);
    return all.length === 1 && /^[\w.[\]]+$/.test(text) ? all[0].name : text;
  }

  private walk(event: KeyboardEvent): void {
    const all = [...this.list.querySelectorAll("button")], now = all.indexOf(document.activeElement as HTMLButtonElement);
    if (event.key === "ArrowDown") all[Math.min(now + 1, all.length - 1)]?.focus();
    else if (event.key === "ArrowUp") (now > 0 ? all[now - 1] : this.search).focus();
    else return;
    event.preventDefault();
  }
}
