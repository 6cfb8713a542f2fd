// Frames around blocks that no part of the file holds together: drawn like opened parts, but wires pass through their edge.

const netOf = ({node, port}) => JSON.stringify([node, port]);

/** Ports for wires that cross the edge, one for each signal, by the place where it begins. */
function crossing(wires) {
  const nets = [...new Set(wires.map(({from}) => netOf(from)))];
  return new Map(nets.map((net, i) => [net, String(i + 1)]));
}

const ports = (byNet) => [...byNet.values()].map((port) => ({port}));

/** The graph with one group as a node that has a graph of its own. */
function withGroup(graph, {name, members}) {
  const own = new Set(members), isIn = (end) => own.has(end.node), id = `group:${name}`;
  const inside = graph.nodes.filter((node) => own.has(node.id));
  if (inside.length === 0) return graph;
  const isInner = ({from, to}) => isIn(to) && (isIn(from) || from.constant !== undefined);
  const entering = graph.wires.filter((wire) => isIn(wire.to) && !isInner(wire));
  const leaving = graph.wires.filter(({from, to}) => isIn(from) && !isIn(to));
  const inputs = crossing(entering), outputs = crossing(leaving);
  const inner = {
    inputs: ports(inputs), outputs: ports(outputs), nodes: inside,
    wires: [
      ...graph.wires.filter(isInner),
      ...entering.map((wire) => ({...wire, from: {node: "", port: inputs.get(netOf(wire.from))}, unit: undefined})),
      ...[...outputs].map(([net, port]) => ({...leaving.find(({from}) => netOf(from) === net), to: {node: "", port}})),
    ],
  };
  const firstOf = (wire, i, all) => all.findIndex(({from}) => netOf(from) === netOf(wire.from)) === i;
  const outer = graph.wires.filter((wire) => !isInner(wire) && !isIn(wire.from) && !isIn(wire.to));
  const into = entering.filter(firstOf).map((wire) =>
    ({...wire, to: {node: id, port: inputs.get(netOf(wire.from))}}));
  const out = leaving.map((wire) => ({...wire, from: {node: id, port: outputs.get(netOf(wire.from))}, unit: undefined}));
  const node = {id, name, outline: "box", lines: [], isGroup: true, graph: inner, inputs: ports(inputs), outputs: ports(outputs)};
  const place = graph.nodes.indexOf(inside[0]), rest = graph.nodes.filter((one) => !own.has(one.id));
  return {...graph, nodes: [...rest.slice(0, place), node, ...rest.slice(place)], wires: [...outer, ...into, ...out]};
}

/** The graph with all of its groups. */
export const grouped = ({groups = [], ...graph}) => groups.reduce(withGroup, graph);
