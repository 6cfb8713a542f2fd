// Which way a signal goes: which wires lead back, and which blocks stand in a way back and are drawn from right to left.

/** Lists of wires by the node at which they begin and end. */
function indexWires(nodes, wires) {
  const out = new Map(nodes.map((node) => [node.id, []]));
  const into = new Map(nodes.map((node) => [node.id, []]));
  for (const wire of wires) {
    out.get(wire.from.node).push(wire);
    into.get(wire.to.node).push(wire);
  }
  return {out, into};
}

/** Wires that close a circle, found by a search in depth that begins at the sources. */
function backWires(nodes, {out, into}) {
  const back = new Set(), state = new Map();
  const starts = [...nodes.filter((node) => into.get(node.id).length === 0), ...nodes];
  for (const start of starts) {
    if (state.has(start.id)) continue;
    const stack = [{id: start.id, next: 0}];
    state.set(start.id, "open");
    while (stack.length > 0) {
      const top = stack.at(-1), wire = out.get(top.id)[top.next++];
      if (!wire) {
        state.set(top.id, "done");
        stack.pop();
      } else if (state.get(wire.to.node) === "open") {
        back.add(wire);
      } else if (!state.has(wire.to.node)) {
        state.set(wire.to.node, "open");
        stack.push({id: wire.to.node, next: 0});
      }
    }
  }
  return back;
}

const longestReturn = 4;

/**
 * The blocks between where a signal is taken and where it is fed back: each has one wire in and one out. Where nothing
 * else is taken from the loop, what is recorded counts as its end.
 */
function wayBack(wire, byId, {out, into}) {
  const way = [];
  for (let id = wire.from.node; ; id = into.get(id)[0].from.node) {
    const node = byId.get(id);
    const recorded = node.outputs.some((port) => port.recorded);
    if (out.get(id).length > 1 || (id === wire.to.node && recorded)) return way;
    const simple = into.get(id).length === 1 && (node.outline === "box" || node.outline === "triangle") && !node.graph;
    if (!simple || id === wire.to.node || way.length === longestReturn) {
      const end = way.findIndex((one) => byId.get(one).outputs.some((port) => port.recorded));
      return end < 0 ? [] : way.slice(0, end);
    }
    way.push(id);
  }
}

/** Finds the wires that run from right to left and the nodes that are drawn so. */
export function flowOf(nodes, wires) {
  const byId = new Map(nodes.map((node) => [node.id, node]));
  const index = indexWires(nodes, wires);
  const reversed = backWires(nodes, index), flipped = new Set();
  for (const wire of [...reversed]) {
    for (const id of wayBack(wire, byId, index)) {
      flipped.add(id);
      for (const one of [...index.out.get(id), ...index.into.get(id)]) reversed.add(one);
    }
  }
  return {reversed, flipped};
}
