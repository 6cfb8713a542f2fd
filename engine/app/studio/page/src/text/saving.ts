// Saving of texts to their files, and changes of the files by other programs.

import {isolateHistory} from "@codemirror/commands";
import type {TransactionSpec} from "@codemirror/state";
import type {Connection} from "../connection/connection";
import {difference} from "./differences";
import {type Document, textOf} from "./document";
import type {TextSync} from "./text_sync";

/** Change of a file by another program that conflicts with the edited text. */
export interface Conflict {
  document: Document;
  text: string;
  hash: string;
  /** Merged text with all lines of both; differing lines of the file are comments. */
  both: string;
}

interface Owner {
  document(file: number): Document | undefined;
  /** Returns the documents that differ from their files. */
  changed(): Document[];
  dispatch(document: Document, spec: TransactionSpec): void;
  synced(document: Document): void;
  /** The saved text of a document has changed. */
  kept(): void;
  conflict(conflict: Conflict): void;
}

export class Saving {
  constructor(private readonly connection: Connection, private readonly sync: TextSync, private readonly notify: (text: string) => void, private readonly owner: Owner) {
    connection.on("changed", (news) => this.takeChanged(news));
    connection.on("saved", (news) => this.takeSaved(news));
  }

  /** Writes all changed texts to their files; shows both texts of a conflict. */
  async save(): Promise<void> {
    const names: string[] = [];
    for (const document of this.owner.changed()) {
      await this.sync.whenSynced(document);
      if (await this.write(document, document.hash)) names.push(document.name);
    }
    if (names.length > 0) this.notify(`${names.join(", ")} ${names.length === 1 ? "is" : "are"} saved`);
  }

  /** Writes a text if its file still has this hash. Returns true if it was written. */
  async write(document: Document, hash: string): Promise<boolean> {
    const text = document.base;
    const result = await this.connection.call<{hash?: string; merged?: boolean; conflict?: Omit<Conflict, "document">}>("save", {file: document.file, hash});
    if (result.merged) return false;  // the merged lines arrive as news
    if (result.conflict) this.owner.conflict({document, ...result.conflict});
    else this.keep(document, text, result.hash ?? hash);
    return !result.conflict;
  }

  /** Drops the draft of a file. */
  async discard(document: Document): Promise<void> {
    const {text, hash, version} = await this.connection.call<{text: string; hash: string; version: number}>("discard", {file: document.file});
    this.sync.applyRemote(document, document.rebaseText(text, version));
    this.keep(document, textOf(text), hash);
    this.owner.synced(document);
  }

  /** Replaces the own text by that of the file; undo restores it. */
  takeText(document: Document, text: string, hash: string): void {
    const changes = {from: 0, to: document.state.doc.length, insert: textOf(text)};
    this.owner.dispatch(document, {changes, annotations: isolateHistory.of("full")});
    this.keep(document, textOf(text), hash);
  }

  /** Replaces the own text by the merged one; undo restores it. The file is not written. */
  takeBoth(document: Document, {both, text, hash}: Conflict): void {
    const spec = {changes: difference(document.state.doc, textOf(both)), annotations: isolateHistory.of("full")};
    this.owner.dispatch(document, spec);
    this.keep(document, textOf(text), hash);
  }

  /** Writes the own text over the file; undo restores the text of the file. */
  async overwrite(document: Document, text: string, hash: string): Promise<boolean> {
    const own = document.state.doc;
    this.takeText(document, text, hash);
    this.owner.dispatch(document, {changes: {from: 0, to: document.state.doc.length, insert: own}, annotations: isolateHistory.of("full")});
    await this.sync.whenSynced(document);
    return this.write(document, hash);
  }

  private keep(document: Document, saved: Document["saved"], hash: string): void {
    document.saved = saved;
    document.hash = hash;
    this.owner.kept();
  }

  /** Records that another page has saved the file. */
  private takeSaved({file, hash}: {file: number; hash: string}): void {
    const document = this.owner.document(file);
    if (document) this.keep(document, document.base, hash);
  }

  /**
   * Handles a change of a file by another program. Without a draft the text is replaced at once, a mergeable draft is merged; otherwise
   * both texts are shown.
   */
  private takeChanged({file, text, hash, version, merged, both = ""}: {file: number; text: string; hash: string; version: number; merged: boolean; both?: string}): void {
    const document = this.owner.document(file), isSame = document?.state.doc.eq(textOf(text));
    if (!document || document.hash === hash) return;
    if (!merged && document.isChanged && !isSame) return this.owner.conflict({document, text, hash, both});
    if (!merged && version > document.version) this.sync.applyRemote(document, document.rebaseText(text, version));
    this.keep(document, textOf(text), hash);
    this.owner.synced(document);
    if (merged) this.notify(`${document.name} was changed by another program; its lines are merged with yours, and nothing is saved yet`);
    else if (!isSame) this.notify(`${document.name} was changed by another program; the new text is shown`);
  }
}
