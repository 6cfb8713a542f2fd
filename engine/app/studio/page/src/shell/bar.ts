import type {Context} from "./context";
import {h, listen} from "./dom";
import {openMenu} from "./menu";
import {showShortcuts} from "./shortcut_list";
import type {Choice} from "./theme";

/** Time without the server after which the page names another possible cause [ms]. */
const longLost = 10000;

/** Top bar: the diagram, the run, and actions of the whole page. */
export class Bar {
  readonly element = h("header", {class: "bar"});
  /** Host of the run's bar. */
  readonly run = h("div", {class: "bar-run"});
  private readonly files = h("select", {"aria-label": "Diagram"});
  private readonly save = h("button", {type: "button", class: "plain", title: "Save (Ctrl+S)"}, "Save");
  private readonly lost = h("span", {class: "connection", role: "status", hidden: true}, "no connection; reconnecting");
  private readonly more = h("button", {type: "button", class: "plain", "aria-label": "More", title: "More", "aria-haspopup": "menu"}, "☰");
  /** Further entries of the menu, beside the page's own ones. */
  readonly entries: [string, () => void][] = [];

  constructor(private readonly context: Context) {
    const keys = h("button", {type: "button", class: "plain", title: "Keys (?)", "aria-label": "Keys", onclick: () => showShortcuts(context.shortcuts)}, "?");
    this.element.append(
      h("div", {class: "bar-file"}, h("span", {class: "brand"}, "Stepwire"), this.files, this.save), this.run,
      h("div", {class: "bar-end"}, this.lost, keys, this.more));
    listen(this.files, "change", () => void this.choose());
    listen(this.save, "click", () => void context.workbench.saving.save().catch((fault) => context.notify(fault.message, "fault")));
    listen(this.more, "click", () => this.open());
    context.workbench.on("files", () => this.list());
    context.workbench.on("root", () => this.list());
    context.workbench.on("changed", () => this.mark());
    context.connection.on("connection", ({state}) => this.showLost(state === "open"));
    context.shortcuts.add({key: "?", text: "list of keys", action: () => showShortcuts(context.shortcuts)});
    this.mark();
  }

  /** Shows the loss of the connection. A restarted studio has a new address, so waiting does not help then. */
  private showLost(isOpen: boolean): void {
    this.lost.hidden = isOpen;
    clearTimeout(this.timer);
    this.lost.textContent = "no connection; reconnecting";
    if (!isOpen) this.timer = window.setTimeout(() => { this.lost.textContent = "no connection; reconnecting. A restarted studio has a new address"; }, longLost);
  }
  private timer: number | undefined;

  private list(): void {
    const {files, root, changedFiles} = this.context.workbench, changed = new Set(changedFiles.map(({file}) => file));
    this.files.replaceChildren(...files.map(({file, name, part}) =>
      h("option", {value: file, selected: file === root}, (part ? "part " : "") + name + (changed.has(file) ? " •" : ""))));
    this.files.value = String(root);
    this.mark();
  }

  private mark(): void {
    const changed = this.context.workbench.changedFiles;
    this.save.disabled = changed.length === 0;
    this.save.title = changed.length === 0 ? "All changes are saved" : `Save ${changed.map(({name}) => name).join(", ")} (Ctrl+S)`;
    const name = this.context.workbench.main >= 0 ? this.context.workbench.nameOf(this.context.workbench.root) : "";
    document.title = `${changed.length > 0 ? "• " : ""}${name ? `${name} - ` : ""}Stepwire studio`;
  }

  /** Draws and runs the selected diagram. A part is only opened as a text; the drawn and running diagram remains. */
  private async choose(): Promise<void> {
    const {workbench, notify} = this.context, file = Number(this.files.value), isPart = workbench.files.some((one) => one.file === file && one.part);
    try {
      if (!isPart) return await workbench.setRoot(file);
      this.files.value = String(workbench.root);
      await workbench.activate(file);
      this.context.show("text");
    } catch (thrown) {
      this.files.value = String(workbench.root);
      notify((thrown as Error).message, "fault");
    }
  }

  private open(): void {
    const {theme, settings} = this.context, own = theme.choice;
    const color = (choice: Choice, text: string): [string, () => void] =>
      [`${own === choice ? "● " : ""}${text}`, () => { theme.choose(choice); settings.set("theme", choice); }];
    openMenu(this.more, [...this.drafts(), ...this.entries, color("system", "System colours"), color("light", "Light"), color("dark", "Dark")]);
  }

  /** Returns the entries that discard unsaved texts. */
  private drafts(): [string, () => void][] {
    const {workbench, notify} = this.context;
    return workbench.changedFiles.map((document) => [`Discard the draft of ${document.name}`, () => void workbench.saving.discard(document).then(() => notify(`${document.name} has the text of the file again`), (fault) => notify(fault.message, "fault"))]);
  }
}
