// Diagram of two blocks, served by functions to the built page in Chromium.

import assert from "node:assert/strict";
import {existsSync} from "node:fs";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";
import * as browser from "./browser.mjs";
import {openPage} from "./scene_page.mjs";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../..");
export const built = [process.env.STUDIO_PAGE, join(root, "build/studio"), join(root, "engine/app/studio/page/dist")].find((one) => one && existsSync(join(one, "index.html")));
export const missing = built ? false : "the page is not built: npx vite build in engine/app/studio/page";
export const skip = browser.missing || missing;

export const text = "stepwire: 1\nblocks:\n  source: {block: Constant, value: 2}\n  lag: {block: Lag, u: source, tau: 0.4 s}\nrecord: [lag]\n";
export const box = (id, type, lines, inputs = []) => ({id, name: id, type, outline: "box", lines, inputs: inputs.map((port) => ({port})), outputs: [{port: "y"}]});
const rangeOf = (whole, id) => {
  const from = whole.indexOf(`  ${id}:`) + 2;
  return {file: 0, from, to: whole.indexOf("\n", from)};
};

/** Server with one file, whose drawing follows the block names in its text. */
export class Diagram {
  text = text;
  version = 1;
  saved = text;
  edits = [];
  splices = [];

  answers() {
    return {
      files: () => ({files: [{file: 0, name: "test.yaml", writable: true, part: false}]}),
      open: () => ({name: "test.yaml", text: this.saved, hash: this.saved, draft: this.text === this.saved ? null : this.text, version: this.version}),
      edit: ({version, changes}) => {
        if (version === this.version) return this.edit(changes);
        throw Object.assign(new Error("the text was changed meanwhile"), {current: {text: this.text, version: this.version}});
      },
      graph: () => this.graph(),
      save: ({hash}) => (hash === this.saved ? {hash: (this.saved = this.text)} : {conflict: {text: this.saved, hash: this.saved}}),
      splice: ({edit}) => this.splice(edit),
      fits: () => ({inputs: [{node: "lag", input: "u"}]}),
      language: () => { throw new Error("there is no language server"); },
    };
  }
  edit(changes) {
    for (const {from, to, text: insert} of [...changes].reverse()) this.text = this.text.slice(0, from) + insert + this.text.slice(to);
    this.edits.push(changes);
    return {version: ++this.version};
  }
  graph() {
    const name = /^ {2}(\S+): \{block: Lag/m.exec(this.text)[1], value = /value: ([^}]+)\}/.exec(this.text)[1];
    const graph = {title: "", inputs: [], outputs: [], nodes: [box("source", "Constant", [value]), box(name, "Lag", ["lag"], ["u"])], wires: [{from: {node: "source", port: "y"}, to: {node: name, port: "u"}}]};
    return {graph, ranges: {source: rangeOf(this.text, "source"), [name]: rangeOf(this.text, name)}};
  }
  splice(edit) {
    this.splices.push(edit);
    const at = this.text.indexOf("0.4 s");
    return {changes: edit.kind === "number" ? [{file: 0, from: at, to: at + 5, text: edit.text}] : []};
  }
}

/** Opens the page on such a diagram, runs an action, and checks that the page had no error. */
export async function withPage(action, options) {
  const diagram = new Diagram(), opened = await openPage(built, diagram.answers(), options);
  try {
    await opened.page.waitForSelector("[data-shape='lag']");
    await action({...opened, diagram});
    assert.deepEqual(opened.errors, []);
  } finally {
    await opened.close();
  }
}
