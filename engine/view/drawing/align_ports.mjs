// Moves ports of the file and constants up or down to where their wire goes on, so that it needs no step.

import {areaOf, grown, overlap} from "./area.mjs";
import {extent} from "./route_feedback.mjs";
import {portPitch} from "./symbol.mjs";
import {netOf, segmentsOf} from "./wires.mjs";

const apart = {node: 4, wire: 9};

/** Nodes that one wire alone holds: no block of the file, and not the place of another wire's fork. */
function movable(nodes, wires) {
  const ends = new Map();
  for (const wire of wires)
    for (const {node} of [wire.from, wire.to]) ends.set(node, [...(ends.get(node) ?? []), wire]);
  return nodes.filter((node) => node.id.startsWith(":") && ends.get(node.id)?.length === 1)
    .map((node) => ({node, wire: ends.get(node.id)[0]}));
}

/** The step in a wire that begins at a node: level, upright, level; from its end where the node lies there. */
function stepOf(node, wire, lines) {
  const line = lines.get(wire), points = wire.from.node === node.id ? line : [...line].reverse();
  if (points.length < 4 || points[0][1] !== points[1][1] || points[2][1] !== points[3][1]) return undefined;
  const [start, , corner, ...rest] = points;
  return {piece: [[start[0], corner[1]], corner], by: corner[1] - start[1], rest};
}

/** True if words of a frame would change their order, or stand closer than ports of a block. */
function crowds(node, by, nodes, places) {
  if (node.outline !== "text" || !node.own) return false;
  const {y} = places.get(node.id), others = nodes.filter((other) => other !== node && other.own === node.own);
  return others.some(({id}) => {
    const before = places.get(id).y - y, after = before - by;
    return Math.sign(before) !== Math.sign(after) || Math.abs(after) < Math.min(portPitch, Math.abs(before));
  });
}

/** True if the way is free for a node at its new place, and for the piece of wire at it. */
function isFree(node, wire, {piece, by}, {nodes, places, lines}) {
  const {x, y} = places.get(node.id), box = grown(extent(node, {x, y: y + by}), apart.node), way = areaOf(piece);
  const farEnd = wire.from.node === node.id ? wire.to.node : wire.from.node;
  const meetsNode = nodes.filter((other) => other !== node).some((other) => {
    const taken = extent(other, places.get(other.id));
    return overlap(box, taken) || (other.id !== farEnd && overlap(grown(way, apart.wire), taken));
  });
  return !meetsNode && ![...lines].some(([other, points]) => other !== wire && segmentsOf(points).some((segment) => {
    // Wires of one signal may run together, but not cross.
    const room = netOf(other) === netOf(wire) ? way : grown(way, apart.wire);
    return overlap(box, areaOf(segment)) || overlap(room, areaOf(segment));
  }));
}

/** Moves what can be moved, until nothing moves any more; each move takes two bends away. */
export function alignPorts(nodes, wires, places, lines) {
  const ends = movable(nodes, wires);
  for (let moved = true; moved;) {
    moved = false;
    for (const {node, wire} of ends) {
      const step = stepOf(node, wire, lines);
      if (!step || crowds(node, step.by, nodes, places) || !isFree(node, wire, step, {nodes, places, lines})) continue;
      places.get(node.id).y += step.by;
      const points = [step.piece[0], ...step.rest];
      lines.set(wire, wire.from.node === node.id ? points : points.reverse());
      moved = true;
    }
  }
}
