// A picture with other words in it: where no block, port or wire is another, everything stays where it is.

import {nodesAndWires} from "./nodes.mjs";
import {markGap, sizeOf, sizes} from "./symbol.mjs";
import {widthOf, widthOfPieces} from "./text.mjs";

/** A block may become so much wider on each side before it comes too close to the wires beside it. */
const slack = 8;
const isWord = ({outline}) => outline === "text";

/** All nodes of a graph and of the opened parts in it, each with the names of the parts around it. */
function allOf(graph, isRoot, within = []) {
  const {nodes, wires} = nodesAndWires(graph, isRoot);
  const inside = nodes.filter((node) => node.graph).map((node) => allOf(node.graph, false, [...within, node.id]));
  return {nodes: [...nodes.map((node) => ({node, within})), ...inside.flatMap((one) => one.nodes)],
    wires: [...wires.map((wire) => ({wire, within})), ...inside.flatMap((one) => one.wires)]};
}

const keyOf = ({id}, within = []) => JSON.stringify([within, id]);
const portKey = ({port, sign, isOpen}) => [port, sign, Boolean(isOpen)];

/** What of a graph decides where everything lies: its blocks, ports and wires without their words, and blocks without their names. */
function structureOf({nodes, wires}) {
  const numbers = new Map(nodes.map(({node, within}, i) => [keyOf(node, within), i])), at = ({node, port}, within) => [numbers.get(keyOf({id: node}, within)), port];
  return JSON.stringify([
    nodes.map(({node, within}) => [within.length, node.own, node.outline, Boolean(node.name), Boolean(node.part), Boolean(node.graph), Boolean(node.state), node.inputs.map(portKey), node.outputs.map(portKey)]),
    wires.map(({wire: {from, to}, within}) => [at(from, within), at(to, within)]),
  ]);
}

/** True if there is room for the words beside a port. */
function hasRoom(old, {mark, unit}) {
  const width = (mark ? widthOfPieces(mark, sizes.mark) + markGap : 0) + (unit ? widthOf(unit, sizes.unit) + markGap : 0);
  return width === 0 || (old.noteAt !== undefined && width <= old.noteAt[2] + slack);
}

/** Ports with other words at the places of the old ones, which move with the right edge; undefined where the words have no room. */
function portsWith(olds, ports, wider, width) {
  const all = ports.map((port, i) => {
    const old = olds[i];
    return hasRoom(old, port) ? {...old, label: port.label, mark: port.mark, unit: port.unit, recorded: port.recorded, x: old.x === width ? old.x + wider : old.x > 0 ? old.x + wider / 2 : 0} : undefined;
  });
  return all.includes(undefined) ? undefined : all;
}

/** The block of a picture with other words; undefined where they have no room in it. */
function blockWith(old, node, within) {
  const now = {...old, id: node.id, name: node.name, type: node.type, ...(within.length > 0 ? {within} : {})};
  if (widthOf(node.name ?? "", sizes.name) > Math.max(widthOf(old.name ?? "", sizes.name), old.width) + 2 * slack) return undefined;
  if (old.inner) return now;
  const size = sizeOf(node), wider = isWord(old) ? 0 : Math.max(0, size.width - old.width);
  if (size.width > old.width + (isWord(old) || old.flipped ? 0 : 2 * slack) || size.height > old.height) return undefined;
  const inputs = portsWith(old.inputs, node.inputs, wider, old.width), outputs = portsWith(old.outputs, node.outputs, wider, old.width);
  if (!inputs || !outputs) return undefined;
  const {lines, fraction, curve, axes} = node;
  return {...now, lines, fraction, curve, axes, shift: size.shift, x: old.x - wider / 2, width: old.width + wider, inputs, outputs};
}

/** Lets wires begin and end at the sides of blocks that became wider, and have their names. */
function wireWith(wire, blocks, insides) {
  const points = wire.points.map((point) => [...point]);
  const end = (which, point) => {
    if (!wire[which]) return wire[which];
    const {before, now} = blocks.get(keyOf({id: wire[which].node}, wire.within)) ?? {};
    if (!now) return wire[which];  // at the edge of a frame
    if (point[0] === before.x) point[0] = now.x;
    else if (point[0] === before.x + before.width) point[0] = now.x + now.width;
    return {...wire[which], node: now.id};
  };
  const within = wire.within && {within: insides.get(JSON.stringify(wire.within)) ?? wire.within};
  return {...wire, ...within, from: end("from", points[0]), to: end("to", points[points.length - 1]), points};
}

/** What the next layout needs, with the names of now. */
function renamed(like, blocks) {
  const nameOf = (id) => blocks.get(keyOf({id}))?.now.id ?? id, keys = (all) => Object.fromEntries(Object.entries(all).map(([id, value]) => [nameOf(id), value]));
  return like && {...like, columns: keys(like.columns), heights: keys(like.heights), flipped: like.flipped.map(nameOf), parts: keys(like.parts)};
}

/**
 * The picture of a graph with the words and names of another one of the same structure; undefined where that has another one,
 * or its words have no room.
 */
export function relabeled({graph: old, picture}, graph) {
  const before = allOf(old, true), now = allOf(graph, true);
  if (structureOf(before) !== structureOf(now)) return undefined;
  const known = new Map(picture.blocks.map((block) => [keyOf(block, block.within), block])), blocks = new Map(), insides = new Map();
  for (const [i, {node, within}] of before.nodes.entries()) {
    const block = known.get(keyOf(node, within)), other = now.nodes[i];
    insides.set(JSON.stringify(within), other.within);
    if (!block) continue;  // a port at the edge of a group
    const changed = blockWith(block, other.node, other.within);
    if (!changed) return undefined;
    blocks.set(keyOf(node, within), {before: block, now: changed});
  }
  if (blocks.size !== known.size) return undefined;  // as in rows, where a wire is cut
  return {
    ...picture, like: renamed(picture.like, blocks), blocks: picture.blocks.map((block) => blocks.get(keyOf(block, block.within)).now),
    wires: picture.wires.map((wire) => wireWith(wire, blocks, insides)),
  };
}
