import {ChangeSet, type EditorState, Text} from "@codemirror/state";
import {type Change, difference, setOf} from "./differences";

/** What `open` gives of a file. */
export interface Opened {
  name: string;
  text: string;
  hash: string;
  draft: string | null;
  version: number;
  writable?: boolean;
}

/** Lines end by "\n" only: then an offset here is the same one in the server. */
export const textOf = (content: string) => Text.of(content.split("\n"));

/** A file of the page: its editor's state with undo history, and what the server has of it. */
export class Document {
  state!: EditorState;
  /** The text that the file itself has. */
  saved: Text;
  hash: string;
  /** The server's text, and the version that it gave it. */
  base: Text;
  version: number;
  readonly isWritable: boolean;
  /** Changes of the server's text: those on their way to it, and those after them. */
  private sent: ChangeSet | undefined;
  private pending: ChangeSet;

  constructor(readonly file: number, readonly name: string, opened: Opened) {
    this.saved = textOf(opened.text);
    this.hash = opened.hash;
    this.base = textOf(opened.draft ?? opened.text);
    this.version = opened.version;
    this.isWritable = opened.writable ?? true;
    this.pending = ChangeSet.empty(this.base.length);
  }

  /** Does the text differ from the file? */
  get isChanged(): boolean {
    return !this.state.doc.eq(this.saved);
  }

  /** Has the server all changes? */
  get isSynced(): boolean {
    return this.pending.empty && !this.sent;
  }

  get isSending(): boolean {
    return this.sent !== undefined;
  }

  /** The text was changed here. */
  add(changes: ChangeSet): void {
    this.pending = this.pending.compose(changes);
  }

  /** What is to be sent next; nothing more is until `confirm` or `refuse`. */
  take(): ChangeSet {
    const sent = this.pending;
    this.sent = sent;
    this.pending = ChangeSet.empty(sent.newLength);
    return sent;
  }

  /** The server has what was sent. */
  confirm(version: number): void {
    if (this.sent) this.base = this.sent.apply(this.base);
    this.sent = undefined;
    this.version = version;
  }

  /** The server did not take what was sent: it is sent again later. */
  refuse(): void {
    if (this.sent) this.pending = this.sent.compose(this.pending);
    this.sent = undefined;
  }

  /** The server's text was changed elsewhere. Returns the change for the editor. */
  rebase(remote: ChangeSet, version: number): ChangeSet {
    const before = this.sent ?? ChangeSet.empty(this.base.length);
    const afterSent = remote.map(before, true), changes = afterSent.map(this.pending, true);
    this.pending = this.pending.map(afterSent);
    if (this.sent) this.sent = this.sent.map(remote);
    this.base = remote.apply(this.base);
    this.version = version;
    return changes;
  }

  /** The same for a list of changes; nothing where they do not fit to the server's text as it is known here. */
  rebaseListed(changes: Change[], version: number): ChangeSet | undefined {
    if (changes.some(({from, to}) => from > to || to > this.base.length)) return undefined;
    return this.rebase(setOf(changes, this.base.length), version);
  }

  /** The same for a whole text of the server. */
  rebaseText(text: string, version: number): ChangeSet {
    return this.rebase(difference(this.base, textOf(text)), version);
  }
}
