// Checks that hold for every picture of a diagram.

import assert from "node:assert/strict";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";

export const root = join(dirname(fileURLToPath(import.meta.url)), "../../../..");
export const drawing = join(root, "engine/view/drawing");
const {widthOf} = await import(join(drawing, "text.mjs"));
const {default: ELK} = await import(join(drawing, "node_modules/elkjs/lib/elk.bundled.js"));
export const elk = new ELK();

export const box = ({x, y, width, height}) => ({left: x, right: x + width, top: y, bottom: y + height});
export const overlap = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
export const shrunk = ({left, right, top, bottom}, by) => ({left: left + by, right: right - by, top: top + by, bottom: bottom - by});
export const segments = (points) => points.slice(1).map(([bx, by], i) => {
  const [ax, ay] = points[i];
  return {left: Math.min(ax, bx), right: Math.max(ax, bx), top: Math.min(ay, by), bottom: Math.max(ay, by)};
});
export const touches = (segment, area) =>
  segment.left < area.right && segment.right > area.left && segment.top < area.bottom && segment.bottom > area.top;

function nameBox(block) {
  const width = widthOf(block.name, 12), x = block.x + (block.width - width) / 2;
  return box({x, y: block.nameSide === "TOP" ? block.y - 15 : block.y + block.height + 5, width, height: 10});
}

const near = (a, b) => Math.abs(a - b) < 1e-6;
const isAt = ([x, y], [px, py]) => near(x, px) && near(y, py);
const place = (block, port) => [block.x + port.x, block.y + port.y];

export function checkBlocks({blocks, width, height}) {
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

export function checkWires({blocks, wires, width, height}) {
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
export function checkEnds({blocks, wires}) {
  const ends = (end, ports) => blocks.filter((block) => block.id === end.node)
    .flatMap((block) => block[ports].filter((port) => port.port === end.port).map((port) => place(block, port)));
  for (const {from, to, points} of wires) {
    assert.ok(ends(from, "outputs").some((port) => isAt(points[0], port)), `nothing begins at ${JSON.stringify(from)}`);
    if (to) assert.ok(ends(to, "inputs").some((port) => isAt(points.at(-1), port)), `nothing ends at ${JSON.stringify(to)}`);
  }
}

/** Blocks and wires lie at whole pixels: rounded one by one, a wire would miss its port. */
export function checkWhole({blocks, wires}) {
  for (const {id, x, y} of blocks) assert.ok(Number.isInteger(x) && Number.isInteger(y), `${id} lies between pixels`);
  for (const {from, points} of wires) assert.ok(points.flat().every(Number.isInteger), `${JSON.stringify(from)} between pixels`);
}

/** What is recorded and fed to nothing ends in an arrow; one that pointed at a wire close by would seem to feed it. */
export function checkTips({wires}) {
  for (const {from, points: [start, [x, y]]} of wires.filter((wire) => !wire.to)) {
    const ahead = Math.sign(x - start[0]) * 10, area = {left: Math.min(x, x + ahead), right: Math.max(x, x + ahead), top: y - 1, bottom: y + 1};
    const all = wires.filter((wire) => wire.points[1][0] !== x || wire.points[1][1] !== y).flatMap((wire) => segments(wire.points));
    assert.ok(!all.some((segment) => touches(segment, area)), `${JSON.stringify(from)} points at a wire`);
  }
}

/** From above at the sides, and from the left on top, where conditions enter. */
export function checkPortOrder({blocks}) {
  const isOrdered = (places) => places.slice(1).every((place, i) => place > places[i]);
  for (const {id, inputs, outputs} of blocks.filter((one) => one.outline !== "circle"))
    for (const ports of [inputs, outputs]) {
      const onTop = ports.filter(({side}) => side === "NORTH"), beside = ports.filter(({side}) => side !== "NORTH");
      assert.ok(isOrdered(beside.map(({y}) => y)) && isOrdered(onTop.map(({x}) => x)), `ports of ${id} are not in order`);
      assert.ok(onTop.every(({condition}) => condition), `${id} has what is no condition on top`);
    }
}

/** Wires of different signals may cross, but never lie on each other. */
export function checkApart({wires}) {
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
export function checkDrawnOnce(svg) {
  const lines = [...svg.matchAll(/<path d="M([\d.]+ [\d.]+(?:L[\d.]+ [\d.]+)+)"\/>/g)]
    .flatMap(([, corners]) => segments(corners.split("L").map((corner) => corner.split(" ").map(Number))));
  lines.forEach((a, i) => lines.slice(0, i).forEach((b) => {
    const both = {left: Math.max(a.left, b.left), right: Math.min(a.right, b.right), top: Math.max(a.top, b.top), bottom: Math.min(a.bottom, b.bottom)};
    const shared = near(both.top, both.bottom) ? both.right - both.left : near(both.left, both.right) ? both.bottom - both.top : 0;
    assert.ok(shared < 1e-6, `a line from ${both.left} ${both.top} to ${both.right} ${both.bottom} is drawn twice`);
  }));
}

/** How many there are of a kind in a graph and in the graphs of its parts. */
export const count = (graph, what) => graph[what].length + graph.nodes.reduce((sum, node) => sum + (node.graph ? count(node.graph, what) : 0), 0);
