// A picture in rows, for what is too wide for one: every second row goes from right to left, as a way back does. Wires from
// row to row go around the ends of the rows.

import {startsOf} from "./feedback_edges.mjs";
import {mirrored} from "./mirror.mjs";
import {netOf, straightened} from "./wires.mjs";

const track = {first: 14, step: 9}, between = 16;

/** The nodes that can be divided, from left to right, with the left and right end of each. */
function inOrder(nodes, wires) {
  const starts = startsOf(nodes, wires), own = nodes.filter(({id}) => !id.startsWith(":"));
  return own.map(({id, width}) => ({id, from: starts.get(id), to: starts.get(id) + width})).sort((a, b) => a.from - b.from);
}

const reach = (nodes) => Math.max(...nodes.map(({to}) => to)) - Math.min(...nodes.map(({from}) => from));

/** The row of each node of two, so chosen that the wider of both is as little wide as can be; none where all stand abreast. */
function inTwo(order) {
  let best = {width: Infinity};
  for (let count = 1; count < order.length; ++count) {
    if (order[count].from === order[count - 1].from) continue;
    const width = Math.max(reach(order.slice(0, count)), reach(order.slice(count)));
    if (width < best.width) best = {width, rows: [order.slice(0, count), order.slice(count)]};
  }
  return best.rows;
}

/** Rows that are no wider than a limit where that can be had. */
function within(order, limit) {
  const rows = [];
  for (const node of order) {
    const row = rows.at(-1);
    if (row && (node.from === row.at(-1).from || reach([...row, node]) <= limit)) row.push(node);
    else rows.push([node]);
  }
  return rows;
}

/** So many rows, of which the widest is as little wide as can be. */
function inMany(order, count) {
  let low = 0, high = reach(order);
  while (high - low > 1) {
    const limit = (low + high) / 2;
    if (within(order, limit).length <= count) high = limit;
    else low = limit;
  }
  return within(order, high);
}

/** The row of each node, by its id; nothing where the nodes cannot be divided into so many rows. */
export function rowNumbers(nodes, wires, count) {
  const order = inOrder(nodes, wires), rows = count === 2 ? inTwo(order) : inMany(order, count);
  return rows?.length === count ? new Map(rows.flatMap((row, i) => row.map(({id}) => [id, i]))) : undefined;
}

/** The first row begins with what comes from outside. */
const rowIn = (numbers) => ({node}) => numbers.get(node) ?? 0;

/** True if each wire between rows leads from the end of its row to the end where the other row begins. */
export function turnsAtEnds({wires}, numbers) {
  const rowOf = rowIn(numbers);
  return wires.every(({from, to}) => from.constant !== undefined || rowOf(from) === rowOf(to) || (rowOf(from) + rowOf(to)) % 2 === 1);
}

/** The graphs of all rows. What is cut has a port of its own in each, which is marked. */
export function rowsOf(graph, numbers) {
  const rowOf = rowIn(numbers), cuts = Array.from({length: Math.max(...numbers.values()) + 1}, () => []);
  const isCut = ({from, to}) => from.constant === undefined && rowOf(from) !== rowOf(to);
  for (const {from, to} of graph.wires.filter(isCut)) {
    const known = cuts[rowOf(to)].some((cut) => cut.net === netOf({from}));
    if (!known) cuts[rowOf(to)].push({net: netOf({from}), from, isCut: true, port: `cut ${rowOf(to)} ${cuts[rowOf(to)].length}`});
  }
  // At either end what leaves one row highest reaches the other lowest, so that the ways nest.
  const isBelow = (row) => row % 2 === 1, reversed = (list, is) => (is ? [...list].reverse() : list);
  const entering = cuts.map((own, row) => reversed(own, isBelow(row)));
  const leaving = cuts.map((_, row) => cuts.flatMap((own, to) => reversed(own.filter(({from}) => rowOf(from) === row), !isBelow(to))));
  return cuts.map((_, row) => ({
    inputs: [...(row === 0 ? graph.inputs : []), ...entering[row]], outputs: [...(row === 0 ? graph.outputs : []), ...leaving[row]],
    nodes: graph.nodes.filter(({id}) => rowOf({node: id}) === row),
    wires: [
      ...graph.wires.filter((wire) => rowOf(wire.to) === row).map((wire) => (isCut(wire)
        ? {...wire, from: {node: "", port: cuts[row].find(({net}) => net === netOf(wire)).port}} : wire)),
      ...leaving[row].map(({from, port}) => ({from, to: {node: "", port}})),
    ],
  }));
}

const cutOf = ({node}, kind) => (node.startsWith(`:${kind}:cut `) ? node.slice(kind.length + 2) : undefined);

/** Moves a picture. */
const shift = ({blocks, wires}, dx, dy) => ({
  blocks: blocks.map((block) => ({...block, x: block.x + dx, y: block.y + dy})),
  wires: wires.map((wire) => ({...wire, points: wire.points.map(([x, y]) => [x + dx, y + dy])})),
});

/** The line to the end of its row, there up or down, and on in the other row. */
function joined(leaving, entering, x) {
  const out = leaving.points, into = entering.points;
  return straightened([...out, [x, out.at(-1)[1]], [x, into[0][1]], ...into]);
}

/** True if upright lines at the same end of the rows have heights in common. */
const meet = (a, b) => a.low < b.high + track.step && b.low < a.high + track.step;

/** How far from the rows each of the upright lines at one end stands: short ones nearer. */
function tracksOf(spans) {
  const placed = [];
  for (const span of [...spans].sort((a, b) => a.high - a.low - (b.high - b.low))) {
    const taken = new Set(placed.filter((other) => meet(span, other)).map(({place}) => place));
    let place = 0;
    while (taken.has(place)) ++place;
    placed.push({...span, place});
  }
  return new Map(placed.map(({cut, place}) => [cut, track.first + track.step * place]));
}

/** What leads to a row that goes to the left does so at the right end of the rows, what comes from it at the left one. */
const leadsDown = (cut) => Number(cut.split(" ")[1]) % 2 === 1;

/** The pieces of the wires that were cut: {cut, leaving, entering: [wire]}. */
function cutWires(wires) {
  const entering = wires.filter(({from}) => cutOf(from, "input") !== undefined);
  return wires.filter(({to}) => to && cutOf(to, "output") !== undefined).map((leaving) => {
    const cut = cutOf(leaving.to, "output");
    return {cut, leaving, entering: entering.filter(({from}) => cutOf(from, "input") === cut)};
  });
}

function spanOf({cut, leaving, entering}) {
  const ys = [leaving.points.at(-1)[1], ...entering.map(({points}) => points[0][1])];
  return {cut, low: Math.min(...ys), high: Math.max(...ys)};
}

/** All rows as one picture; every second one goes to the left. */
export function stacked(pictures) {
  const turned = pictures.map((picture, i) => (i % 2 === 1 ? mirrored(picture) : picture)), width = Math.max(...turned.map((one) => one.width));
  const room = (down) => {
    const count = cutWires(turned.flatMap((one) => one.wires)).filter(({cut}) => leadsDown(cut) === down).length;
    return count > 0 ? track.first + track.step * count : 0;
  };
  const left = room(false), right = room(true), end = left + width;
  let top = -between;
  const rows = turned.map((picture, i) => {
    const y = top + between;
    top = y + picture.height;
    return shift(picture, i % 2 === 1 ? end - picture.width : left, y);
  });
  const wires = rows.flatMap((row) => row.wires), cuts = cutWires(wires), pieces = new Set(cuts.flatMap((one) => [one.leaving, ...one.entering]));
  const tracks = [true, false].map((down) => tracksOf(cuts.filter(({cut}) => leadsDown(cut) === down).map(spanOf)));
  const ways = cuts.flatMap(({cut, leaving, entering}) => {
    const x = leadsDown(cut) ? end + tracks[0].get(cut) : left - tracks[1].get(cut);
    return entering.map((wire) => ({...wire, from: leaving.from, points: joined(leaving, wire, x)}));
  });
  return {
    width: end + right, height: top,
    blocks: rows.flatMap((row) => row.blocks).filter((block) => block.within || !block.id.includes(":cut ")),
    wires: [...wires.filter((wire) => !pieces.has(wire)), ...ways],
  };
}
