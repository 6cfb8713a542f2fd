import type {Context} from "../shell/context";
import {h, listen} from "../shell/dom";
import {type BlockType, blockTypes, valueText} from "../palette/reference";
import {type Field, fieldsOf} from "./fields";
import type {Place} from "./places";
import type {Shape} from "./types";

/** Card for editing a block: its name and its scalar parameters. Enter writes a field into the text. */
export class BlockCard {
  private element: HTMLElement | undefined;

  constructor(private readonly host: HTMLElement, private readonly context: Context, private readonly closed: () => void) {}

  contains(target: EventTarget | null): boolean {
    return target instanceof Node && (this.element?.contains(target) ?? false);
  }

  close(): void {
    const had = this.contains(document.activeElement);
    this.element?.remove();
    this.element = undefined;
    if (had) this.closed();
  }

  async open(shape: Shape, place: Place, first: "name" | "value"): Promise<void> {
    const document = await this.context.workbench.open(place.file), fields = fieldsOf(document.state, place.range.from, place.range.to);
    const types = await blockTypes(this.context.connection).catch(() => [] as BlockType[]), type = types.find(({name}) => name === shape.type);
    this.close();
    const inputs = new Set([...(type?.inputs.map(({name}) => name) ?? []), ...shape.inputs.map(({port}) => port.split(".")[0])]), isOwn = (key: string) => key !== "block" && key !== "diagram" && !inputs.has(key);
    const rows = [this.row("name", place.name, "name; every use is renamed", (text) => this.rename(place, text))];
    const given = fields.filter(({key}) => isOwn(key)), rest = (type?.parameters ?? []).filter(({name}) => !fields.some(({key}) => key === name));
    for (const field of given) rows.push(this.field(field, place, type));
    for (const {name, default: other} of rest) rows.push(this.field({key: name, text: "", isScalar: true, from: 0, to: 0}, place, type, valueText(other)));
    const form = h("form", {onsubmit: (event: Event) => event.preventDefault()}, ...rows.flat());
    this.element = h("div", {class: "card", role: "dialog", "aria-label": `${place.name}, ${shape.type}`},
      h("div", {class: "card-head"}, h("h3", {}, place.name), h("button", {type: "button", class: "plain", "aria-label": "Close", onclick: () => this.close()}, "×")),
      h("p", {}, shape.type, type ? `: ${type.doc}` : ""), form,
      h("div", {class: "card-buttons"},
        h("button", {type: "button", onclick: () => { this.close(); void this.context.workbench.reveal(place.file, place.range.from, place.range.to, true); this.context.show("text"); }}, "Show in text"),
        h("button", {type: "button", onclick: () => void this.remove(place)}, "Delete")));
    for (const name of ["pointerdown", "wheel", "dblclick"]) listen(this.element, name, (event: Event) => event.stopPropagation());
    listen(this.element, "keydown", (event: KeyboardEvent) => { if (event.key === "Escape") { event.stopPropagation(); this.close(); } });
    this.host.append(this.element);
    const boxes = [...form.querySelectorAll("input:not([readonly])")] as HTMLInputElement[], focused = first === "name" ? boxes[0] : boxes[1] ?? boxes[0];
    focused?.focus();
    focused?.select();
  }

  private field({key, text, isScalar}: Field, place: Place, type: BlockType | undefined, placeholder = ""): HTMLElement[] {
    const reference = type?.parameters.find(({name}) => name === key), doc = reference ? `${reference.doc}${reference.unit ? ` [${reference.unit}]` : ""}` : "";
    if (!isScalar) return this.row(key, text, doc, undefined);
    return this.row(key, text, doc, (value) => this.context.workbench.splice(place.file, {kind: "number", name: `${place.name}.${key}`, text: value}), placeholder);
  }

  /** Creates a label and a field that is written on Enter or on losing the focus; without `write` it is read-only. */
  private row(key: string, text: string, doc: string, write: ((text: string) => Promise<unknown>) | undefined, placeholder = ""): HTMLElement[] {
    const id = `card-${key}`, input = h("input", {type: "text", id, value: text, title: doc, readonly: write === undefined, spellcheck: "false", autocomplete: "off", placeholder});
    const wrong = h("div", {class: "wrong", role: "alert", hidden: true});
    let written = text;
    const attempt = async () => {
      if (!write || input.value === written) return;
      try {
        await write(input.value);
        written = input.value;
        wrong.hidden = true;
        this.context.announce(`${key} is ${written}`);
      } catch (thrown) {
        wrong.textContent = (thrown as Error).message;
        wrong.hidden = false;
      }
    };
    listen(input, "change", () => void attempt());
    return [h("label", {for: id, title: doc}, key), input, wrong];
  }

  private async rename(place: Place, to: string): Promise<void> {
    await this.context.workbench.splice(place.file, {kind: "rename", name: place.name, to});
    this.element?.querySelector("h3")?.replaceChildren(to);
    place.name = to;
  }

  private async remove({file, name}: Place): Promise<void> {
    try {
      await this.context.workbench.splice(file, {kind: "delete", name});
      this.close();
    } catch (thrown) {
      this.context.notify((thrown as Error).message, "fault");
    }
  }
}
