// How two versions of a graph are drawn as one.

import assert from "node:assert/strict";
import {join} from "node:path";
import {test} from "node:test";

import {drawing, elk} from "./picture_checks.mjs";
const {drawCompared} = await import(join(drawing, "draw.mjs"));
const {looks, united} = await import(join(drawing, "compared.mjs"));

const block = (id, inputs = ["u"]) => ({
  id, name: id, type: "Gain", outline: "box", lines: [id], inputs: inputs.map((port) => ({port})), outputs: [{port: "y"}],
});
const wire = (from, to) => ({from: {node: from, port: "y"}, to: {node: to, port: "u"}});
const graph = (ids, wires) => ({inputs: [], outputs: [], title: "t", nodes: ids.map((id) => block(id)), wires: wires.map(([from, to]) => wire(from, to))});
const changes = (list) => list.filter(({change}) => change).map(({id, from, to, change}) => [id ?? `${from.node} ${to.node}`, change]);

const chain = graph(["a", "b", "c"], [["a", "b"], ["b", "c"]]);

test("two equal graphs have no change", () => {
  const {nodes, wires} = united({before: chain, after: chain});
  assert.deepEqual([...changes(nodes), ...changes(wires)], []);
});

test("a gone block is behind its old neighbour, with its old wires", () => {
  const after = graph(["a", "c"], [["a", "c"]]), {nodes, wires} = united({before: chain, after});
  assert.deepEqual(nodes.map(({id}) => id), ["a", "b", "c"]);
  assert.deepEqual(changes(nodes), [["b", "removed"]]);
  assert.deepEqual(changes(wires).sort(), [["a b", "removed"], ["a c", "added"], ["b c", "removed"]].sort());
});

test("a renamed block has both names, and its wires stay", () => {
  const after = graph(["a", "x", "c"], [["a", "x"], ["x", "c"]]), {nodes, wires} = united({before: chain, after, names: {b: "x"}});
  assert.deepEqual(changes(nodes), [["x", "changed"]]);
  assert.equal(nodes[1].name, "x (was b)");
  assert.deepEqual(changes(wires), []);
});

test("a wire that an input had before ends beside the one that it has now", () => {
  const before = graph(["a", "b", "c"], [["a", "c"]]), after = graph(["a", "b", "c"], [["b", "c"]]);
  const {nodes, wires} = united({before, after});
  assert.deepEqual(nodes[2].inputs.map(({port}) => port), ["u", "u before"]);
  assert.equal(wires.find(({change}) => change === "removed").to.port, "u before");
});

test("the picture has each change in its colour and with its sign, a legend, and the lines", async () => {
  const after = graph(["a", "n", "c"], [["a", "n"], ["n", "c"]]), lines = ["+ n: a gain", "- b: <a gain>"];
  const svg = await drawCompared({before: chain, after, changed: ["c.gain"], lines}, elk);
  for (const {color, sign, word} of Object.values(looks)) {
    assert.ok(svg.includes(color));
    assert.ok(svg.split(`>${sign}</text>`).length > 2, `${sign} is in the legend and in the drawing`);
    assert.ok(svg.includes(`>${word}</text>`));
  }
  assert.ok(svg.includes("- b: &lt;a gain&gt;"));
  assert.ok(svg.includes("stroke-dasharray"));
});

test("a new wire is drawn above the gone one in its place", async () => {
  const sum = {...block("c"), outline: "circle"};
  const version = (wires) => ({...graph(["a", "b"], []), nodes: [block("a"), block("b"), sum], wires: wires.map(([from, to]) => wire(from, to))});
  const svg = await drawCompared({before: version([["a", "c"]]), after: version([["b", "c"]])}, elk);
  const strokes = [looks.removed, looks.added].map(({color}) => svg.lastIndexOf(`stroke="${color}"`, svg.indexOf("<circle")));
  assert.ok(strokes[0] >= 0 && strokes[0] < strokes[1]);
});

test("a trunk has the look of a branch that stays or comes, and a gone branch begins at the fork", async () => {
  const ids = ["a", "b", "c", "d"], before = graph(ids, [["a", "b"], ["a", "c"]]);
  const begins = (svg, look) => [...svg.matchAll(new RegExp(`<g fill="none" stroke="${look}"[^>]*>\\s*<path d="M([\\d.]+)`, "g"))].map(([, x]) => Number(x));
  for (const [sink, look] of [["b", "#1a1a1a"], ["d", looks.added.color]]) {
    const svg = await drawCompared({before, after: graph(ids, [["a", sink]])}, elk);
    const gone = begins(svg, looks.removed.color), trunk = Math.min(...begins(svg, look));
    assert.ok(gone.length > 0);
    assert.ok(gone.every((x) => x > trunk), `${gone} is right of ${trunk}`);
  }
});

test("the sign of a changed triangle is at a corner of its base", async () => {
  const gain = {...block("b"), outline: "triangle"}, version = {...chain, nodes: [chain.nodes[0], gain, chain.nodes[2]]};
  const svg = await drawCompared({before: version, after: version, changed: ["b.gain"]}, elk);
  const [, x, y] = svg.match(/<path d="M([\d.]+) ([\d.]+)V[\d.]+L[\d. ]+Z"/);
  assert.ok(svg.includes(`<circle cx="${x}" cy="${y}" r="7.5"`));
});

test("a diagram that is new as a whole is drawn", async () => {
  const svg = await drawCompared({before: graph([], []), after: chain}, elk);
  assert.ok(!svg.includes(`stroke="${looks.removed.color}" stroke-width="1.6"`));
});

test("a number with another value at an input is changed, a number in the place of a wire is new", () => {
  const number = (value) => ({from: {constant: value}, to: {node: "b", port: "u"}});
  const fed = (wireOfB) => ({...graph(["a", "b"], []), wires: [wireOfB]});
  const changesOf = (before, after) => united({before: fed(before), after: fed(after)}).wires.filter(({change}) => change).map(({change}) => change);
  assert.deepEqual(changesOf(number("1 N"), number("2 N")), ["changed"]);
  assert.deepEqual(changesOf(number("1 N"), number("1 N")), []);
  assert.deepEqual(changesOf(wire("a", "b"), number("2 N")).sort(), ["added", "removed"]);
});

test("a long line is drawn in pieces with all its words, and a part has a bold heading", async () => {
  const words = Array.from({length: 60}, (_, i) => `word${i}`), line = `~ claim.that: ${words.join(" ")}`;
  const svg = await drawCompared({before: chain, after: chain, lines: [{heading: "in the part a.yaml"}, line]}, elk);
  const texts = [...svg.matchAll(/<text[^>]*>([^<]*)<\/text>/g)].map(([, text]) => text);
  const pieces = texts.filter((text) => text.includes("word"));
  assert.ok(pieces.length > 3 && pieces.every((text) => text.length <= 105));
  assert.equal(pieces.map((text) => text.trim()).join(" "), line);
  assert.match(svg, /font-weight="bold"[^>]*>in the part a\.yaml</);
});
