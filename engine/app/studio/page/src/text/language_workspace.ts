import {type LSPClient, LSPPlugin, Workspace, type WorkspaceFile} from "@codemirror/lsp-client";
import type {Text, TransactionSpec} from "@codemirror/state";
import type {EditorView} from "@codemirror/view";
import type {Workbench} from "./workbench";

/** Converts the number of a file to its name at the language server. */
export const addressOf = (file: number) => `studio:/${file}`;
export const fileOf = (address: string) => Number(/^studio:\/(\d+)$/.exec(address)?.[1] ?? -1);

class OpenFile implements WorkspaceFile {
  constructor(readonly uri: string, readonly languageId: string, public version: number, public doc: Text, readonly view: EditorView) {}

  getView(): EditorView {
    return this.view;
  }
}

/** Workspace of the language server: the file in the editor is open; the server reads all others from the studio. */
export class LanguageWorkspace extends Workspace {
  files: OpenFile[] = [];
  private readonly versions = new Map<string, number>();

  constructor(client: LSPClient, private readonly workbench: Workbench) {
    super(client);
  }

  private next(uri: string): number {
    const version = (this.versions.get(uri) ?? 0) + 1;
    this.versions.set(uri, version);
    return version;
  }

  syncFiles() {
    return this.files.flatMap((file) => {
      const plugin = LSPPlugin.get(file.view), prevDoc = file.doc, changes = plugin?.unsyncedChanges;
      if (!plugin || !changes || changes.empty || plugin.uri !== file.uri) return [];
      file.doc = file.view.state.doc;
      file.version = this.next(file.uri);
      plugin.clear();
      return [{changes, file, prevDoc}];
    });
  }

  openFile(uri: string, languageId: string, view: EditorView): void {
    this.closeFile(uri);
    const file = new OpenFile(uri, languageId, this.next(uri), view.state.doc, view);
    this.files.push(file);
    this.client.didOpen(file);
  }

  closeFile(uri: string): void {
    if (!this.getFile(uri)) return;
    this.files = this.files.filter((file) => file.uri !== uri);
    this.client.didClose(uri);
  }

  override updateFile(uri: string, update: TransactionSpec): void {
    const document = this.workbench.document(fileOf(uri));
    if (document) this.workbench.dispatch(document, update);
  }

  override async displayFile(uri: string): Promise<EditorView | null> {
    const file = fileOf(uri);
    if (file < 0) return null;
    await this.workbench.activate(file);
    return this.workbench.editor(file) ?? null;
  }
}
