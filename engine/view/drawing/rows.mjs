// A picture in two rows, for what is too wide for one: the second row lies below the first and goes from right to left, as a
// way back does. Wires from row to row go around the ends of the rows.

import {startsOf} from "./feedback_edges.mjs";
import {mirrored} from "./mirror.mjs";
import {netOf, straightened} from "./wires.mjs";

const track = {first: 14, step: 9}, between = 16;

/** The nodes of the second row, so chosen that the wider of both is as little wide as can be; none where all stand abreast. */
export function secondRow(nodes, wires) {
  const starts = startsOf(nodes, wires), own = nodes.filter(({id}) => !id.startsWith(":"));
  const order = own.map(({id}) => id).sort((a, b) => starts.get(a) - starts.get(b)), byId = new Map(own.map((node) => [node.id, node]));
  const reach = (ids) => {
    const from = Math.min(...ids.map((id) => starts.get(id))), to = Math.max(...ids.map((id) => starts.get(id) + byId.get(id).width));
    return to - from;
  };
  let best = {width: Infinity, row: new Set()};
  for (let count = 1; count < order.length; ++count) {
    if (starts.get(order[count]) === starts.get(order[count - 1])) continue;
    const width = Math.max(reach(order.slice(0, count)), reach(order.slice(count)));
    if (width < best.width) best = {width, row: new Set(order.slice(count))};
  }
  return best.row;
}

/** The graphs of both rows. What is cut has a port of its own in each, which is marked. */
export function rowsOf(graph, second) {
  const rowOf = ({node}) => (second.has(node) ? 1 : 0), cuts = [[], []];
  const isCut = ({from, to}) => from.constant === undefined && rowOf(from) !== rowOf(to);
  for (const {from, to} of graph.wires.filter(isCut)) {
    const known = cuts[rowOf(to)].some((cut) => cut.net === netOf({from}));
    if (!known) cuts[rowOf(to)].push({net: netOf({from}), from, isCut: true, port: `cut ${rowOf(to)} ${cuts[rowOf(to)].length}`});
  }
  // At either end what leaves one row highest reaches the other lowest, so that the ways nest.
  const entering = [cuts[0], [...cuts[1]].reverse()], leaving = [cuts[1], [...cuts[0]].reverse()];
  return [0, 1].map((row) => ({
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

/** Do lines that stand upright at the same end of the rows have heights in common? */
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

/** What leads to the lower row does so at the right end of the rows, what comes from it at the left one. */
const leadsDown = (cut) => cut.startsWith("cut 1");

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

/** Both rows as one picture; the second one goes to the left. */
export function stacked([upper, below]) {
  const lower = mirrored(below), width = Math.max(upper.width, lower.width);
  const room = (picture) => {
    const count = cutWires(picture.wires).length;
    return count > 0 ? track.first + track.step * count : 0;
  };
  const left = room(lower), right = room(upper), end = left + width;
  const rows = [shift(upper, left, 0), shift(lower, end - lower.width, upper.height + between)];
  const wires = rows.flatMap((row) => row.wires), cuts = cutWires(wires), pieces = new Set(cuts.flatMap((one) => [one.leaving, ...one.entering]));
  const tracks = [true, false].map((down) => tracksOf(cuts.filter(({cut}) => leadsDown(cut) === down).map(spanOf)));
  const ways = cuts.flatMap(({cut, leaving, entering}) => {
    const x = leadsDown(cut) ? end + tracks[0].get(cut) : left - tracks[1].get(cut);
    return entering.map((wire) => ({...wire, from: leaving.from, points: joined(leaving, wire, x)}));
  });
  return {
    width: end + right, height: upper.height + between + lower.height,
    blocks: rows.flatMap((row) => row.blocks).filter((block) => block.within || !block.id.includes(":cut ")),
    wires: [...wires.filter((wire) => !pieces.has(wire)), ...ways],
  };
}
