import {EditorView} from "@codemirror/view";
import type {Context, View} from "../shell/context";
import {editing} from "./editor";
import "./text.css";

/** The editor of the active text. */
export class TextView implements View {
  private readonly editor: EditorView;
  private readonly ends: (() => void)[];

  constructor(host: HTMLElement, private readonly context: Context) {
    const {workbench} = context;
    this.editor = new EditorView({
      parent: host,
      dispatchTransactions: (transactions, view) => {
        view.update(transactions);
        if (workbench.active) workbench.took(workbench.active, transactions);
      },
    });
    workbench.attach(this.editor, (document) => editing(document.name, document.isWritable));
    this.ends = [context.shortcuts.add({key: "Ctrl+S", text: "save all changed texts", group: "Text", action: () => this.save()})];
  }

  dispose(): void {
    for (const end of this.ends) end();
    this.editor.destroy();
  }

  private save(): void {
    this.context.workbench.save().catch((fault) => this.context.notify(fault.message, "fault"));
  }
}
