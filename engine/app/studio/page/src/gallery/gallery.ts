import {Fault} from "../connection/connection";
import type {Context} from "../shell/context";
import {openDialog} from "../shell/dialog";
import {h, listen} from "../shell/dom";
import {type Entry, found} from "./search";
import "./gallery.css";

/** Titles of groups; the server names groups by their folders. */
const titles: Record<string, string> = {examples: "Examples, one idea each", thesis: "Figures and tables of the thesis", parts: "Parts"};

/** Opens the list of examples and figures of the thesis. The chosen one is copied beside the file of the studio and opened. */
export function openGallery(context: Context): void {
  new Gallery(context).open();
}

/** Copies an entry and opens the copy. Rejects with a Fault. */
export async function startFrom(context: Context, {entry}: Entry, name: string): Promise<void> {
  const {file} = await context.connection.call<{file: number}>("gallery.copy", {entry, name});
  await context.workbench.listFiles();
  await context.workbench.setRoot(file);
}

class Gallery {
  private readonly query = h("input", {type: "search", placeholder: "Search: damper, sweep, figure 38 …", "aria-label": "Search examples", role: "combobox", "aria-expanded": true, "aria-controls": "gallery-list", autocomplete: "off"});
  private readonly list = h("div", {class: "gallery-list", role: "listbox", id: "gallery-list", "aria-label": "Examples"});
  private readonly name = h("input", {type: "text", "aria-label": "Name of the copy", spellcheck: "false", autocomplete: "off"});
  private readonly fault = h("p", {class: "gallery-fault", role: "alert", hidden: true});
  private dialog: HTMLDialogElement | undefined;
  private entries: Entry[] = [];
  private shown: Entry[] = [];
  private chosen = 0;

  constructor(private readonly context: Context) {}

  open(): void {
    listen(this.query, "input", () => this.search());
    for (const field of [this.query, this.name]) listen(field, "keydown", (event: KeyboardEvent) => this.press(event));
    const copy = h("label", {class: "gallery-name"}, "Copy to ", this.name);
    this.dialog = openDialog("Start from an example", [this.query, this.list, copy, this.fault],
      (close) => [h("button", {type: "button", onclick: close}, "Cancel"), h("button", {type: "button", class: "main", onclick: () => void this.start()}, "Copy and open")]);
    this.query.focus();
    const byNumber = (a: Entry, b: Entry) => a.group.localeCompare(b.group) || a.name.localeCompare(b.name, "en", {numeric: true});
    this.context.connection.call<{entries: Entry[]}>("gallery").then(({entries}) => { this.entries = entries.sort(byNumber); this.search(); }, (thrown) => this.complain(thrown));
  }

  private search(): void {
    const all = found(this.entries, this.query.value), groups = [...new Set(all.map(({group}) => group))];
    this.shown = groups.flatMap((group) => all.filter((entry) => entry.group === group));
    const parts = groups.map((group) => {
      const title = titles[group] ?? group, options = this.shown.flatMap((entry, i) => (entry.group === group ? [this.option(entry, i)] : []));
      return h("div", {role: "group", "aria-label": title}, h("div", {class: "gallery-group", "aria-hidden": true}, title), ...options);
    });
    this.list.replaceChildren(...parts, ...(this.shown.length === 0 ? [h("p", {class: "empty"}, "Nothing matches.")] : []));
    this.choose(0);
  }

  private option({name, title, caption}: Entry, i: number): HTMLElement {
    return h("div", {class: "gallery-entry", role: "option", id: `gallery-${i}`, onclick: () => this.choose(i), ondblclick: () => void this.start()},
      h("span", {class: "gallery-title"}, title), " ", h("span", {class: "gallery-file"}, name), caption ? h("span", {class: "gallery-caption"}, caption) : null);
  }

  private choose(index: number): void {
    this.chosen = Math.min(Math.max(0, index), this.shown.length - 1);
    for (const one of this.list.querySelectorAll("[aria-selected]")) one.removeAttribute("aria-selected");
    const option = this.list.querySelector(`#gallery-${this.chosen}`), entry = this.shown[this.chosen];
    option?.setAttribute("aria-selected", "true");
    option?.scrollIntoView({block: "nearest"});
    this.query.setAttribute("aria-activedescendant", `gallery-${this.chosen}`);
    if (entry) this.name.value = entry.name.replace(/^.*\//, "").replace(/\.yaml$/, "") + ".yaml";
  }

  private press(event: KeyboardEvent): void {
    const steps: Record<string, number> = {ArrowDown: 1, ArrowUp: -1, PageDown: 8, PageUp: -8};
    if (event.key === "Enter") void this.start();
    else if (event.key in steps) this.choose(this.chosen + steps[event.key]);
    else return;
    event.preventDefault();
  }

  private async start(): Promise<void> {
    const entry = this.shown[this.chosen];
    if (!entry) return;
    try {
      await startFrom(this.context, entry, this.name.value.trim());
      this.dialog?.close();
      this.context.announce(`${entry.title} is open`);
    } catch (thrown) {
      this.complain(thrown);
    }
  }

  private complain(thrown: unknown): void {
    this.fault.textContent = Fault.from(thrown).message;
    this.fault.hidden = false;
  }
}
