// Lays out a graph with the layered algorithm of elk: a picture is blocks and wires with places, in pixels.

import {flowOf} from "./flow.mjs";
import {drawnOutline, sizeOf, sizes, spread} from "./symbol.mjs";
import {widthOf} from "./text.mjs";

const options = {
  "elk.algorithm": "layered",
  "elk.direction": "RIGHT",
  "elk.edgeRouting": "ORTHOGONAL",
  "elk.padding": "[top=10,left=10,bottom=10,right=10]",
  "elk.spacing.nodeNode": "22",
  "elk.spacing.edgeNode": "14",
  "elk.spacing.edgeEdge": "12",
  "elk.spacing.labelNode": "4",
  "elk.layered.spacing.nodeNodeBetweenLayers": "34",
  "elk.layered.spacing.edgeNodeBetweenLayers": "16",
  "elk.layered.spacing.edgeEdgeBetweenLayers": "10",
  "elk.layered.nodePlacement.strategy": "NETWORK_SIMPLEX",
  "elk.layered.considerModelOrder.strategy": "PREFER_NODES",
  "elk.layered.thoroughness": "40",
  "elk.randomSeed": "1",
};
const frame = {head: 22, margin: 12};
const nameHeight = 15;

const inputSide = (node) => (node.flipped ? "EAST" : "WEST");
const outputSide = (node) => (node.flipped ? "WEST" : "EAST");

/** Constants as nodes of their own, and the ports of the file itself as ovals, or as words inside of a frame. */
function prepare(graph, isRoot) {
  const nodes = graph.nodes.map((node) => drawnOutline({...node}));
  const own = (port, kind) => ({
    id: `:${kind}:${port.port}`, name: "", outline: isRoot ? "oval" : "text", lines: [port.label], own: kind,
    inputs: kind === "output" ? [{port: port.port}] : [], outputs: kind === "input" ? [{port: port.port}] : [],
  });
  nodes.unshift(...graph.inputs.map((port) => own(port, "input")));
  nodes.push(...graph.outputs.map((port) => own(port, "output")));
  const end = (place, kind) => (place.node === "" ? {node: `:${kind}:${place.port}`, port: place.port} : place);
  const wires = graph.wires.map((wire, index) => {
    const to = end(wire.to, "output");
    if (wire.from.constant === undefined) return {...wire, from: end(wire.from, "input"), to};
    const id = `:constant:${index}`;
    nodes.push({id, name: "", outline: "text", lines: [wire.from.constant], inputs: [], outputs: [{port: "y"}]});
    return {...wire, from: {node: id, port: "y"}, to};
  });
  return {nodes, wires: [...wires, ...openEnds(nodes, wires)]};
}

/** What is recorded and fed to nothing ends in an arrow. */
function openEnds(nodes, wires) {
  const used = new Set(wires.map((wire) => `${wire.from.node} ${wire.from.port}`)), ends = [];
  for (const node of [...nodes])
    for (const port of node.outputs) {
      if (!port.recorded || used.has(`${node.id} ${port.port}`)) continue;
      const id = `:end:${node.id}.${port.port}`;
      nodes.push({id, name: "", outline: "end", lines: [], inputs: [{port: "u"}], outputs: []});
      ends.push({from: {node: node.id, port: port.port}, to: {node: id, port: "u"}});
    }
  return ends;
}

/** Puts ports on the outline of a node: side and place along it. */
function placePorts(node) {
  const side = (ports, name) => {
    const at = node.inner ? node.inner[name] : spread(ports.length, node.height);
    ports.forEach((port, i) => Object.assign(port, {side: name, y: at[i], x: name === "WEST" ? 0 : node.width}));
  };
  if (node.outline === "circle") placeOnCircle(node);
  else side(node.inputs, inputSide(node));
  side(node.outputs, outputSide(node));
}

function placeOnCircle(node) {
  const middle = node.width / 2;
  const places = {WEST: [0, middle], EAST: [node.width, middle], NORTH: [middle, 0], SOUTH: [middle, node.width]};
  for (const port of node.inputs) {
    port.side ??= inputSide(node);
    [port.x, port.y] = places[port.side];
  }
}

/** Sides at which signals enter a sum: what comes back from below, what leads there from the left, others by height. */
function enterSums(nodes, reversed, wires, heights) {
  for (const node of nodes.filter((one) => one.outline === "circle")) {
    const feeding = (port) => wires.find((wire) => wire.to.node === node.id && wire.to.port === port.port);
    const free = ["WEST", "SOUTH", "NORTH"];
    const take = (port, side) => {
      port.side = free.includes(side) ? side : free[0];
      free.splice(free.indexOf(port.side), 1);
    };
    const back = node.inputs.filter((port) => reversed.has(feeding(port)));
    const forward = node.inputs.filter((port) => !back.includes(port));
    const byHeight = [...forward].sort((a, b) => heights.get(feeding(a)) - heights.get(feeding(b)));
    const straight = forward.length === 3 ? byHeight[1] : forward[0];
    if (straight) take(straight, "WEST");
    for (const port of back) take(port, "SOUTH");
    for (const port of forward)
      if (port !== straight)
        take(port, heights.get(feeding(port)) < heights.get(feeding(straight)) ? "NORTH" : "SOUTH");
  }
}

function nameSide(node) {
  if (node.outline !== "circle") return "BOTTOM";
  const used = new Set(node.inputs.map((port) => port.side));
  return !used.has("NORTH") ? "TOP" : !used.has("SOUTH") ? "BOTTOM" : "";
}

function elkNode(node) {
  const ports = [...node.inputs, ...node.outputs].map((port) => ({
    id: `${node.id} ${port.port}`, x: port.x, y: port.y, width: 0, height: 0,
    layoutOptions: {"elk.port.side": port.side},
  }));
  const layoutOptions = {"elk.portConstraints": "FIXED_POS"};
  if (node.own && node.outline === "text") {
    layoutOptions["elk.layered.layering.layerConstraint"] = node.own === "input" ? "FIRST_SEPARATE" : "LAST_SEPARATE";
    layoutOptions["elk.alignment"] = node.own === "input" ? "LEFT" : "RIGHT";
  }
  const labels = [];
  node.nameSide = node.name && !node.inner ? nameSide(node) : "";
  if (node.nameSide) {
    labels.push({text: node.name, width: widthOf(node.name, sizes.name), height: nameHeight});
    layoutOptions["elk.nodeLabels.placement"] = `[H_CENTER, V_${node.nameSide}, OUTSIDE]`;
  }
  return {id: node.id, width: node.width, height: node.height, ports, labels, layoutOptions};
}

async function layOut(nodes, wires, reversed, elk) {
  const port = (end) => `${end.node} ${end.port}`;
  const edges = wires.map((wire, i) => {
    const [from, to] = reversed.has(wire) ? [wire.to, wire.from] : [wire.from, wire.to];
    return {id: `wire ${i}`, sources: [port(from)], targets: [port(to)]};
  });
  return elk.layout({id: "picture", layoutOptions: options, children: nodes.map(elkNode), edges});
}

function routes(laid, wires, reversed) {
  return wires.map((wire, i) => {
    const {startPoint, bendPoints = [], endPoint} = laid.edges[i].sections[0];
    const points = [startPoint, ...bendPoints, endPoint].map(({x, y}) => [x, y]);
    return reversed.has(wire) ? points.reverse() : points;
  });
}

/** An opened part is a frame around its own picture, whose ports lie where its words for them are. */
async function openPart(node, elk) {
  const picture = await arrange(node.graph, elk, false);
  const at = (kind) => picture.blocks.filter((block) => block.own === kind).map((block) => block.y + block.height / 2);
  const down = (ys) => ys.map((y) => y + frame.head);
  node.width = Math.max(picture.width, widthOf(node.name, sizes.name) + 2 * frame.margin);
  node.height = picture.height + frame.head;
  node.inner = {picture, WEST: down(at("input")), EAST: down(at("output"))};
}

/** Moves what lies in a frame to where the frame is. */
function embed(block, picture) {
  const {picture: inner} = block.inner, dx = block.x, dy = block.y + frame.head;
  const move = ([x, y]) => [x + dx, y + dy];
  picture.blocks.push(...inner.blocks.map((one) => ({...one, x: one.x + dx, y: one.y + dy})));
  picture.wires.push(...inner.wires.map((wire) => ({...wire, points: wire.points.map(move)})));
}

/**
 * The picture of a graph: {width, height, blocks, wires}. A block is a node with x, y, width, height and ports that
 * have a side and a place on it; a wire has the corners that it goes through.
 */
export async function arrange(graph, elk, isRoot = true) {
  const {nodes, wires} = prepare(graph, isRoot);
  for (const node of nodes) {
    if (node.graph) await openPart(node, elk);
    else Object.assign(node, node.outline === "end" ? {width: 2, height: 2} : sizeOf(node));
  }
  const {reversed, flipped} = flowOf(nodes, wires);
  for (const node of nodes) node.flipped = flipped.has(node.id);
  nodes.forEach(placePorts);
  const trial = routes(await layOut(nodes, wires, reversed, elk), wires, reversed);
  enterSums(nodes, reversed, wires, new Map(wires.map((wire, i) => [wire, trial[i][0][1]])));
  nodes.forEach(placePorts);
  const laid = await layOut(nodes, wires, reversed, elk);
  const places = new Map(laid.children.map(({id, x, y}) => [id, {x, y}]));
  const picture = {width: laid.width, height: laid.height, blocks: [], wires: []};
  const points = routes(laid, wires, reversed);
  for (const node of nodes) picture.blocks.push(Object.assign(node, places.get(node.id)));
  picture.wires.push(...wires.map((wire, i) => ({...wire, points: points[i]})));
  for (const block of [...picture.blocks]) if (block.inner) embed(block, picture);
  return picture;
}
