import {EditorView} from "@codemirror/view";
import type {Context, View} from "../shell/context";
import {showConflict} from "./conflict";
import {editing, nonced} from "./editor";
import {Language} from "./language";
import "./text.css";

/** The editor of the active text. */
export class TextView implements View {
  private readonly editor: EditorView;
  private readonly ends: (() => void)[];

  constructor(host: HTMLElement, private readonly context: Context) {
    const {workbench} = context;
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
      workbench.on("faults", ({file, faults}) => language.showFaults(file, faults)),
      workbench.on("conflict", ({document, text, hash}) => showConflict(context, document, text, hash)),
      context.shortcuts.add({key: "Ctrl+S", text: "save all changed texts", group: "Text", action: () => this.save()}),
    ];
  }

  dispose(): void {
    for (const end of this.ends) end();
    this.editor.destroy();
  }

  private save(): void {
    this.context.workbench.save().catch((fault) => this.context.notify(fault.message, "fault"));
  }
}
