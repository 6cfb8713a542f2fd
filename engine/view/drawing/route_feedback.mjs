// Leads wires back below what they pass: out of a block to the right, down, to the left, up and into the other block.

import {openLength, sizes} from "./symbol.mjs";
import {widthOf} from "./text.mjs";

const track = {first: 19, last: 12, step: 6, below: 14}, margin = 10;

/** How far other wires keep away from blocks, so that so many may be led below beside each other. */
export const clearance = (count) => 20 + track.step * count;

/** What a node takes up, with its name and the arrows at what is recorded only. */
export function extent(node, place) {
  const overhang = node.nameSide ? Math.max(0, Math.ceil((widthOf(node.name, sizes.name) - node.width) / 2)) : 0;
  const name = (side) => (node.nameSide === side ? 18 : 0);
  const arrows = (side) => (node.outputs.some((port) => port.isOpen && port.side === side) ? openLength : 0);
  return {
    left: place.x - Math.max(overhang, arrows("WEST")), right: place.x + node.width + Math.max(overhang, arrows("EAST")),
    top: place.y - name("TOP"), bottom: place.y + node.height + name("BOTTOM"),
  };
}

/** The columns of a layout, from left to right; no two have an x in common. */
function columnsOf(nodes, places) {
  const extents = nodes.map((node) => [node.id, extent(node, places.get(node.id))]).sort(([, a], [, b]) => a.left - b.left);
  const columns = [], columnOf = new Map();
  for (const [id, {left, right}] of extents) {
    const last = columns.at(-1);
    if (!last || left >= last.right) columns.push({left, right, before: 0, behind: 0});
    else last.right = Math.max(last.right, right);
    columnOf.set(id, columns.at(-1));
  }
  return columnOf;
}

/** The lowest thing between two places, a block with its name or a wire. */
function floorBetween(left, right, nodes, places, lines) {
  let floor = 0;
  for (const node of nodes) {
    const box = extent(node, places.get(node.id));
    if (box.right > left && box.left < right) floor = Math.max(floor, box.bottom);
  }
  for (const points of lines.values())
    points.slice(1).forEach(([x, y], i) => {
      const [ax, ay] = points[i];
      if (Math.max(x, ax) > left && Math.min(x, ax) < right) floor = Math.max(floor, y, ay);
    });
  return floor;
}

/** Moves a layout to the right. */
function shift(dx, places, lines) {
  for (const place of places.values()) place.x += dx;
  for (const points of lines.values()) for (const point of points) point[0] += dx;
}

/**
 * Adds the lines of `wires`, the shortest way innermost. Returns what the picture measures with them, and how many of
 * them lie beside each other.
 */
export function routeFeedback(nodes, places, lines, wires, size) {
  const byId = new Map(nodes.map((node) => [node.id, node])), columns = columnsOf(nodes, places);
  const point = (end, ports) => {
    const port = byId.get(end.node)[ports].find((one) => one.port === end.port), {x, y} = places.get(end.node);
    return [x + port.x, y + port.y];
  };
  const tasks = wires.map((wire) => ({wire, start: point(wire.from, "outputs"), goal: point(wire.to, "inputs")}));
  let {width, height} = size, least = margin;
  for (const {wire, start, goal} of tasks.sort((a, b) => a.start[0] - a.goal[0] - (b.start[0] - b.goal[0]))) {
    const from = columns.get(wire.from.node), to = columns.get(wire.to.node);
    const right = from.right + track.first + track.step * from.behind++;
    const left = to.left - track.last - track.step * to.before++;
    const y = floorBetween(left, right, nodes, places, lines) + track.below;
    lines.set(wire, [start, [right, start[1]], [right, y], [left, y], [left, goal[1]], goal]);
    least = Math.min(least, left);
    width = Math.max(width, right + margin);
    height = Math.max(height, y + margin);
  }
  shift(margin - least, places, lines);
  const abreast = Math.max(0, ...[...columns.values()].map(({before, behind}) => Math.max(before, behind)));
  return {width: width + margin - least, height, abreast};
}
