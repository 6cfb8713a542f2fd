// Synchronisation of texts between server and page: one edit is sent at a time, with edits of other pages in between.

import {type ChangeSet, Transaction, type TransactionSpec} from "@codemirror/state";
import {type Connection, Fault} from "../connection/connection";
import {type Change, listed} from "./differences";
import {type Document, type Opened, textOf} from "./document";

interface Owner {
  documents(): Map<number, Document>;
  dispatch(document: Document, spec: TransactionSpec): void;
  /** The server has all changes of a document. */
  synced(document: Document): void;
}

export class TextSync {
  private readonly waiting = new Map<Document, Set<() => void>>();

  constructor(private readonly connection: Connection, private readonly notify: (text: string, kind: "fault") => void, private readonly owner: Owner) {
    connection.on("edited", (news) => this.takeEdit(news));
    connection.on("connection", ({state}) => { if (state === "open") void this.reopen(); });
  }

  /** Sends the pending changes; further ones are sent afterwards. */
  async send(document: Document): Promise<void> {
    if (document.isSending || document.isSynced || this.connection.state !== "open") return;
    const changes = document.take();
    try {
      const {version} = await this.connection.call<{version: number}>("edit", {file: document.file, version: document.version, changes: listed(changes)});
      document.confirm(version);
    } catch (thrown) {
      document.refuse();
      if (!this.recover(document, Fault.from(thrown))) return;
    }
    this.goOn(document);
  }

  /** Resolves when the server has the present text; rejects if the connection is lost. */
  whenSynced(document: Document): Promise<void> {
    if (document.isSynced) return Promise.resolve();
    return new Promise((resolve, reject) => {
      const own = this.waiting.get(document) ?? new Set(), end = this.connection.on("connection", () => reject(new Fault("no connection to the studio")));
      this.waiting.set(document, own.add(() => { end(); resolve(); }));
      void this.send(document);
    });
  }

  /** Applies a remote change, which undo does not affect. */
  applyRemote(document: Document, changes: ChangeSet): void {
    if (!changes.empty) this.owner.dispatch(document, {changes, annotations: [Transaction.remote.of(true), Transaction.addToHistory.of(false)]});
  }

  private goOn(document: Document): void {
    if (!document.isSynced) return void this.send(document);
    const all = [...(this.waiting.get(document) ?? [])];
    this.waiting.delete(document);
    all.forEach((resolve) => resolve());
    this.owner.synced(document);
  }

  /** Adopts the server's text after a version conflict. Returns true if sending again may succeed. */
  private recover(document: Document, {text, detail}: Fault): boolean {
    if (this.connection.state !== "open") return false;
    const current = detail.current as {text: string; version: number} | undefined;
    if (!current) this.notify(`${document.name}: the change could not be stored: ${text}`, "fault");
    else this.applyRemote(document, document.rebaseText(current.text, current.version));
    return current !== undefined;
  }

  private takeEdit({file, version, changes}: {file: number; version: number; changes: Change[]}): void {
    const document = this.owner.documents().get(file);
    if (!document || version <= document.version) return;
    const remote = document.rebaseListed(changes, version);
    if (remote) this.applyRemote(document, remote);
    if (document.isSynced) this.owner.synced(document);
  }

  /** Adopts the server's texts after a lost connection, and sends the own changes again. */
  private async reopen(): Promise<void> {
    for (const document of this.owner.documents().values()) {
      const {text, hash, draft, version} = await this.connection.call<Opened>("open", {file: document.file});
      document.refuse();
      this.applyRemote(document, document.rebaseText(draft ?? text, version));
      document.hash = hash;
      document.saved = textOf(text);
      this.goOn(document);
    }
  }
}
