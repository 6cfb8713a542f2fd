// The language server over the call `language`: faults with quick fixes, completion, hover, definition, references, rename.

import {autocompletion} from "@codemirror/autocomplete";
import {findReferencesKeymap, jumpToDefinitionKeymap, LSPClient, LSPPlugin, serverCompletionSource} from "@codemirror/lsp-client";
import {type Diagnostic, forEachDiagnostic, setDiagnostics} from "@codemirror/lint";
import {isolateHistory} from "@codemirror/commands";
import type {Extension, Text} from "@codemirror/state";
import {type Command, EditorView, hoverTooltip, keymap, showDialog} from "@codemirror/view";
import {type Connection, type DiagramFault, Fault} from "../connection/connection";
import {openMenu} from "../shell/menu";
import type {Document} from "./document";
import {addressOf, fileOf, LanguageWorkspace} from "./language_workspace";
import {markupNodes} from "./markup";
import type {Workbench} from "./workbench";

interface Position { line: number; character: number }
interface Range { start: Position; end: Position }
interface ServerDiagnostic { range: Range; severity?: number; message: string }
interface TextEdit { range: Range; newText: string }
interface WorkspaceEdit { changes?: Record<string, TextEdit[]> }
interface CodeAction { title: string; diagnostics?: ServerDiagnostic[]; edit?: WorkspaceEdit }

const severities = ["error", "error", "warning", "info", "info"] as const;

function offsetOf(doc: Text, {line, character}: Position): number {
  if (line >= doc.lines) return doc.length;
  const {from, length} = doc.line(line + 1);
  return from + Math.min(character, length);
}

const positionOf = (doc: Text, offset: number): Position => {
  const line = doc.lineAt(offset);
  return {line: line.number - 1, character: offset - line.from};
};

/** Replaces Markdown in completions by plain text, which the library escapes; it would turn Markdown into HTML. */
function plainDocumentation(message: any): unknown {
  for (const {documentation} of message.result?.items ?? []) if (documentation?.kind === "markdown") documentation.kind = "plaintext";
  return message;
}

export class Language {
  private readonly client: LSPClient;
  /** True after the language server has answered; until then the drawing's faults are shown. */
  private isThere = false;
  private readonly receivers = new Set<(message: string) => void>();

  constructor(private readonly connection: Connection, private readonly workbench: Workbench, private readonly notify: (text: string, kind?: "fault") => void) {
    this.client = new LSPClient({
      rootUri: "studio:/", timeout: 10000, workspace: (client) => new LanguageWorkspace(client, workbench),
      notificationHandlers: {
        "textDocument/publishDiagnostics": (_, {uri, diagnostics, version}) => { void this.publish(fileOf(uri), diagnostics, version); return true; },
        "window/showMessage": (_, {message}) => { notify(message); return true; },
      },
    });
    connection.on("language", ({message}) => { for (const receive of [...this.receivers]) receive(JSON.stringify(plainDocumentation(message))); });
    connection.on("connection", ({state}) => (state === "open" ? void this.connect() : this.leave()));
    connection.on("faults", ({file, faults}) => this.showFaults(file, faults));
    workbench.on("changed", () => { if (this.isThere) this.client.sync(); });
    if (connection.state === "open") void this.connect();
  }

  /** Returns the editor extensions for a document. */
  extensions(document: Document): Extension {
    return [
      this.client.plugin(addressOf(document.file), "yaml"), autocompletion({override: [(at) => (this.isThere ? serverCompletionSource(at) : null)]}), hoverTooltip((view, at) => this.hover(view, at), {hideOnChange: true}),
      keymap.of([...jumpToDefinitionKeymap, ...findReferencesKeymap, {key: "F2", run: this.rename, preventDefault: true}, {key: "Ctrl-.", mac: "Cmd-.", run: this.mend, preventDefault: true}]),
    ];
  }

  /** Shows faults of the checker while there is no language server. */
  showFaults(file: number, faults: DiagramFault[]): void {
    const document = this.workbench.document(file);
    if (this.isThere || !document) return;
    const {doc} = document.state;
    this.show(document, faults.filter(({file: path}) => path.endsWith(document.name)).map(({line, column, end, text, cure}) => {
      const from = offsetOf(doc, {line: line - 1, character: column - 1}), to = end ? offsetOf(doc, {line: end.line - 1, character: end.column - 1}) : from;
      return {from, to: Math.max(from, to), severity: "error", message: cure ? `${text}; ${cure}` : text};
    }));
  }

  /** Tests whether a language server exists, by a message that it may ignore. */
  private async connect(): Promise<void> {
    try {
      await this.connection.call("language", {message: {jsonrpc: "2.0", method: "$/hello"}});
    } catch {
      return;
    }
    this.client.connect({
      send: (message) => void this.connection.call("language", {message: JSON.parse(message)}).catch((thrown) => this.refused(Fault.from(thrown))),
      subscribe: (receive) => { this.receivers.add(receive); },
      unsubscribe: (receive) => { this.receivers.delete(receive); },
    });
    this.client.initializing.then(() => { this.isThere = true; }, () => {});
  }

  private leave(): void {
    this.isThere = false;
    if (this.client.connected) this.client.disconnect();
  }

  private refused(fault: Fault): void {
    if (this.isThere) this.notify(`the language server refuses a message: ${fault.message}`, "fault");
  }

  // --- faults ---

  private async publish(file: number, diagnostics: ServerDiagnostic[], version?: number): Promise<void> {
    if (file < 0) return;
    const open = this.client.workspace.getFile(addressOf(file));
    if (open && version !== undefined && version !== open.version) return;
    const document = await this.workbench.open(file), plain = this.converted(document, diagnostics, []);
    this.show(document, plain);
    if (!open || diagnostics.length === 0) return;
    const actions = await this.actions(file, document.state.doc);
    if (open.version === version || version === undefined) this.show(document, this.converted(document, diagnostics, actions));
  }

  private actions(file: number, doc: Text): Promise<CodeAction[]> {
    const range = {start: {line: 0, character: 0}, end: positionOf(doc, doc.length)};
    return this.client.request<object, CodeAction[] | null>("textDocument/codeAction", {textDocument: {uri: addressOf(file)}, range, context: {diagnostics: []}}).then((all) => all ?? [], () => []);
  }

  private converted(document: Document, diagnostics: ServerDiagnostic[], actions: CodeAction[]): Diagnostic[] {
    const plugin = this.workbench.editor(document.file) ? LSPPlugin.get(this.workbench.editor(document.file)!) : null;
    const isOpen = plugin?.uri === addressOf(document.file), doc = isOpen ? plugin!.syncedDoc : document.state.doc;
    const place = (position: Position, side: number) => (isOpen ? plugin!.unsyncedChanges.mapPos(offsetOf(doc, position), side) : offsetOf(doc, position));
    return diagnostics.map(({range, severity = 1, message}) => {
      const own = actions.filter(({edit, diagnostics: all = []}) => edit && all.some((one) => one.message === message && JSON.stringify(one.range) === JSON.stringify(range)));
      const from = place(range.start, 1);
      return {
        from, to: Math.max(from, place(range.end, -1)), severity: severities[severity] ?? "info", message,
        actions: own.map(({title, edit}) => ({name: title, apply: () => void this.apply(edit!)})),
      };
    });
  }

  private show(document: Document, diagnostics: Diagnostic[]): void {
    this.workbench.dispatch(document, setDiagnostics(document.state, diagnostics));
    this.workbench.setMarks(document.file, diagnostics.map(({from, to, message, severity}) => ({from, to, message, severity: severity === "hint" ? "info" : severity})));
  }

  /** Opens the quick fixes of the fault at the cursor, or of the next one. */
  private readonly mend: Command = (view) => {
    const found: {diagnostic: Diagnostic; from: number; to: number}[] = [], {head} = view.state.selection.main;
    forEachDiagnostic(view.state, (diagnostic, from, to) => { if (diagnostic.actions?.length && to >= head) found.push({diagnostic, from, to}); });
    const next = found.sort((a, b) => a.from - b.from)[0];
    if (!next) return false;
    const apply = (action: NonNullable<Diagnostic["actions"]>[number]) => action.apply(view, next.from, next.to), actions = next.diagnostic.actions!;
    const box = view.coordsAtPos(next.from);
    if (actions.length === 1) apply(actions[0]);
    else openMenu({x: box?.left ?? 100, y: box?.bottom ?? 100}, actions.map((action): [string, () => void] => [action.name, () => apply(action)]), "Quick fixes");
    return true;
  };

  // --- edits of several files ---

  /** Applies edits proposed by the server in all files, as one undo step per file. */
  private async apply({changes = {}}: WorkspaceEdit): Promise<void> {
    for (const [uri, edits] of Object.entries(changes)) {
      if (fileOf(uri) < 0) continue;
      const document = await this.workbench.open(fileOf(uri)), {doc} = document.state;
      this.workbench.dispatch(document, {
        changes: edits.map(({range, newText}) => ({from: offsetOf(doc, range.start), to: offsetOf(doc, range.end), insert: newText})),
        userEvent: "input.language", annotations: isolateHistory.of("full"),
      });
    }
  }

  private readonly rename: Command = (view) => {
    const {head} = view.state.selection.main, file = this.workbench.active?.file, word = view.state.wordAt(head);
    if (!word || file === undefined || !this.isThere) return false;
    const {close, result} = showDialog(view, {label: "New name, everywhere", input: {name: "name", value: view.state.sliceDoc(word.from, word.to)}, focus: true, submitLabel: "Rename"});
    void result.then((form) => {
      view.dispatch({effects: close});
      view.focus();
      if (form) void this.renameAt(file, positionOf(view.state.doc, word.from), (form.elements.namedItem("name") as HTMLInputElement).value);
    });
    return true;
  };

  private async renameAt(file: number, position: Position, newName: string): Promise<void> {
    this.client.sync();
    try {
      const edit = await this.client.request<object, WorkspaceEdit | null>("textDocument/rename", {textDocument: {uri: addressOf(file)}, position, newName});
      if (edit) await this.apply(edit);
    } catch (thrown) {
      this.notify(Fault.from(thrown).message, "fault");
    }
  }

  private async hover(view: EditorView, at: number) {
    const plugin = LSPPlugin.get(view);
    if (!plugin || !this.isThere) return null;
    this.client.sync();
    const found = await this.client.request<object, {contents: {kind: "markdown" | "plaintext"; value: string}; range?: Range} | null>("textDocument/hover", {textDocument: {uri: plugin.uri}, position: plugin.toPosition(at)}).catch(() => null);
    if (!found) return null;
    const {doc} = view.state, dom = document.createElement("div");
    dom.className = "cm-hover";
    dom.append(...(found.contents.kind === "markdown" ? markupNodes(found.contents.value) : [document.createTextNode(found.contents.value)]));
    return {pos: found.range ? offsetOf(doc, found.range.start) : at, end: found.range ? offsetOf(doc, found.range.end) : at, above: true, create: () => ({dom})};
  }
}
