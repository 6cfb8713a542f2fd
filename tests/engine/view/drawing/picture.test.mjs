// How graphs that a test makes up are drawn.

import assert from "node:assert/strict";
import {join} from "node:path";
import {test} from "node:test";

import {box, checkApart, checkBlocks, checkEnds, checkWhole, checkWires, drawing, elk, overlap, segments, shrunk, touches} from "./picture_checks.mjs";
const {arrange, svgOf} = await import(join(drawing, "draw.mjs"));
const {alignPorts} = await import(join(drawing, "align_ports.mjs"));
const {removeJogs} = await import(join(drawing, "remove_jogs.mjs"));

const block = (id, inputs = ["u"], outputs = ["y"]) => ({
  id, name: id, outline: "box", lines: [id], inputs: inputs.map((port) => ({port})), outputs: outputs.map((port) => ({port})),
});
const wire = (from, to) => ({from: {node: from, port: "y"}, to: {node: to, port: "u"}});
/** Blocks one behind the other, the last one feeding the first where `loop`. */
function chain(count, loop) {
  const ids = Array.from({length: count}, (_, i) => `block ${i}`);
  const wires = ids.slice(1).map((id, i) => wire(ids[i], id));
  return {inputs: [], outputs: [], nodes: ids.map((id) => block(id)), wires: loop ? [...wires, wire(ids.at(-1), ids[0])] : wires};
}
const check = (picture) => [checkBlocks, checkWires, checkEnds, checkWhole, checkApart].forEach((one) => one(picture));

for (const loop of [true, false])
  test(`a ${loop ? "loop" : "chain"} that is too long for one row is drawn in two, the second from right to left`, async () => {
    const graph = chain(16, loop), picture = await arrange(graph, elk);
    check(picture);
    assert.equal(picture.wires.filter((one) => one.to).length, graph.wires.length);
    assert.ok((1400 / picture.width) * 10.5 >= 9, "its smallest text is not 9 px high at 1400 px");
    assert.ok(picture.width < 3.5 * picture.height || picture.width < 1000);
    const at = (i) => picture.blocks.find(({id}) => id === `block ${i}`);
    assert.ok(at(1).x > at(0).x && at(15).x < at(14).x && at(15).y > at(0).y + 40);
  });

test("a chain of 60 blocks is drawn in rows that go to and fro, and is readable on a page", async () => {
  const graph = chain(60, false), picture = await arrange(graph, elk);
  check(picture);
  assert.equal(picture.wires.filter((one) => one.to).length, graph.wires.length);
  assert.ok((1400 / picture.width) * 10.5 >= 9, "its smallest text is not 9 px high at 1400 px");
  const rows = new Map();
  for (const {x, y} of picture.blocks) rows.set(y, [...(rows.get(y) ?? []), x]);
  assert.ok(rows.size > 3, "it has few rows");
  [...rows.values()].forEach((xs, row) => xs.slice(1).forEach((x, i) => assert.equal(x > xs[i], row % 2 === 0)));
});

test("a short chain stays in one row", async () => {
  const {blocks} = await arrange(chain(4, false), elk);
  assert.ok(blocks.every(({x}, i) => i === 0 || x > blocks[i - 1].x));
});

test("a group is a frame around its blocks that wires pass through", async () => {
  const graph = {...chain(5, true), groups: [{name: "both", members: ["block 1", "block 2"]}]};
  graph.nodes[2].outputs.push({port: "z", recorded: true});
  const picture = await arrange(graph, elk), frame = picture.blocks.find(({name}) => name === "both");
  check(picture);
  for (const {id, x, y, width, height} of picture.blocks.filter((one) => one.id.startsWith("block")))
    assert.equal(x > frame.x && y > frame.y && x + width < frame.x + frame.width && y + height < frame.y + frame.height,
      ["block 1", "block 2"].includes(id), id);
  const heads = [...svgOf(picture).matchAll(/fill="#1a1a1a" stroke="none"/g)].length;
  assert.equal(heads, graph.wires.length + 1, "one arrow for each wire of the file and for what is recorded, none at the frame");
});

test("wires lead from a group in one row to a group in the other", async () => {
  const ids = (from, to) => Array.from({length: to - from}, (_, i) => `block ${from + i}`);
  const graph = {...chain(16, true), groups: [{name: "first", members: ids(2, 6)}, {name: "second", members: ids(10, 14)}]};
  const picture = await arrange(graph, elk), at = (name) => picture.blocks.find((one) => one.name === name);
  check(picture);
  assert.equal(picture.wires.filter((one) => one.to).length, graph.wires.length);
  assert.ok(at("second").y > at("first").y + at("first").height);
});

test("texts on wires stand at their beginning, with what follows _ lower, on nothing else", async () => {
  const graph = chain(6, true);
  graph.nodes[2].outputs[0].mark = "F_d";
  graph.nodes[5].outputs[0].mark = "x_{max}";
  const picture = await arrange(graph, elk), svg = svgOf(picture);
  assert.match(svg, /font-style="italic"[^>]*>F<tspan font-size="[\d.]+" dy="[\d.]+">d<\/tspan><\/text>/);
  assert.match(svg, />x<tspan[^>]*>max<\/tspan>/);
  for (const {id, x, y, outputs: [port]} of picture.blocks.filter(({outputs}) => outputs[0]?.mark)) {
    const [dx, dy, width] = port.noteAt, area = {left: x + port.x + dx, top: y + port.y + dy, right: x + port.x + dx + width, bottom: y + port.y + dy + 14};
    for (const other of picture.blocks) assert.ok(!overlap(shrunk(area, 1), box(other)), `the text of ${id} covers ${other.id}`);
    for (const segment of picture.wires.flatMap(({points}) => segments(points)))
      assert.ok(!touches(segment, shrunk(area, 1)), `a wire runs through the text of ${id}`);
  }
});

test("a frame that is drawn from right to left keeps its ports and what is in it", async () => {
  const inner = {inputs: [{port: "u", label: "u"}], outputs: [{port: "y", label: "y"}],
    nodes: [block("part.a"), block("part.b")],
    wires: [{from: {node: "", port: "u"}, to: {node: "part.a", port: "u"}}, wire("part.a", "part.b"),
      {from: {node: "part.b", port: "y"}, to: {node: "", port: "y"}}]};
  const sum = {...block("sum", ["u.1", "u.2"]), outline: "circle", inputs: [{port: "u.1", sign: "+"}, {port: "u.2", sign: "-"}]};
  const graph = {inputs: [], outputs: [], nodes: [block("step", []), sum, {...block("plant"), state: true, outputs: [{port: "y", recorded: true}]},
    {...block("part"), part: true, graph: inner}],
    wires: [{from: {node: "step", port: "y"}, to: {node: "sum", port: "u.1"}}, wire("sum", "plant"), wire("plant", "part"),
      {from: {node: "part", port: "y"}, to: {node: "sum", port: "u.2"}}]};
  const picture = await arrange(graph, elk), at = (id) => picture.blocks.find((one) => one.id === id);
  check(picture);
  assert.ok(at("part").flipped, "it stands in the way back");
  assert.ok(at("part.a").x > at("part.b").x, "the signal goes to the left in it");
});

test("names are escaped", async () => {
  const port = {port: "y", label: "<y> & \"z\""};
  const node = {id: "a", name: "<&>\u0001", outline: "box", lines: ["a<b"], inputs: [], outputs: [port, {port: "z"}]};
  const svg = svgOf(await arrange({inputs: [], outputs: [], nodes: [node], wires: []}, elk), "\"<title>\"");
  assert.match(svg, /<title>&quot;&lt;title&gt;&quot;<\/title>/);
  assert.match(svg, />&lt;&amp;&gt; </);
  assert.match(svg, />a&lt;b</);
  assert.match(svg, />&lt;y&gt; &amp; &quot;z&quot;</);
});

const aWire = {from: {node: "a", port: "y"}, to: {node: ":output:y", port: "y"}};
const other = {from: {node: "b", port: "y"}, to: {node: "c", port: "u"}};
const oval = {id: ":output:y", name: "", outline: "oval", own: "output", width: 40, height: 20, inputs: [{port: "y"}], outputs: []};
const linesOf = (points, more = []) => new Map([[aWire, points], ...(more.length > 0 ? [[other, more]] : [])]);

test("a port of the file moves to where its wire goes on, unless something is in the way", () => {
  const slid = (more) => {
    const lines = linesOf([[0, 0], [20, 0], [20, 30], [50, 30]], more), places = new Map([[oval.id, {x: 50, y: 20}]]);
    alignPorts([oval], [aWire], places, lines);
    return [places.get(oval.id), lines.get(aWire)];
  };
  assert.deepEqual(slid([]), [{x: 50, y: -10}, [[0, 0], [50, 0]]]);
  assert.deepEqual(slid([[30, 4], [45, 4]])[0], {x: 50, y: 20}, "beside another wire");
  assert.deepEqual(slid([[60, -40], [60, 5]])[0], {x: 50, y: 20}, "on another wire");
});

test("a small step is taken out of a wire, unless it then lay on another", () => {
  const smoothed = (more) => {
    const lines = linesOf([[0, 0], [20, 0], [20, 5], [60, 5], [60, 40]], more);
    removeJogs([], [aWire], new Map(), lines);
    return lines.get(aWire);
  };
  assert.deepEqual(smoothed([]), [[0, 0], [60, 0], [60, 40]]);
  assert.equal(smoothed([[30, -2], [50, -2]]).length, 5);
});
