import {Fault} from "../connection/connection";
import type {Context} from "../shell/context";
import {openDialog} from "../shell/dialog";
import {h, listen} from "../shell/dom";
import {type BlockType, blockTypes} from "./reference";
import {referencePage} from "./reference_page";
import {found} from "./search";
import "./palette.css";

/** Target of an insertion: a file, its signals, and the preferred source of the first input. */
export interface Target {
  file: number;
  signals: string[];
  preferred: string;
}

/** Opens the searchable list of block types with their reference pages. The chosen type is inserted into the text of a file. */
export function openPalette(context: Context, target: Target): void {
  new Palette(context, target).open();
}

class Palette {
  private readonly query = h("input", {type: "search", placeholder: "Search blocks: gain, filter, spring …", "aria-label": "Search blocks", role: "combobox", "aria-expanded": true, "aria-controls": "palette-list", autocomplete: "off"});
  private readonly list = h("div", {class: "palette-list", role: "listbox", id: "palette-list", "aria-label": "Blocks"});
  private readonly page = h("div", {class: "palette-page", tabindex: 0, "aria-label": "Reference"});
  /** Choice of sources for the required inputs. */
  private readonly feeds = h("div", {class: "palette-feeds"});
  private readonly fault = h("p", {class: "palette-fault", role: "alert", hidden: true});
  private types: BlockType[] = [];
  private shown: BlockType[] = [];
  private chosen = 0;
  private dialog: HTMLDialogElement | undefined;

  constructor(private readonly context: Context, private readonly target: Target) {}

  open(): void {
    listen(this.query, "input", () => this.search());
    listen(this.query, "keydown", (event: KeyboardEvent) => this.press(event));
    this.dialog = openDialog("Insert a block", [h("div", {class: "palette"}, h("div", {class: "palette-side"}, this.query, this.list), this.page), this.feeds, this.fault],
      (close) => [h("button", {type: "button", onclick: close}, "Cancel"), h("button", {type: "button", class: "main", onclick: () => void this.insert()}, "Insert")]);
    this.query.focus();
    blockTypes(this.context.connection).then((types) => { this.types = types; this.search(); }, (thrown) => this.complain(thrown));
  }

  private search(): void {
    this.shown = found(this.types, this.query.value);
    this.chosen = 0;
    let folder = "";
    const parts: HTMLElement[] = [], hasGroups = this.query.value.trim() === "";
    this.shown.forEach((type, i) => {
      if (hasGroups && type.folder !== folder) parts.push(h("div", {class: "palette-group", role: "presentation"}, type.folder));
      folder = type.folder;
      parts.push(h("div", {class: "palette-entry", role: "option", id: `palette-${i}`, onclick: () => this.choose(i), ondblclick: () => void this.insert()},
        h("span", {class: "palette-name"}, type.name), " ", h("span", {class: "palette-doc"}, type.doc.split(/(?<=[.:;])\s/)[0])));
    });
    this.list.replaceChildren(...parts, ...(this.shown.length === 0 ? [h("p", {class: "empty"}, "No block matches.")] : []));
    this.choose(0);
  }

  private choose(index: number): void {
    this.chosen = Math.min(Math.max(0, index), this.shown.length - 1);
    this.list.querySelector("[aria-selected=true]")?.setAttribute("aria-selected", "false");
    const entry = this.list.querySelector(`#palette-${this.chosen}`), type = this.shown[this.chosen];
    entry?.setAttribute("aria-selected", "true");
    entry?.scrollIntoView({block: "nearest"});
    this.query.setAttribute("aria-activedescendant", `palette-${this.chosen}`);
    this.page.replaceChildren(...(type ? referencePage(type) : []));
    this.feeds.replaceChildren(...(type ? this.sources(type) : []));
  }

  private press(event: KeyboardEvent): void {
    const steps: Record<string, number> = {ArrowDown: 1, ArrowUp: -1, PageDown: 8, PageUp: -8};
    if (event.key === "Enter") void this.insert();
    else if (event.key in steps) this.choose(this.chosen + steps[event.key]);
    else return;
    event.preventDefault();
  }

  /** Creates a choice of sources for each required input. */
  private sources(type: BlockType): HTMLElement[] {
    const {signals, preferred} = this.target, required = type.inputs.filter(({optional}) => !optional);
    return required.map(({name, unit}, i) => {
      const select = h("select", {"data-input": name, "aria-label": `source of ${name}`}, h("option", {value: ""}, "not connected"), ...signals.map((signal) => h("option", {value: signal}, signal)));
      select.value = i === 0 ? preferred : "";
      return h("label", {}, `${name}${unit ? ` [${unit}]` : ""} ← `, select);
    });
  }

  private async insert(): Promise<void> {
    const type = this.shown[this.chosen], {file} = this.target, {workbench} = this.context;
    if (!type) return;
    const fed = [...this.feeds.querySelectorAll("select")].filter(({value}) => value !== "").map(({dataset, value}) => ({input: dataset.input, from: value}));
    try {
      const {name = type.name} = await workbench.splice(file, {kind: "insert", type: type.name, inputs: fed});
      this.dialog?.close();
      this.context.announce(`${name} is inserted`);
    } catch (thrown) {
      this.complain(thrown);
    }
  }

  private complain(thrown: unknown): void {
    this.fault.textContent = Fault.from(thrown).message;
    this.fault.hidden = false;
  }
}
