// The picture of a graph: blocks and wires with places, in pixels.

import {layOutLoops} from "./best.mjs";
import {outputId} from "./layout.mjs";
import {nodesAndWires} from "./nodes.mjs";
import {openLength, sizeOf, sizes} from "./symbol.mjs";
import {widthOf} from "./text.mjs";

const frame = {head: 22, margin: 12};

/** What is recorded and fed to nothing ends in an arrow; no wire turns that close to a block. */
function openEnds(nodes) {
  return nodes.flatMap((node) => node.outputs.filter((port) => port.isOpen).map((port) => {
    const x = node.x + port.x, y = node.y + port.y, end = port.side === "EAST" ? x + openLength : x - openLength;
    return {from: {node: node.id, port: port.port}, points: [[x, y], [end, y]]};
  }));
}

/** The picture of what is in a part; parts that differ in their own name only are laid out once. */
async function pictureOf(node, elk, known) {
  const own = `"${node.id}.`, any = '"\u0001', general = (drawn) => JSON.stringify(drawn).replaceAll(own, any);
  const key = general(node.graph);
  if (!known.has(key)) known.set(key, general(await arrange(node.graph, elk, false, known)));
  return JSON.parse(known.get(key).replaceAll(any, own));
}

/** An opened part is a frame around its own picture, whose ports lie where its words for them are. */
async function openPart(node, elk, known) {
  const picture = await pictureOf(node, elk, known);
  const at = (kind) => picture.blocks.filter((block) => block.own === kind).map((block) => block.y + block.height / 2);
  const down = (ys) => ys.map((y) => y + frame.head);
  node.width = Math.max(picture.width, Math.ceil(widthOf(node.name, sizes.name)) + 2 * frame.margin);
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
export async function arrange(graph, elk, isRoot = true, known = new Map()) {
  const {nodes, wires} = nodesAndWires(graph, isRoot);
  for (const node of nodes) {
    if (node.graph) await openPart(node, elk, known);
    else Object.assign(node, sizeOf(node));
  }
  const laid = await layOutLoops(nodes, wires, elk);
  const blocks = nodes.map((node) => Object.assign(node, laid.places.get(node.id)));
  for (const node of nodes)
    for (const port of node.outputs) port.unitAt = laid.units.get(outputId({node: node.id, port: port.port}));
  const ends = openEnds(nodes), right = Math.max(...ends.map(({points}) => points[1][0] + 8));
  const picture = {width: Math.max(laid.width, right), height: laid.height, blocks, wires: [...laid.wires, ...ends]};
  for (const block of [...blocks]) if (block.inner) embed(block, picture);
  return picture;
}
