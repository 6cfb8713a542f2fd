import {EditorView} from "@codemirror/view";
import type {Context, View} from "../shell/context";
import type {Document} from "./document";
import {showConflict} from "./conflict";
import {h} from "../shell/dom";
import {editing, nonced} from "./editor";
import {Language} from "./language";
import "./text.css";

/** Editor of the active text. */
export class TextView implements View {
  private readonly editor: EditorView;
  /** Open texts; the one in the editor is marked. */
  private readonly files = h("nav", {class: "text-files", "aria-label": "Open texts"});
  private readonly ends: (() => void)[];

  constructor(host: HTMLElement, private readonly context: Context) {
    const {workbench} = context;
    host.append(this.files);
    this.editor = new EditorView({
      parent: host, extensions: nonced(),
      dispatchTransactions: (transactions, view) => {
        view.update(transactions);
        if (workbench.active) workbench.took(workbench.active, transactions);
      },
    });
    const language = new Language(context.connection, workbench, context.notify);
    workbench.attach(this.editor, (document) => [editing(document.name, document.isWritable), language.extensions(document)]);
    this.ends = [
      workbench.on("active", () => this.list()), workbench.on("files", () => this.list()), workbench.on("changed", () => this.list()),
      workbench.on("faults", ({file, faults}) => language.showFaults(file, faults)),
      workbench.on("conflict", (conflict) => showConflict(context, conflict)),
      context.shortcuts.add({key: "Ctrl+S", text: "save all changed texts", group: "Text", action: () => this.save()}),
    ];
    this.list();
  }

  dispose(): void {
    for (const end of this.ends) end();
    this.editor.destroy();
  }

  private list(): void {
    const {workbench} = this.context, text = ({name, isChanged}: Document) => `${name}${isChanged ? " •" : ""}`;
    const shown = workbench.openDocuments.map((document) => `${document.file} ${text(document)} ${document === workbench.active}`).join();
    if (this.files.dataset.shown === shown) return;
    this.files.dataset.shown = shown;
    this.files.replaceChildren(...workbench.openDocuments.map((document) =>
      h("button", {type: "button", class: "plain", "aria-current": document === workbench.active ? "true" : null, title: document.isChanged ? "not saved yet" : "saved", onclick: () => void workbench.activate(document.file)}, text(document))));
  }

  private save(): void {
    this.context.workbench.saving.save().catch((fault) => this.context.notify(fault.message, "fault"));
  }
}
