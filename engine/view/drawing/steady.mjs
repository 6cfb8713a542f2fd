// A layout that keeps to an earlier one of nearly the same graph: nodes stay in their columns and in their order there, wires that
// led back lead back. elk heeds old places by its interactive strategies.

/** So far apart are columns at which elk looks, whatever the widths of their nodes. */
const pitch = 1e5;
/** Where so few nodes are known, an earlier layout is none for this graph. */
const leastKnown = 0.5;

/** The column of each node, counted from the left: those that lie above each other are one column. */
export function columnsOf(nodes, places) {
  const columns = {};
  let right = -Infinity, column = -1;
  for (const {id, width} of [...nodes].sort((a, b) => places.get(a.id).x - places.get(b.id).x)) {
    const {x} = places.get(id);
    if (x >= right) ++column;
    right = Math.max(right, x + width);
    columns[id] = column;
  }
  return columns;
}

/** What the next layout needs of one. */
export function keptOf(nodes, {places, style, flips, led}) {
  const heights = Object.fromEntries(nodes.map(({id}) => [id, places.get(id).y]));
  return {style, flips, led: led.size > 0, columns: columnsOf(nodes, places), heights, flipped: nodes.filter((node) => node.flipped).map(({id}) => id)};
}

/** A column for a node that is new: behind what it hears, before what hears it; between columns where there is none for it. */
function columnOfNew(id, wires, columns) {
  const known = (ids) => ids.filter((other) => columns.has(other)).map((other) => columns.get(other));
  const behind = Math.max(...known(wires.filter(({to}) => to.node === id).map(({from}) => from.node)));
  const before = Math.min(...known(wires.filter(({from}) => from.node === id).map(({to}) => to.node)));
  const all = [...columns.values()], next = (from) => Math.min(...all.filter((one) => one > from));
  const last = (from) => Math.max(...all.filter((one) => one < from));
  if (behind === -Infinity && before === Infinity) return 0;
  if (behind === -Infinity) return Number.isFinite(last(before)) ? last(before) : before - 1;
  if (next(behind) < before || before <= behind) return Number.isFinite(next(behind)) ? next(behind) : behind + 1;
  return before === Infinity ? behind + 1 : (behind + before) / 2;
}

/** The columns of all nodes; of new ones in the order in which signals reach them. */
function columnsNow(nodes, wires, kept) {
  const columns = new Map(nodes.filter(({id}) => id in kept.columns).map(({id}) => [id, kept.columns[id]]));
  const fresh = new Set(nodes.map(({id}) => id).filter((id) => !columns.has(id)));
  const isReady = (id) => wires.every(({from, to}) => to.node !== id || from.node === id || !fresh.has(from.node));
  while (fresh.size > 0) {
    const id = [...fresh].find(isReady) ?? [...fresh][0];
    columns.set(id, columnOfNew(id, wires, columns));
    fresh.delete(id);
  }
  return columns;
}

/**
 * What a layout of these nodes keeps of an earlier one: {back, reversed, flipped} as feedbackEdges gives it, and for elk the
 * {x, y} of each node, y only of what was there. undefined where too little is known of them.
 */
export function steadied(nodes, wires, kept) {
  const known = nodes.filter(({id}) => kept.columns && id in kept.columns);
  if (known.length < leastKnown * nodes.length) return undefined;
  const columns = columnsNow(nodes, wires, kept), ids = new Set(kept.flipped), flipped = new Set(known.map(({id}) => id).filter((id) => ids.has(id)));
  const reversed = new Set(wires.filter(({from, to}) => columns.get(from.node) > columns.get(to.node) || from.node === to.node));
  const back = new Set([...reversed].filter(({from, to}) => !flipped.has(from.node) && !flipped.has(to.node)));
  const hints = new Map(nodes.map(({id}) => [id, {x: pitch * columns.get(id), y: kept.heights[id]}]));
  return {back, reversed, flipped, hints};
}
