// Lines of wires: what lies on them, where they fork, how good they look.

export const netOf = (wire) => `${wire.from.node} ${wire.from.port}`;
export const segmentsOf = (points) => points.slice(1).map((point, i) => [points[i], point]);

const between = (a, b, value) => Math.min(a, b) <= value && value <= Math.max(a, b);
const inside = (a, b, value) => Math.min(a, b) < value && value < Math.max(a, b);
export const lies = ([x, y], [[ax, ay], [bx, by]]) => between(ax, bx, x) && between(ay, by, y);

/** Corners without those at which a line goes on straight or stands still. */
export function straightened(points) {
  return points.filter(([x, y], i) => {
    if (i === 0 || i === points.length - 1) return true;
    const [[ax, ay], [bx, by]] = [points[i - 1], points[i + 1]];
    return !((ax === x && bx === x) || (ay === y && by === y));
  });
}

function groupedByNet(wires) {
  const nets = new Map();
  for (const wire of wires) nets.set(netOf(wire), [...(nets.get(netOf(wire)) ?? []), wire.points]);
  return nets;
}

function directionsAt([x, y], segments) {
  const directions = new Set();
  for (const [[ax, ay], [bx, by]] of segments.filter((segment) => lies([x, y], segment))) {
    if (Math.min(ax, bx) < x) directions.add("left");
    if (Math.max(ax, bx) > x) directions.add("right");
    if (Math.min(ay, by) < y) directions.add("up");
    if (Math.max(ay, by) > y) directions.add("down");
  }
  return directions;
}

/** Places where a wire forks: from there it goes on in three directions or more. */
export function forks(wires) {
  const found = new Map();
  for (const lines of groupedByNet(wires).values()) {
    const segments = lines.flatMap(segmentsOf);
    for (const point of lines.flat()) if (directionsAt(point, segments).size > 2) found.set(point.join(" "), point);
  }
  return [...found.values()];
}

/** True if an upright segment crosses a level one, and does not only touch it. */
function cross([[ax, ay], [bx, by]], [[cx, cy], [dx, dy]]) {
  if (ax === bx) return cy === dy && inside(cx, dx, ax) && inside(ay, by, cy);
  return cx === dx && inside(ax, bx, cx) && inside(cy, dy, ay);
}

function crossings(wires) {
  const nets = [...groupedByNet(wires).values()].map((lines) => lines.flatMap(segmentsOf));
  let count = 0;
  for (let i = 0; i < nets.length; ++i)
    for (let j = 0; j < i; ++j)
      for (const segment of nets[i]) count += nets[j].filter((other) => cross(segment, other)).length;
  return count;
}

const length = (points) => segmentsOf(points).reduce((sum, [a, b]) => sum + Math.abs(a[0] - b[0]) + Math.abs(a[1] - b[1]), 0);

/** True if a wire that leads back keeps below its ends, as a reader expects. */
export function passesBelow({points}) {
  const level = segmentsOf(points).filter(([a, b]) => a[1] === b[1]);
  const longest = level.reduce((best, one) => (length(one) > length(best) ? one : best), level[0]);
  return !longest || longest[0][1] >= Math.max(points[0][1], points.at(-1)[1]) - 1;
}

/** Steps that are smaller look like a slip. */
export const smallestStep = 16;

const kinks = ({points}) => segmentsOf(points).slice(1, -1).filter((segment) => length(segment) < smallestStep).length;

const sum = (numbers) => numbers.reduce((total, number) => total + number, 0);

/**
 * What the wires of a picture cost a reader: bends, slips, crossings, ways back that do not pass below, length.
 * `faults` counts what other layouts may do better, `crossed` crossings.
 */
export function costOf(wires, back) {
  const bends = sum(wires.map((wire) => wire.points.length - 2)), slips = sum(wires.map(kinks));
  const astray = wires.filter((wire, i) => back[i] && !passesBelow(wire)).length, crossed = crossings(wires);
  const total = bends + 3 * slips + 3 * crossed + 8 * astray + sum(wires.map((wire) => length(wire.points))) / 500;
  return {total, faults: slips + astray, crossed};
}
