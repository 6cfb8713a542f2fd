// An editor without a window: a client of the Language Server Protocol that drives `stepwire lsp` over its pipes.

import {spawn} from "node:child_process";
import {mkdtempSync, realpathSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {pathToFileURL} from "node:url";

const rpc = await import("vscode-jsonrpc/node.js").then((all) => all.default ?? all, () => undefined);
const protocol = await import("vscode-languageserver-protocol/node.js").then((all) => all.default ?? all, () => undefined);

/** Why there is no client here; false where there is one. */
export const missing = rpc && protocol ? false : "vscode-languageserver-protocol is not installed: ./stepwire setup tests";

/** Where a text begins to have a word, as editors count: units of UTF-16. */
export function place(text, word, behind = 0) {
  const at = text.indexOf(word) + behind;
  if (at < behind) throw new Error(`'${word}' is not there`);
  const lines = text.slice(0, at).split("\n");
  return {line: lines.length - 1, character: lines.at(-1).length};
}

/** What stands in a range. */
export function between(text, {start, end}) {
  const lines = text.split("\n");
  const offset = ({line, character}) => lines.slice(0, line).reduce((sum, one) => sum + one.length + 1, 0) + character;
  return text.slice(offset(start), offset(end));
}

/** A text with edits of the protocol. */
export function edited(text, edits) {
  const lines = text.split("\n");
  const offset = ({line, character}) => lines.slice(0, line).reduce((sum, one) => sum + one.length + 1, 0) + character;
  const pieces = edits.map(({range, newText}) => [offset(range.start), offset(range.end), newText]);
  return pieces.sort((a, b) => b[0] - a[0]).reduce((all, [from, to, put]) => all.slice(0, from) + put + all.slice(to), text);
}

export class Editor {
  static async started(program = process.env.STEPWIRE_PROGRAM) {
    const editor = new Editor();
    editor.folder = realpathSync(mkdtempSync(join(tmpdir(), "language-")));
    editor.process = spawn(program, ["lsp"], {stdio: ["pipe", "pipe", "inherit"]});
    editor.ended = new Promise((resolve) => editor.process.on("exit", resolve));
    editor.connection = rpc.createMessageConnection(
      new rpc.StreamMessageReader(editor.process.stdout), new rpc.StreamMessageWriter(editor.process.stdin));
    editor.texts = new Map();
    editor.versions = new Map();
    editor.published = new Map();
    editor.waiting = [];
    editor.connection.onNotification(protocol.PublishDiagnosticsNotification.type, (given) => editor.take(given));
    editor.connection.listen();
    editor.answer = await editor.connection.sendRequest(protocol.InitializeRequest.type, {
      processId: process.pid, rootUri: pathToFileURL(editor.folder).href, capabilities: {},
      workspaceFolders: [{uri: pathToFileURL(editor.folder).href, name: "test"}]});
    await editor.connection.sendNotification(protocol.InitializedNotification.type, {});
    return editor;
  }

  /** Ends the server as the protocol has it; its exit status. */
  async gone() {
    await this.connection.sendRequest(protocol.ShutdownRequest.type);
    await this.connection.sendNotification(protocol.ExitNotification.type);
    const status = await this.ended;
    this.connection.dispose();
    rmSync(this.folder, {recursive: true});
    return status;
  }

  uri(name) { return pathToFileURL(join(this.folder, name)).href; }
  path(name) { return join(this.folder, name); }

  /** Puts a file on the disk, which is not open. */
  file(name, text) {
    this.texts.set(name, text);
    writeFileSync(this.path(name), text);
  }

  open(name, text) {
    this.file(name, text);
    this.versions.set(name, 1);
    return this.connection.sendNotification(protocol.DidOpenTextDocumentNotification.type,
      {textDocument: {uri: this.uri(name), languageId: "yaml", version: 1, text}});
  }

  /** Changes the text that is open by pieces, or by the whole. */
  change(name, changes) {
    const version = this.versions.get(name) + 1;
    this.versions.set(name, version);
    for (const change of changes)
      this.texts.set(name, change.range ? edited(this.texts.get(name), [{range: change.range, newText: change.text}]) : change.text);
    return this.connection.sendNotification(protocol.DidChangeTextDocumentNotification.type,
      {textDocument: {uri: this.uri(name), version}, contentChanges: changes});
  }

  take(given) {
    this.published.set(given.uri, given);
    this.waiting = this.waiting.filter((one) => !one(given));
  }

  /** The diagnostics of a file for its newest version, once they come. */
  diagnostics(name, wanted = () => true) {
    const fits = (given) => given?.uri === this.uri(name) && wanted(given.diagnostics) &&
      (given.version === undefined || given.version === this.versions.get(name));
    const now = this.published.get(this.uri(name));
    if (fits(now)) return Promise.resolve(now.diagnostics);
    return new Promise((resolve) => this.waiting.push((given) => fits(given) && (resolve(given.diagnostics), true)));
  }

  at(name, position) { return {textDocument: {uri: this.uri(name)}, position}; }
  ask(method, params) { return this.connection.sendRequest(method, params); }
}

export {protocol};
