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

/**
 * Wires that close a circle, found by a search in depth that begins at the sources, and in loops without sources where
 * something is compared.
 */
function backWires(nodes, {out, into}) {
  const back = new Set(), state = new Map();
  const sources = nodes.filter((node) => into.get(node.id).length === 0);
  const comparisons = nodes.filter((node) => node.inputs.some((port) => port.sign === "-"));
  const starts = [...sources, ...comparisons, ...nodes];
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
const columnGap = 40;

/**
 * The blocks between where a signal is taken and where it is fed back: each has one wire in and one out. Where nothing
 * else is taken from the loop, they end at what is recorded or has a state, the plant.
 */
function wayBack(wire, byId, {out, into}) {
  const way = [], recorded = (id) => byId.get(id).outputs.filter((port) => port.recorded);
  const isWired = (id, port) => out.get(id).some((one) => one.from.port === port.port);
  const takers = (id) => out.get(id).length + recorded(id).filter((port) => !isWired(id, port)).length;
  for (let id = wire.from.node; ; id = into.get(id)[0].from.node) {
    const {outline} = byId.get(id);
    if (takers(id) > 1) return way;
    const simple = into.get(id).length === 1 && (outline === "box" || outline === "triangle");
    if (!simple || id === wire.to.node || way.length === longestReturn) break;
    way.push(id);
  }
  const isPlant = (id) => byId.get(id).state || recorded(id).length > 0;
  const end = way.findIndex(isPlant);
  return end >= 0 ? way.slice(0, end) : isPlant(wire.to.node) ? way : [];
}

/** How far from the left each node begins where all wires but those back lead to the right, side by side. */
export function startsOf(nodes, wires) {
  const starts = new Map(nodes.map(({id}) => [id, 0])), widths = new Map(nodes.map(({id, width}) => [id, width]));
  const back = backWires(nodes, indexWires(nodes, wires)), forward = wires.filter((wire) => !back.has(wire));
  for (let moved = true; moved;) {
    moved = false;
    for (const {from, to} of forward) {
      const start = starts.get(from.node) + widths.get(from.node) + columnGap;
      if (start <= starts.get(to.node)) continue;
      starts.set(to.node, start);
      moved = true;
    }
  }
  return starts;
}

/**
 * The wires that close circles, and where `flip` is true the nodes in ways back, which are drawn from right to left as
 * their wires are.
 */
export function feedbackEdges(nodes, wires, flip) {
  const byId = new Map(nodes.map((node) => [node.id, node]));
  const index = indexWires(nodes, wires);
  const back = backWires(nodes, index), reversed = new Set(back), flipped = new Set();
  for (const wire of flip ? back : []) {
    for (const id of wayBack(wire, byId, index)) {
      flipped.add(id);
      reversed.add(index.out.get(id)[0]);
      // From where the way back leads to, its first wire goes forward around the first block.
      if (index.into.get(id)[0].from.node !== wire.to.node) reversed.add(index.into.get(id)[0]);
    }
  }
  return {back, reversed, flipped};
}
