// Open files, their edits, and the active one. Drawing, tuning and palette make their edits through it, so that all share one undo history.

import {isolateHistory} from "@codemirror/commands";
import {EditorSelection, EditorState, type Extension, Transaction, type TransactionSpec} from "@codemirror/state";
import {EditorView} from "@codemirror/view";
import {type Connection, type DiagramFault, Fault} from "../connection/connection";
import {type Change, setOf} from "./differences";
import {Document, type Opened, textOf} from "./document";
import {type Conflict, Saving} from "./saving";
import {TextSync} from "./text_sync";

export interface FileEntry {
  file: number;
  name: string;
  writable: boolean;
  part: boolean;
}

/** Scrolls to a range, to its begin where it is wider than the view. The margin keeps the first letters of lines in sight. */
const scrollTo = (from: number, to: number) => EditorView.scrollIntoView(EditorSelection.range(to, from), {xMargin: 24});

/** Fault with its range in the text of a file [UTF-16 offsets]. */
export interface Mark {
  from: number;
  to: number;
  message: string;
  severity: "error" | "warning" | "info";
}

export interface WorkbenchEvents {
  /** Another file is in the editor. */
  active: Document;
  /** Another diagram is drawn and run. */
  root: number;
  /** A text changed, by this page or remotely. */
  changed: Document;
  /** Maps positions in a text to those after a change. */
  moved: {file: number; at: (position: number, side: number) => number};
  /** The server has all changes of a file. */
  synced: Document;
  /** The list of files or their save states changed. */
  files: FileEntry[];
  selected: {file: number; from: number; to: number};
  marks: {file: number; marks: Mark[]};
  /** Faults of a diagram from the checker; [] if it loads. */
  faults: {file: number; faults: DiagramFault[]};
  conflict: Conflict;
}

export class Workbench {
  private readonly documents = new Map<number, Document>();
  private readonly listeners = new Map<keyof WorkbenchEvents, Set<(event: any) => void>>();
  private readonly sync: TextSync;
  readonly saving: Saving;
  private readonly marks = new Map<number, Mark[]>();
  private view: EditorView | undefined;
  private extensions: (document: Document) => Extension = () => [];
  files: FileEntry[] = [];
  /** File with which the studio was started. */
  main = -1;
  /** Diagram that is drawn and run. */
  root = -1;
  active: Document | undefined;

  constructor(private readonly connection: Connection, private readonly notify: (text: string, kind?: "note" | "fault") => void) {
    this.sync = new TextSync(connection, notify, {
      documents: () => this.documents, dispatch: (document, spec) => this.dispatch(document, spec), synced: (document) => this.emit("synced", document),
    });
    this.saving = new Saving(connection, this.sync, notify, {
      document: (file) => this.documents.get(file), changed: () => this.changedFiles, dispatch: (document, spec) => this.dispatch(document, spec),
      synced: (document) => this.emit("synced", document), kept: () => this.emit("files", this.files), conflict: (conflict) => this.emit("conflict", conflict),
    });
  }

  on<Name extends keyof WorkbenchEvents>(name: Name, listener: (event: WorkbenchEvents[Name]) => void): () => void {
    const own = this.listeners.get(name) ?? new Set();
    this.listeners.set(name, own.add(listener));
    return () => own.delete(listener);
  }

  private emit<Name extends keyof WorkbenchEvents>(name: Name, event: WorkbenchEvents[Name]): void {
    for (const listener of [...(this.listeners.get(name) ?? [])]) listener(event);
  }

  /** Opens the file with which the studio was started. */
  async start(main: number): Promise<void> {
    this.main = main;
    await this.listFiles();
    await this.setRoot(main);
  }

  async listFiles(): Promise<void> {
    this.files = (await this.connection.call<{files: FileEntry[]}>("files")).files;
    this.emit("files", this.files);
  }

  nameOf(file: number): string {
    return this.documents.get(file)?.name ?? this.files.find((one) => one.file === file)?.name ?? `file ${file}`;
  }

  /** Shows the active document in the editor. `extensions` returns the editor extensions of a document. */
  attach(view: EditorView, extensions: (document: Document) => Extension): void {
    this.view = view;
    this.extensions = extensions;
    for (const document of this.documents.values()) document.state = this.stateOf(document, document.state.doc.toString());
    if (this.active) view.setState(this.active.state);
  }

  /** Draws and runs another diagram, and shows its text. */
  async setRoot(file: number): Promise<void> {
    await this.activate(file);
    if (file === this.root) return;
    this.root = file;
    this.emit("root", file);
  }

  /** Shows the text of a file. */
  async activate(file: number): Promise<Document> {
    const document = await this.open(file);
    if (document === this.active) return document;
    this.active = document;
    this.view?.setState(document.state);
    this.emit("active", document);
    return document;
  }

  /** Opens a file with its text, or its draft if there is one. */
  async open(file: number): Promise<Document> {
    const known = this.documents.get(file);
    if (known) return known;
    const opened = await this.connection.call<Opened>("open", {file});
    const again = this.documents.get(file);
    if (again) return again;
    const entry = this.files.find((one) => one.file === file);
    const document = new Document(file, opened.name ?? entry?.name ?? String(file), {...opened, writable: opened.writable ?? entry?.writable});
    document.state = this.stateOf(document, opened.draft ?? opened.text);
    this.documents.set(file, document);
    if (opened.draft !== null && opened.draft !== opened.text) this.notify(`${document.name}: your unsaved draft is shown`);
    return document;
  }

  document(file: number): Document | undefined {
    return this.documents.get(file);
  }

  editor(file: number): EditorView | undefined {
    return this.active?.file === file ? this.view : undefined;
  }

  get openDocuments(): Document[] {
    return [...this.documents.values()];
  }

  get changedFiles(): Document[] {
    return this.openDocuments.filter((document) => document.isChanged);
  }

  /** Resolves when the server has all present texts. */
  whenSynced(): Promise<unknown> {
    return Promise.all(this.openDocuments.map((document) => this.sync.whenSynced(document)));
  }

  private stateOf(document: Document, text: string): EditorState {
    return EditorState.create({doc: textOf(text), extensions: [EditorState.lineSeparator.of("\n"), this.extensions(document)]});
  }

  /** Edits a document, in the editor or in the background. */
  dispatch(document: Document, spec: TransactionSpec): void {
    if (document === this.active && this.view) return this.view.dispatch(spec);
    this.took(document, [document.state.update(spec)]);
  }

  /** Records transactions of the editor. */
  took(document: Document, transactions: readonly Transaction[]): void {
    document.state = transactions[transactions.length - 1].state;
    const changed = transactions.filter((one) => one.docChanged);
    for (const one of changed) if (!one.annotation(Transaction.remote)) document.add(one.changes);
    if (changed.length > 0) this.moveRanges(document, changed);
    if (transactions.some((one) => one.selection) || changed.length > 0) this.emitSelection(document);
    if (changed.length === 0) return;
    this.emit("changed", document);
    void this.sync.send(document);
  }

  private emitSelection(document: Document): void {
    const {from, to} = document.state.selection.main;
    if (document === this.active) this.emit("selected", {file: document.file, from, to});
  }

  /** Applies changes proposed by the server, as one undo step per file; they refer to the texts `at`. */
  private async applyListed(changes: (Change & {file?: number})[], file: number, at: Map<number, Document["base"]>): Promise<void> {
    const files = new Set(changes.map((one) => one.file ?? file));
    for (const one of files) {
      const document = await this.open(one), base = at.get(one) ?? document.base;
      const set = setOf(changes.filter((change) => (change.file ?? file) === one), base.length);
      if (!document.state.doc.eq(base)) throw new Fault(`${document.name} was changed meanwhile`, "try it again");
      const first = changes.find((change) => (change.file ?? file) === one);
      this.dispatch(document, {changes: set, annotations: isolateHistory.of("full"), userEvent: "input.splice",
        selection: first ? {anchor: set.mapPos(first.from, 1)} : undefined,
        effects: first ? scrollTo(set.mapPos(first.from, -1), set.mapPos(first.from, 1)) : undefined});
    }
  }

  /** Requests a small edit of a diagram. The server returns changes of the text, or refuses edits that would change more. */
  async splice(file: number, edit: {kind: string; [key: string]: unknown}): Promise<{name?: string}> {
    const document = await this.open(file);
    await this.sync.whenSynced(document);
    const base = document.base;
    const result = await this.connection.call<{changes: (Change & {file?: number})[]; name?: string}>("splice", {file, version: document.version, edit});
    await this.applyListed(result.changes, file, new Map([[file, base]]));
    return result;
  }

  /** Selects a range and scrolls it into view; the focus does not move unless `focus`. */
  async reveal(file: number, from: number, to: number, focus = false): Promise<void> {
    const document = await this.activate(file), most = document.state.doc.length;
    const first = Math.min(from, most), last = Math.min(to, most);
    this.dispatch(document, {selection: {anchor: last, head: first}, effects: scrollTo(first, last), userEvent: "select.reveal"});
    if (focus) this.view?.focus();
  }

  /** Moves the cursor to a line and column, which count from 1. */
  async revealLine(file: number, line: number, column: number): Promise<void> {
    const {doc} = (await this.open(file)).state, {from, length} = doc.line(Math.min(Math.max(1, line), doc.lines)), at = from + Math.min(column - 1, length);
    await this.reveal(file, at, at, true);
  }

  /** Sets the faults of the drawing's graph, or none. */
  setFaults(file: number, faults: DiagramFault[]): void {
    this.emit("faults", {file, faults});
  }

  setMarks(file: number, marks: Mark[]): void {
    this.marks.set(file, marks);
    this.emit("marks", {file, marks});
  }

  marksOf(file: number): readonly Mark[] {
    return this.marks.get(file) ?? [];
  }

  private moveRanges(document: Document, transactions: readonly Transaction[]): void {
    const {file} = document, at = (position: number, side: number) => transactions.reduce((place, one) => one.changes.mapPos(Math.min(place, one.changes.length), side), position);
    this.marks.set(file, this.marksOf(file).map((mark) => ({...mark, from: at(mark.from, 1), to: at(mark.to, -1)})));
    this.emit("moved", {file, at});
  }
}
