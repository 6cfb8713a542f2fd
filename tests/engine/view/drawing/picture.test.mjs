// What holds for the picture of every diagram file, closed and opened.

import assert from "node:assert/strict";
import {spawnSync} from "node:child_process";
import {readdirSync} from "node:fs";
import {dirname, join} from "node:path";
import {test} from "node:test";
import {fileURLToPath} from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../../..");
const {arrange, svgOf} = await import(join(root, "engine/view/drawing/draw.mjs"));
const {alignPorts} = await import(join(root, "engine/view/drawing/align_ports.mjs"));
const {removeJogs} = await import(join(root, "engine/view/drawing/remove_jogs.mjs"));
const {widthOf} = await import(join(root, "engine/view/drawing/text.mjs"));
const {default: ELK} = await import(join(root, "engine/view/drawing/node_modules/elkjs/lib/elk.bundled.js"));
const elk = new ELK();

const folders = ["examples", "parts", "thesis"].map((name) => join(root, "diagrams", name));
const files = folders.flatMap((folder) => readdirSync(folder).filter((name) => name.endsWith(".yaml")).map((name) => join(folder, name)));

/** The graph of a file; nothing where its data are not on this machine. */
function graphOf(file, depth) {
  const {status, stdout, stderr} = spawnSync(process.env.STEPWIRE_PROGRAM, ["draw", file, "--json", "--depth", depth]);
  if (status === 3) return undefined;
  assert.equal(status, 0, String(stderr));
  return JSON.parse(stdout);
}

const box = ({x, y, width, height}) => ({left: x, right: x + width, top: y, bottom: y + height});
const overlap = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
const shrunk = ({left, right, top, bottom}, by) => ({left: left + by, right: right - by, top: top + by, bottom: bottom - by});
const segments = (points) => points.slice(1).map(([bx, by], i) => {
  const [ax, ay] = points[i];
  return {left: Math.min(ax, bx), right: Math.max(ax, bx), top: Math.min(ay, by), bottom: Math.max(ay, by)};
});
const touches = (segment, area) =>
  segment.left < area.right && segment.right > area.left && segment.top < area.bottom && segment.bottom > area.top;

function nameBox(block) {
  const width = widthOf(block.name, 12), x = block.x + (block.width - width) / 2;
  return box({x, y: block.nameSide === "TOP" ? block.y - 15 : block.y + block.height + 5, width, height: 10});
}

const near = (a, b) => Math.abs(a - b) < 1e-6;
const isAt = ([x, y], [px, py]) => near(x, px) && near(y, py);
const place = (block, port) => [block.x + port.x, block.y + port.y];

function checkBlocks({blocks, width, height}) {
  const solid = blocks.filter((block) => !block.inner);
  for (const block of solid) {
    const area = box(block);
    assert.ok(area.left >= 0 && area.top >= 0 && area.right <= width && area.bottom <= height, `${block.id} lies outside`);
    for (const other of solid)
      assert.ok(block === other || !overlap(area, box(other)), `${block.id} overlaps ${other.id}`);
    for (const other of solid.filter((one) => one.nameSide && one !== block))
      assert.ok(!overlap(shrunk(area, 0.5), nameBox(other)), `${block.id} covers the name of ${other.id}`);
  }
}

function checkWires({blocks, wires, width, height}) {
  for (const wire of wires) {
    const solid = blocks.filter((block) => !wire.within?.includes(block.id));
    const what = JSON.stringify([wire.from, wire.to]);
    for (const segment of segments(wire.points)) {
      assert.ok(near(segment.left, segment.right) || near(segment.top, segment.bottom), `${what} runs aslant`);
      assert.ok(segment.left >= 0 && segment.right <= width && segment.top >= 0 && segment.bottom <= height, `${what} leaves`);
      for (const block of solid) {
        assert.ok(!touches(segment, shrunk(box(block), 0.5)), `${what} crosses ${block.id}`);
        assert.ok(!block.nameSide || !touches(segment, nameBox(block)), `${what} crosses the name of ${block.id}`);
      }
    }
  }
}

/** Wires begin and end at the places of their ports, which may lie in any of the frames of one name. */
function checkEnds({blocks, wires}) {
  const ends = (end, ports) => blocks.filter((block) => block.id === end.node)
    .flatMap((block) => block[ports].filter((port) => port.port === end.port).map((port) => place(block, port)));
  for (const {from, to, points} of wires) {
    assert.ok(ends(from, "outputs").some((port) => isAt(points[0], port)), `nothing begins at ${JSON.stringify(from)}`);
    if (to) assert.ok(ends(to, "inputs").some((port) => isAt(points.at(-1), port)), `nothing ends at ${JSON.stringify(to)}`);
  }
}

/** Blocks and wires lie at whole pixels: rounded one by one, a wire would miss its port. */
function checkWhole({blocks, wires}) {
  for (const {id, x, y} of blocks) assert.ok(Number.isInteger(x) && Number.isInteger(y), `${id} lies between pixels`);
  for (const {from, points} of wires) assert.ok(points.flat().every(Number.isInteger), `${JSON.stringify(from)} between pixels`);
}

/** What is recorded and fed to nothing ends in an arrow; one that pointed at a wire close by would seem to feed it. */
function checkTips({wires}) {
  for (const {from, points: [start, [x, y]]} of wires.filter((wire) => !wire.to)) {
    const ahead = Math.sign(x - start[0]) * 10, area = {left: Math.min(x, x + ahead), right: Math.max(x, x + ahead), top: y - 1, bottom: y + 1};
    const all = wires.filter((wire) => wire.points[1][0] !== x || wire.points[1][1] !== y).flatMap((wire) => segments(wire.points));
    assert.ok(!all.some((segment) => touches(segment, area)), `${JSON.stringify(from)} points at a wire`);
  }
}

/** From above at the sides, and from the left on top, where conditions enter. */
function checkPortOrder({blocks}) {
  const isOrdered = (places) => places.slice(1).every((place, i) => place > places[i]);
  for (const {id, inputs, outputs} of blocks.filter((one) => one.outline !== "circle"))
    for (const ports of [inputs, outputs]) {
      const onTop = ports.filter(({side}) => side === "NORTH"), beside = ports.filter(({side}) => side !== "NORTH");
      assert.ok(isOrdered(beside.map(({y}) => y)) && isOrdered(onTop.map(({x}) => x)), `ports of ${id} are not in order`);
      assert.ok(onTop.every(({condition}) => condition), `${id} has what is no condition on top`);
    }
}

/** Wires of different signals may cross, but never lie on each other. */
function checkApart({wires}) {
  const lines = wires.flatMap(({from, points}) => segments(points).map((segment) => ({net: `${from.node} ${from.port}`, ...segment})));
  const flat = (one) => near(one.top, one.bottom);
  lines.forEach((a, i) => lines.slice(0, i).forEach((b) => {
    if (a.net === b.net || flat(a) !== flat(b)) return;
    const along = flat(a) ? near(a.top, b.top) && a.left < b.right - 1e-6 && b.left < a.right - 1e-6
                          : near(a.left, b.left) && a.top < b.bottom - 1e-6 && b.top < a.bottom - 1e-6;
    assert.ok(!along, `${a.net} lies on ${b.net}`);
  }));
}

/** A line that is drawn twice would look bold. */
function checkDrawnOnce(svg) {
  const lines = [...svg.matchAll(/<path d="M([\d.]+ [\d.]+(?:L[\d.]+ [\d.]+)+)"\/>/g)]
    .flatMap(([, corners]) => segments(corners.split("L").map((corner) => corner.split(" ").map(Number))));
  lines.forEach((a, i) => lines.slice(0, i).forEach((b) => {
    const both = {left: Math.max(a.left, b.left), right: Math.min(a.right, b.right), top: Math.max(a.top, b.top), bottom: Math.min(a.bottom, b.bottom)};
    const shared = near(both.top, both.bottom) ? both.right - both.left : near(both.left, both.right) ? both.bottom - both.top : 0;
    assert.ok(shared < 1e-6, `a line from ${both.left} ${both.top} to ${both.right} ${both.bottom} is drawn twice`);
  }));
}

const count = (graph, what) => graph[what].length + graph.nodes.reduce((sum, node) => sum + (node.graph ? count(node.graph, what) : 0), 0);

const known = new Map();  // parts that have been laid out, of all files

for (const file of files)
  for (const depth of [0, 9])
    test(`${file.slice(root.length + 1)} is drawn well ${depth ? "with its parts opened" : "as it is"}`, async (context) => {
      const graph = graphOf(file, depth);
      if (!graph) return context.skip("its data are not here");
      const picture = await arrange(graph, elk, known);
      checkBlocks(picture);
      checkWires(picture);
      checkEnds(picture);
      checkWhole(picture);
      checkTips(picture);
      checkPortOrder(picture);
      checkApart(picture);
      assert.equal(picture.wires.filter((wire) => wire.to).length, count(graph, "wires"));
      checkDrawnOnce(svgOf(picture));
      if (depth === 0 && file.includes("/thesis/"))
        assert.equal(svgOf(picture), svgOf(await arrange(graph, elk)), "drawn twice it differs");
    });

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
