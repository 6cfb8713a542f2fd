import {Fault} from "../connection/connection";
import type {Context} from "../shell/context";
import {openDialog} from "../shell/dialog";
import {h, listen} from "../shell/dom";
import {type BlockType, blockTypes} from "./reference";
import {referencePage} from "./reference_page";
import {found} from "./search";
import "./palette.css";

/** A list of all types of blocks to search in, with the page of each; the chosen one is inserted into the text of a file. */
export function openPalette(context: Context, file: number): void {
  new Palette(context, file).open();
}

class Palette {
  private readonly query = h("input", {type: "search", placeholder: "Search blocks: gain, filter, spring …", "aria-label": "Search blocks", role: "combobox", "aria-expanded": true, "aria-controls": "palette-list", autocomplete: "off"});
  private readonly list = h("div", {class: "palette-list", role: "listbox", id: "palette-list", "aria-label": "Blocks"});
  private readonly page = h("div", {class: "palette-page", tabindex: 0, "aria-label": "Reference"});
  private readonly fault = h("p", {class: "palette-fault", role: "alert", hidden: true});
  private types: BlockType[] = [];
  private shown: BlockType[] = [];
  private chosen = 0;
  private dialog: HTMLDialogElement | undefined;

  constructor(private readonly context: Context, private readonly file: number) {}

  open(): void {
    listen(this.query, "input", () => this.search());
    listen(this.query, "keydown", (event: KeyboardEvent) => this.press(event));
    this.dialog = openDialog("Insert a block", [h("div", {class: "palette"}, h("div", {class: "palette-side"}, this.query, this.list), this.page), this.fault],
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
    this.list.replaceChildren(...parts, ...(this.shown.length === 0 ? [h("p", {class: "empty"}, "No block has these words.")] : []));
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
  }

  private press(event: KeyboardEvent): void {
    const steps: Record<string, number> = {ArrowDown: 1, ArrowUp: -1, PageDown: 8, PageUp: -8};
    if (event.key === "Enter") void this.insert();
    else if (event.key in steps) this.choose(this.chosen + steps[event.key]);
    else return;
    event.preventDefault();
  }

  private async insert(): Promise<void> {
    const type = this.shown[this.chosen];
    if (!type) return;
    try {
      const {name} = await this.context.workbench.splice(this.file, {kind: "insert", type: type.name});
      this.dialog?.close();
      this.context.announce(`${name ?? type.name} is inserted`);
    } catch (thrown) {
      this.complain(thrown);
    }
  }

  private complain(thrown: unknown): void {
    this.fault.textContent = Fault.from(thrown).message;
    this.fault.hidden = false;
  }
}
