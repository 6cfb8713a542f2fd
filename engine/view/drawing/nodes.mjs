// What is laid out beside the blocks of a graph: constants, and the ports of the file itself.

import {grouped} from "./groups.mjs";
import {drawnOutline} from "./symbol.mjs";

/** A port of the file itself: an oval, or inside of a frame a word. */
function ownPort(port, kind, isRoot) {
  const here = [{port: port.port, mark: port.mark}];
  return {
    id: `:${kind}:${port.port}`, name: "", outline: isRoot && !port.isCut ? "oval" : "text", lines: [port.label ?? ""], own: kind,
    inputs: kind === "output" ? here : [], outputs: kind === "input" ? here : [],
  };
}

/** A number that is written at an input as a node of its own, which keeps its name as long as the input has. */
function constantNode(wire, nodes) {
  const {node, port} = wire.to, id = `:constant:${node.slice(node.lastIndexOf(".") + 1)}.${port}`;
  nodes.push({id, name: "", outline: "text", lines: [wire.from.constant], inputs: [], outputs: [{port: "y"}]});
  return {node: id, port: "y"};
}

/** A block that has a sample time of its own shows it behind its name. */
const nameAndTime = ({name, every}) => (every ? `${name}, ${every}` : name);

/** True for an opened part in which a signal carries this name, so that its open end needs none. */
const isNamedWithin = ({graph}, mark) => Boolean(mark) && Boolean(graph?.nodes.some(({outputs}) => outputs.some((port) => port.mark === mark)));

/** All nodes and wires that are laid out for a graph; the graph itself stays as it is. */
export function nodesAndWires(whole, isRoot) {
  const graph = grouped(whole);
  const copy = (ports) => ports.map((port) => ({...port}));
  const inner = graph.nodes.map((node) => drawnOutline({...node, name: nameAndTime(node), inputs: copy(node.inputs), outputs: copy(node.outputs)}));
  const nodes = [
    ...graph.inputs.map((port) => ownPort(port, "input", isRoot)), ...inner,
    ...graph.outputs.map((port) => ownPort(port, "output", isRoot)),
  ];
  const end = (place, kind) => (place.node === "" ? {node: `:${kind}:${place.port}`, port: place.port} : place);
  const wires = graph.wires.map((wire) => ({
    ...wire,
    from: wire.from.constant === undefined ? end(wire.from, "input") : constantNode(wire, nodes),
    to: end(wire.to, "output"),
  }));
  const fed = new Set(wires.map(({from}) => `${from.node} ${from.port}`));
  for (const node of nodes)
    for (const port of node.outputs) {
      port.isOpen = Boolean(port.recorded) && !fed.has(`${node.id} ${port.port}`);
      if (port.isOpen && isNamedWithin(node, port.mark)) delete port.mark;
    }
  const byId = new Map(nodes.map((node) => [node.id, node]));
  for (const {from, unit} of wires)
    if (unit) byId.get(from.node).outputs.find((port) => port.port === from.port).unit = unit;
  return {nodes, wires};
}
