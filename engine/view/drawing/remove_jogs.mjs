// Takes small steps out of wires, which look like a slip: of two parallel pieces one moves onto the line of the other.

import {areaOf, grown, overlap} from "./area.mjs";
import {extent} from "./route_feedback.mjs";
import {segmentsOf, smallestStep, straightened} from "./wires.mjs";

const apart = 6, shortest = 10;

const isLevel = ([[, ay], [, by]]) => ay === by;
/** How far a piece goes along its line, negative to the left or upwards. */
const reach = (piece) => (isLevel(piece) ? piece[1][0] - piece[0][0] : piece[1][1] - piece[0][1]);

/** The line where the piece that begins at a corner lies on the line of another; the pieces beside it grow or shrink. */
function shifted(points, at, [x, y], level) {
  return points.map((point, i) => (i !== at && i !== at + 1 ? point : level ? [point[0], y] : [x, point[1]]));
}

/** True if a piece keeps its direction, and enough of its length for an arrow. */
function keepsShape(before, after) {
  return Math.sign(reach(before)) === Math.sign(reach(after)) && Math.abs(reach(after)) >= shortest;
}

/** True if a piece is beside all nodes, and along no other wire. */
function isFree(piece, wire, {nodes, places, lines}) {
  const way = areaOf(piece), ends = [wire.from.node, wire.to.node];
  const meetsNode = nodes.some((node) => overlap(grown(way, ends.includes(node.id) ? 0 : apart), extent(node, places.get(node.id))));
  return !meetsNode && ![...lines].some(([other, points]) => other !== wire && segmentsOf(points).some((segment) =>
    isLevel(segment) === isLevel(piece) && overlap(grown(way, apart), areaOf(segment))));
}

/** The line without the step between two corners, if the piece behind it or the one before it may move. */
function withoutStep(points, step, wire, picture) {
  const level = !isLevel([points[step], points[step + 1]]);
  for (const [at, onto, beside] of [[step + 1, step, step + 2], [step - 1, step + 1, step - 2]]) {
    if (at === 0 || at + 2 >= points.length) continue;
    const moved = shifted(points, at, points[onto], level), piece = (line, i) => [line[i], line[i + 1]];
    if (keepsShape(piece(points, beside), piece(moved, beside)) && isFree(piece(moved, at), wire, picture)) return straightened(moved);
  }
  return undefined;
}

/** Takes out of all wires the small steps that can be taken out. */
export function removeJogs(nodes, wires, places, lines) {
  for (const wire of wires)
    for (let step = 1; step + 2 < lines.get(wire).length; ++step) {
      const points = lines.get(wire);
      if (Math.abs(reach([points[step], points[step + 1]])) >= smallestStep) continue;
      const smoother = withoutStep(points, step, wire, {nodes, places, lines});
      if (smoother) lines.set(wire, smoother);
      if (smoother) step = 0;
    }
}
