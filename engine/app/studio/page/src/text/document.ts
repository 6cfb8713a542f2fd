import {ChangeSet, type EditorState, Text} from "@codemirror/state";
import {type Change, difference, setOf} from "./differences";

/** Result of the call `open`. */
export interface Opened {
  name: string;
  text: string;
  hash: string;
  draft: string | null;
  version: number;
  writable?: boolean;
}

/** Splits at "\n" only, so that offsets agree with those of the server. */
export const textOf = (content: string) => Text.of(content.split("\n"));

/** File of the page: the state of its editor with undo history, and the state of the server. */
export class Document {
  state!: EditorState;
  /** Text of the file on the disk. */
  saved: Text;
  hash: string;
  /** Text of the server, with its version. */
  base: Text;
  version: number;
  readonly isWritable: boolean;
  /** Changes relative to the server's text: those being sent, and those after them. */
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

  /** True if the text differs from the file. */
  get isChanged(): boolean {
    return !this.state.doc.eq(this.saved);
  }

  /** True if the server has all changes. */
  get isSynced(): boolean {
    return this.pending.empty && !this.sent;
  }

  get isSending(): boolean {
    return this.sent !== undefined;
  }

  /** Records a change of the text by this page. */
  add(changes: ChangeSet): void {
    this.pending = this.pending.compose(changes);
  }

  /** Returns the changes to send. It must not be called again before `confirm` or `refuse`. */
  take(): ChangeSet {
    const sent = this.pending;
    this.sent = sent;
    this.pending = ChangeSet.empty(sent.newLength);
    return sent;
  }

  /** Records that the server has applied the sent changes. */
  confirm(version: number): void {
    if (this.sent) this.base = this.sent.apply(this.base);
    this.sent = undefined;
    this.version = version;
  }

  /** Records that the server has refused the sent changes; they are sent again later. */
  refuse(): void {
    if (this.sent) this.pending = this.sent.compose(this.pending);
    this.sent = undefined;
  }

  /** Applies a remote change of the server's text. Returns the change for the editor. */
  rebase(remote: ChangeSet, version: number): ChangeSet {
    const before = this.sent ?? ChangeSet.empty(this.base.length);
    const afterSent = remote.map(before, true), changes = afterSent.map(this.pending, true);
    this.pending = this.pending.map(afterSent);
    if (this.sent) this.sent = this.sent.map(remote);
    this.base = remote.apply(this.base);
    this.version = version;
    return changes;
  }

  /** Applies a list of remote changes like `rebase`; returns undefined if they do not fit the known text of the server. */
  rebaseListed(changes: Change[], version: number): ChangeSet | undefined {
    if (changes.some(({from, to}) => from > to || to > this.base.length)) return undefined;
    return this.rebase(setOf(changes, this.base.length), version);
  }

  /** Applies a whole new text of the server like `rebase`. */
  rebaseText(text: string, version: number): ChangeSet {
    return this.rebase(difference(this.base, textOf(text)), version);
  }
}
