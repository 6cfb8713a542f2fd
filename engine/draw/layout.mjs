// Lays out a graph with the layered algorithm of elk: a picture is blocks and wires with places, in pixels.

import {clearance, leadBelow} from "./below.mjs";
import {flowOf} from "./flow.mjs";
import {nodesAndWires} from "./nodes.mjs";
import {enterSums, nameSide, placePorts} from "./ports.mjs";
import {portPitch, sizeOf, sizes} from "./symbol.mjs";
import {widthOf} from "./text.mjs";
import {costOf, straightened} from "./wires.mjs";

const options = {
  "elk.algorithm": "layered",
  "elk.direction": "RIGHT",
  "elk.edgeRouting": "ORTHOGONAL",
  "elk.separateConnectedComponents": "false",
  "elk.padding": "[top=10,left=12,bottom=10,right=12]",
  "elk.spacing.nodeNode": "22",
  "elk.spacing.edgeNode": "10",
  "elk.spacing.edgeEdge": "12",
  "elk.spacing.portPort": String(portPitch),
  "elk.spacing.labelNode": "4",
  "elk.layered.spacing.nodeNodeBetweenLayers": "36",
  "elk.layered.spacing.edgeEdgeBetweenLayers": "10",
  "elk.layered.considerModelOrder.strategy": "PREFER_NODES",
  "elk.randomSeed": "1",
};
const placement = "elk.layered.nodePlacement.strategy";
const alignment = "elk.layered.nodePlacement.bk.fixedAlignment";
/** Ways to place nodes, of which the picture that reads best is taken. */
const placements = [
  {[placement]: "NETWORK_SIMPLEX"},
  {[placement]: "BRANDES_KOEPF", [alignment]: "BALANCED"},
  ...["LEFTUP", "LEFTDOWN", "RIGHTUP", "RIGHTDOWN"].map((side) => ({[placement]: "BRANDES_KOEPF", [alignment]: side})),
];
const frame = {head: 22, margin: 12};
const nameHeight = 15;
const openLength = 15;
const close = {"elk.spacing.nodeNode": 8};

/** Ports by their place, since an input and an output may have one name. */
const inputId = (end) => `${end.node} < ${end.port}`;
const outputId = (end) => `${end.node} > ${end.port}`;
const portsOf = (node) => [
  ...node.inputs.map((port) => ({id: inputId({node: node.id, port: port.port}), ...port})),
  ...node.outputs.map((port) => ({id: outputId({node: node.id, port: port.port}), ...port})),
];

function elkNode(node) {
  const ports = portsOf(node).map((port) => ({
    id: port.id, x: port.x, y: port.y, width: 0, height: 0,
    labels: port.unit ? [{text: port.unit, width: widthOf(port.unit, sizes.unit), height: sizes.unit}] : [],
    layoutOptions: {"elk.port.side": port.side},
  }));
  const layoutOptions = {"elk.portConstraints": "FIXED_POS", "elk.portLabels.placement": "OUTSIDE"}, labels = [];
  if (node.nameSide) {
    labels.push({text: node.name, width: widthOf(node.name, sizes.name), height: nameHeight});
    layoutOptions["elk.nodeLabels.placement"] = `[H_CENTER, V_${node.nameSide}, OUTSIDE]`;
  }
  const individualSpacings = node.outline === "text" ? close : undefined;
  return {id: node.id, width: node.width, height: node.height, ports, labels, layoutOptions, individualSpacings};
}

const isWord = (node) => node.own && node.outline === "text";

/** The words for the inputs of a frame, or for its outputs, as one node at its edge that keeps their order. */
function edgeNode(kind, words) {
  const side = kind === "input" ? "EAST" : "WEST", end = kind === "input" ? "FIRST" : "LAST";
  const ports = words.map((word, i) => ({
    id: portsOf(word)[0].id, width: 0, height: 0,
    layoutOptions: {"elk.port.side": side, "elk.port.index": String(side === "EAST" ? i : words.length - i)},
  }));
  const layoutOptions = {
    "elk.portConstraints": "FIXED_ORDER",
    "elk.spacing.portPort": String(portPitch),
    "elk.layered.layering.layerConstraint": `${end}_SEPARATE`,
    "elk.layered.nodePlacement.networkSimplex.nodeFlexibility": "NODE_SIZE",
  };
  const width = Math.max(...words.map((word) => word.width));
  return {id: `:${kind}s`, width, height: words.length * portPitch, ports, layoutOptions};
}

function elkNodes(nodes) {
  const words = (kind) => nodes.filter((node) => isWord(node) && node.own === kind);
  const edges = ["input", "output"].filter((kind) => words(kind).length > 0).map((kind) => edgeNode(kind, words(kind)));
  return [...nodes.filter((node) => !isWord(node)).map(elkNode), ...edges];
}

/** How far from the port at which a signal begins its unit stands. */
function unitsOf(laid) {
  return new Map(laid.children.flatMap((child) => child.ports.filter((port) => port.labels?.length > 0)
    .map(({id, labels: [{x, y}]}) => [id, [x, y]])));
}

/** Where each node lies; words at their ports, left or right at the edge. */
function placesOf(nodes, laid) {
  const found = new Map(laid.children.map((child) => [child.id, child]));
  return new Map(nodes.map((node) => {
    if (!isWord(node)) return [node.id, {x: found.get(node.id).x, y: found.get(node.id).y}];
    const edge = found.get(`:${node.own}s`), own = edge.ports.find((port) => port.id === portsOf(node)[0].id);
    const x = node.own === "input" ? edge.x : edge.x + edge.width - node.width;
    return [node.id, {x, y: Math.round(edge.y + own.y) - node.height / 2}];
  }));
}

/** Lets wires begin and end at words, not at the edge of the widest of them, at whole heights. */
function reachWords(nodes, places, lines) {
  const words = new Map(nodes.filter(isWord).map((node) => [node.id, node]));
  for (const [wire, points] of lines) {
    const from = words.get(wire.from.node), to = words.get(wire.to.node);
    for (const point of from ? points.slice(0, 2) : []) point[1] = places.get(from.id).y + from.height / 2;
    for (const point of to ? points.slice(-2) : []) point[1] = places.get(to.id).y + to.height / 2;
    if (from) points[0][0] = places.get(from.id).x + from.width;
    if (to) points.at(-1)[0] = places.get(to.id).x;
  }
}

function linesOf(laid, wires, reversed) {
  const lines = new Map();
  for (const {id, sections: [{startPoint, bendPoints = [], endPoint}]} of laid.edges) {
    const points = [startPoint, ...bendPoints, endPoint].map(({x, y}) => [x, y]);
    lines.set(wires[id], reversed.has(wires[id]) ? points.reverse() : points);
  }
  return lines;
}

/** One layout: the place of each node and the corners of each wire, but for those that are led below afterwards. */
async function layOut({nodes, wires, reversed}, elk, style, apart = new Set(), abreast = Math.min(1, apart.size)) {
  const edges = wires.map((wire, i) => {
    const ends = [outputId(wire.from), inputId(wire.to)], [source, target] = reversed.has(wire) ? ends.reverse() : ends;
    return {id: String(i), sources: [source], targets: [target]};
  });
  const between = {"elk.layered.spacing.edgeNodeBetweenLayers": String(clearance(abreast))};
  const laid = await elk.layout({
    id: "picture", layoutOptions: {...options, ...style, ...between},
    children: elkNodes(nodes), edges: edges.filter((_, i) => !apart.has(wires[i])),
  });
  const places = placesOf(nodes, laid), lines = linesOf(laid, wires, reversed);
  reachWords(nodes, places, lines);
  const bounds = leadBelow(nodes, places, lines, [...apart], {width: laid.width, height: laid.height});
  if (bounds.abreast > abreast) return layOut({nodes, wires, reversed}, elk, style, apart, bounds.abreast);
  return {...bounds, places, units: unitsOf(laid), wires: wires.map((wire) => ({...wire, points: straightened(lines.get(wire))}))};
}

/** The best of several layouts; first all wires are laid out alike, then what leads back to a box is led below. */
async function bestLayout(task, elk) {
  const sides = new Map(task.nodes.flatMap(portsOf).map(({id, side}) => [id, side])), back = task.wires.map((wire) => task.back.has(wire));
  const apart = [...task.back].filter(({from, to}) => sides.get(outputId(from)) === "EAST" && sides.get(inputId(to)) === "WEST");
  let best = {cost: {total: Infinity, faults: Infinity}};
  for (const led of apart.length > 0 ? [new Set(), new Set(apart)] : [new Set()])
    for (const style of placements) {
      const laid = await layOut(task, elk, style, led), cost = costOf(laid.wires, back);
      if (cost.total < best.cost.total) best = {...laid, cost};
      if (best.cost.faults === 0) return best;
    }
  return best;
}

/** The ports of all nodes, once it is known which wires lead back and which nodes are drawn from right to left. */
async function settlePorts(task, elk) {
  const {nodes, wires, reversed, flipped} = task;
  for (const node of nodes) {
    node.flipped = flipped.has(node.id);
    for (const port of node.inputs) delete port.side;
    placePorts(node);
  }
  const chooseNameSides = () => nodes.forEach((node) => { node.nameSide = node.name && !node.inner ? nameSide(node) : ""; });
  chooseNameSides();
  if (!nodes.some((node) => node.outline === "circle")) return;
  const trial = await layOut(task, elk, placements[0]);
  enterSums(nodes, wires, reversed, new Map(wires.map((wire, i) => [wire, trial.wires[i].points[0][1]])));
  nodes.forEach(placePorts);
  chooseNameSides();
}

/** Lays out with ways back from right to left; where these find no good place, also without, and takes the better. */
async function layOutLoops(nodes, wires, elk) {
  const attempt = async (flip) => {
    const task = {nodes, wires, ...flowOf(nodes, wires, flip)};
    await settlePorts(task, elk);
    return {task, laid: await bestLayout(task, elk)};
  };
  const first = await attempt(true);
  if (first.laid.cost.faults === 0 || first.task.flipped.size === 0) return first.laid;
  const second = await attempt(false);
  if (second.laid.cost.total < first.laid.cost.total) return second.laid;
  await settlePorts(first.task, elk);
  return first.laid;
}

/** What is recorded and fed to nothing ends in an arrow; no wire turns that close to a block. */
function openEnds(nodes, wires) {
  const used = new Set(wires.map((wire) => `${wire.from.node} ${wire.from.port}`));
  return nodes.flatMap((node) => node.outputs.filter((port) => port.recorded && !used.has(`${node.id} ${port.port}`))
    .map((port) => {
      const x = node.x + port.x, y = node.y + port.y, end = port.side === "EAST" ? x + openLength : x - openLength;
      return {from: {node: node.id, port: port.port}, points: [[x, y], [end, y]]};
    }));
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
  const move = ([x, y]) => [x + dx, y + dy], within = (one) => [block.id, ...(one.within ?? [])];
  picture.blocks.push(...inner.blocks.map((one) => ({...one, within: within(one), x: one.x + dx, y: one.y + dy})));
  picture.wires.push(...inner.wires.map((wire) => ({...wire, within: within(wire), points: wire.points.map(move)})));
}

/**
 * The picture of a graph: {width, height, blocks, wires}. A block is a node with x, y, width, height and ports that
 * have a side and a place on it; a wire has the corners that it goes through. What lies in frames names them in `within`.
 */
export async function arrange(graph, elk, isRoot = true) {
  const {nodes, wires} = nodesAndWires(graph, isRoot);
  for (const node of nodes) {
    if (node.graph) await openPart(node, elk);
    else Object.assign(node, sizeOf(node));
  }
  const laid = await layOutLoops(nodes, wires, elk);
  const blocks = nodes.map((node) => Object.assign(node, laid.places.get(node.id)));
  for (const node of nodes)
    for (const port of node.outputs) port.unitAt = laid.units.get(outputId({node: node.id, port: port.port}));
  const ends = openEnds(nodes, wires), right = Math.max(...ends.map(({points}) => points[1][0] + 8));
  const picture = {width: Math.max(laid.width, right), height: laid.height, blocks, wires: [...laid.wires, ...ends]};
  for (const block of [...blocks]) if (block.inner) embed(block, picture);
  return picture;
}
