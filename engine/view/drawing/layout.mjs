// One layout of nodes and wires with the layered algorithm of elk, in pixels.

import {clearance, routeFeedback} from "./route_feedback.mjs";
import {alignPorts} from "./align_ports.mjs";
import {removeJogs} from "./remove_jogs.mjs";
import {markGap, openLength, portPitch, sizes} from "./symbol.mjs";
import {widthOf, widthOfPieces} from "./text.mjs";
import {straightened} from "./wires.mjs";

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
  "elk.layered.thoroughness": "20",
};
const nameHeight = 15;
/** Nodes without a name may stand closer, ports of the file as close as those of blocks: then their wires are straight. */
const close = {text: {"elk.spacing.nodeNode": 8}, oval: {"elk.spacing.nodeNode": portPitch - 20}};

/** Ports by their place, since an input and an output may have one name. */
export const inputId = (end) => `${end.node} < ${end.port}`;
export const outputId = (end) => `${end.node} > ${end.port}`;
export const portsOf = (node) => [
  ...node.inputs.map((port) => ({id: inputId({node: node.id, port: port.port}), ...port})),
  ...node.outputs.map((port) => ({id: outputId({node: node.id, port: port.port}), ...port})),
];

/** Stands for the arrow at a signal that is recorded and fed to nothing: elk heeds no label without text. */
const arrow = "→", noted = "x";

/** What stands beside a port: what its signal is called and its unit, or the arrow of a signal that is fed to nothing. */
function besidePort({mark, unit, isOpen}) {
  const text = [mark ? widthOfPieces(mark, sizes.mark) : 0, unit ? widthOf(unit, sizes.unit) : 0].filter((width) => width > 0);
  const width = Math.max(text.reduce((sum, one) => sum + one + markGap, 0), isOpen ? openLength : 0);
  return width > 0 ? [{text: text.length > 0 ? noted : arrow, width, height: mark ? sizes.mark : sizes.unit}] : [];
}

function elkNode(node) {
  const ports = portsOf(node).map((port) => ({
    id: port.id, x: port.x, y: port.y, width: 0, height: 0, labels: besidePort(port),
    layoutOptions: {"elk.port.side": port.side},
  }));
  const layoutOptions = {"elk.portConstraints": "FIXED_POS", "elk.portLabels.placement": "OUTSIDE"}, labels = [];
  if (node.nameSide) {
    labels.push({text: node.name, width: widthOf(node.name, sizes.name), height: nameHeight});
    layoutOptions["elk.nodeLabels.placement"] = `[H_CENTER, V_${node.nameSide}, OUTSIDE]`;
  }
  return {id: node.id, width: node.width, height: node.height, ports, labels, layoutOptions, individualSpacings: close[node.outline]};
}

/** With these elk keeps nodes in the columns, and there in the order, in which their hints are. */
const steady = {
  "elk.layered.layering.strategy": "INTERACTIVE", "elk.layered.cycleBreaking.strategy": "INTERACTIVE",
  "elk.layered.crossingMinimization.semiInteractive": "true", "elk.layered.considerModelOrder.strategy": "NONE",
};

/** A node with its hint, of which only what was there before has a height. */
function hinted(node, {x, y} = {}) {
  if (x === undefined) return node;
  const layoutOptions = y === undefined ? node.layoutOptions : {...node.layoutOptions, "elk.position": `(${x},${y})`};
  return {...node, x, y: y ?? 0, layoutOptions};
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

function elkNodes(nodes, hints) {
  const words = (kind) => nodes.filter((node) => isWord(node) && node.own === kind);
  const edges = ["input", "output"].filter((kind) => words(kind).length > 0).map((kind) => edgeNode(kind, words(kind)));
  return [...nodes.filter((node) => !isWord(node)).map((node) => hinted(elkNode(node), hints?.get(node.id))), ...edges];
}

/** Ports lie at whole places on their nodes, so that what met before it was moved to whole pixels still meets. */
const whole = (value) => Math.floor(value + 0.5 + 1e-6);

/** How far from the port at which a signal begins its name and its unit stand. */
function notesOf(laid) {
  const hasNote = ({labels = []}) => labels.length > 0 && labels[0].text === noted;
  return new Map(laid.children.flatMap((child) => child.ports.filter(hasNote).map(({id, labels: [{x, y, width}]}) => [id, [x, y, width]])));
}

/** Where each node lies; words at their ports, left or right at the edge. */
function placesOf(nodes, laid) {
  const found = new Map(laid.children.map((child) => [child.id, child]));
  return new Map(nodes.map((node) => {
    if (!isWord(node)) return [node.id, {x: whole(found.get(node.id).x), y: whole(found.get(node.id).y)}];
    const edge = found.get(`:${node.own}s`), own = edge.ports.find((port) => port.id === portsOf(node)[0].id);
    const x = node.own === "input" ? edge.x : edge.x + edge.width - node.width;
    return [node.id, {x: whole(x), y: whole(edge.y + own.y) - node.height / 2}];
  }));
}

/** Lets wires begin and end at words, not at the edge of the widest of them. */
function reachWords(nodes, places, lines) {
  const words = new Map(nodes.filter(isWord).map((node) => [node.id, node]));
  for (const [wire, points] of lines) {
    const from = words.get(wire.from.node), to = words.get(wire.to.node);
    if (from) points[0][0] = places.get(from.id).x + from.width;
    if (to) points.at(-1)[0] = places.get(to.id).x;
  }
}

function linesOf(laid, wires, reversed) {
  const lines = new Map();
  for (const {id, sections: [{startPoint, bendPoints = [], endPoint}]} of laid.edges) {
    const points = [startPoint, ...bendPoints, endPoint].map(({x, y}) => [whole(x), whole(y)]);
    lines.set(wires[id], reversed.has(wires[id]) ? points.reverse() : points);
  }
  return lines;
}

/** True for a wire between blocks, neither at a port of the file nor at a constant. */
const isInner = ({from, to}) => ![from, to].some(({node}) => node.startsWith(":"));

/**
 * One layout: the place of each node and the corners of each wire, but for those that are led below afterwards. With `hints`
 * (steady.mjs) it keeps to an earlier one.
 */
export async function layOut({nodes, wires, reversed, hints}, elk, style, apart = new Set(), abreast = Math.min(1, apart.size)) {
  const {straightChain, ...placing} = style;
  const edges = wires.map((wire, i) => {
    const ends = [outputId(wire.from), inputId(wire.to)], [source, target] = reversed.has(wire) ? ends.reverse() : ends;
    const layoutOptions = straightChain && isInner(wire) ? {"elk.layered.priority.straightness": "10"} : {};
    return {id: String(i), sources: [source], targets: [target], layoutOptions};
  });
  const between = {"elk.layered.spacing.edgeNodeBetweenLayers": String(clearance(abreast))};
  const laid = await elk.layout({
    id: "picture", layoutOptions: {...options, ...placing, ...between, ...(hints ? steady : {})},
    children: elkNodes(nodes, hints), edges: edges.filter((_, i) => !apart.has(wires[i])),
  });
  const places = placesOf(nodes, laid), lines = linesOf(laid, wires, reversed);
  reachWords(nodes, places, lines);
  const bounds = routeFeedback(nodes, places, lines, [...apart], {width: Math.ceil(laid.width), height: Math.ceil(laid.height)});
  if (bounds.abreast > abreast) return layOut({nodes, wires, reversed, hints}, elk, style, apart, bounds.abreast);
  for (const [wire, points] of lines) lines.set(wire, straightened(points));
  alignPorts(nodes, wires, places, lines);
  removeJogs(nodes, wires, places, lines);
  return {...bounds, places, notes: notesOf(laid), wires: wires.map((wire) => ({...wire, points: lines.get(wire)}))};
}
