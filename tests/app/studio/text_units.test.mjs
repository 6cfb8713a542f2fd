// Texts of page and server converge for any order of edits; differing lines are found where a person would expect them.

import assert from "node:assert/strict";
import {readdirSync, readFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {test} from "node:test";
import {fileURLToPath} from "node:url";
import {bundled} from "./scopes/bundled.mjs";

const {Document, difference, differentLines, readFrame, textOf, ChangeSet} = await bundled(
  "text/document", "text/differences", "text/line_differences", "connection/frame",
  "../node_modules/@codemirror/state/dist/index.js");

/** Returns a generator of pseudo-random numbers below `limit`; the sequence is the same in every run. */
function numbers(seed) {
  let state = seed;
  return (limit) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * limit);
  };
}

/** Returns a random change of a text. */
function anyChange(text, next) {
  const from = next(text.length + 1), to = Math.min(text.length, from + next(4));
  return {from, to, text: ["", "a", "Ω\n", "xyz", "🙂"][next(5)]};
}
const put = (text, {from, to, text: insert}) => text.slice(0, from) + insert + text.slice(to);
const setOf = ({from, to, text}, length) => ChangeSet.of({from, to, insert: text}, length);

/** Server that accepts edits of its newest version only, as the studio does. */
class Server {
  constructor(text) {
    this.text = text;
    this.version = 1;
  }
  edit(changes) {
    for (const change of [...changes].reverse()) this.text = put(this.text, change);
    return ++this.version;
  }
}

test("a page and the server have the same text in the end, however their edits cross", () => {
  for (let seed = 1; seed <= 60; ++seed) {
    const next = numbers(seed), server = new Server("one\ntwo\nthree\n"), mail = [];
    const page = new Document(0, "a.yaml", {name: "a.yaml", text: server.text, hash: "", draft: null, version: 1});
    let own = server.text;
    const deliver = () => {
      const {news, answer} = mail.shift();
      if (news) {
        const changes = page.rebaseListed(news.changes, news.version);
        own = changes.apply(textOf(own)).toString();
      } else if (answer.version) page.confirm(answer.version);
      else {
        page.refuse();
        own = page.rebaseText(answer.current.text, answer.current.version).apply(textOf(own)).toString();
      }
    };
    const send = () => {
      if (page.isSending || page.isSynced) return;
      const {version} = page, changes = [];
      page.take().iterChanges((from, to, _a, _b, inserted) => changes.push({from, to, text: inserted.toString()}));
      mail.push({answer: version === server.version ? {version: server.edit(changes)} : {current: {text: server.text, version: server.version}}});
    };
    for (let i = 0; i < 40; ++i) {
      const what = next(4);
      if (what === 0) {
        const change = anyChange(own, next);
        page.add(setOf(change, own.length));
        own = put(own, change);
      } else if (what === 1) {
        const change = anyChange(server.text, next), changes = [change];
        mail.push({news: {changes, version: server.edit(changes)}});
      } else if (what === 2) send();
      else if (mail.length > 0) deliver();
    }
    while (mail.length > 0 || !page.isSynced) {
      send();
      while (mail.length > 0) deliver();
    }
    assert.equal(own, server.text, `seed ${seed}`);
  }
});

test("a difference is one change that makes the second text of the first", () => {
  const next = numbers(7);
  for (let i = 0; i < 200; ++i) {
    const before = "stepwire: 1\nblocks:\n  a: {block: Gain}\n".slice(next(10)), after = put(put(before, anyChange(before, next)), {from: 0, to: next(3), text: ""});
    assert.equal(difference(textOf(before), textOf(after)).apply(textOf(before)).toString(), after);
  }
});

test("lines that both texts have are not different, in whatever order others stand between them", () => {
  const {ours, theirs} = differentLines(["a", "b", "c", "d"], ["a", "x", "c", "y", "d"]);
  assert.deepEqual([...ours], [1]);
  assert.deepEqual([...theirs], [1, 3]);
  assert.deepEqual(differentLines(["a"], ["a"]), {ours: new Set(), theirs: new Set()});
});

test("a frame is read in place, and one that is cut or of another kind is refused", () => {
  const bytes = new ArrayBuffer(32 + 8 * 6), head = new DataView(bytes), values = new Float64Array(bytes, 32);
  [..."SWD1"].forEach((letter, i) => head.setUint8(i, letter.charCodeAt(0)));
  head.setUint8(4, 1);
  head.setUint16(6, 3, true);
  head.setUint32(8, 9, true);
  head.setUint32(12, 2, true);
  head.setUint16(16, 3, true);
  head.setUint32(20, 5, true);
  head.setFloat64(24, 1.5, true);
  values.set([0, 1, 10, 11, 20, 21]);
  const frame = readFrame(bytes);
  assert.deepEqual({...frame, time: [...frame.time], columns: frame.columns.map((column) => [...column])},
    {view: 3, sequence: 9, kind: "samples", run: 5, newest: 1.5, time: [0, 1], columns: [[10, 11], [20, 21]]});
  assert.equal(frame.columns[1].buffer, bytes);
  assert.throws(() => readFrame(bytes.slice(0, 70)), /cut/);
  head.setUint8(4, 2);
  assert.throws(() => readFrame(bytes), /version 1/);
});

test("no source of the page makes markup of a text", () => {
  const forbidden = /\b(innerHTML|outerHTML\s*=|insertAdjacentHTML|document\.write|eval\(|new Function|srcdoc|DOMParser\(\)\.parseFromString\((?!text, "image\/svg\+xml"|html, "text\/html"))/;
  const source = join(dirname(fileURLToPath(import.meta.url)), "../../../engine/app/studio/page/src");
  const files = readdirSync(source, {recursive: true}).filter((name) => /\.ts$/.test(name));
  assert.ok(files.length > 50);
  for (const name of files) assert.doesNotMatch(readFileSync(join(source, name), "utf8").replace(/^\s*(\/\/|\*|\/\*\*).*$/gm, ""), forbidden, name);
});
