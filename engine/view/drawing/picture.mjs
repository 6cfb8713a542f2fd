// The picture of a graph: blocks and wires with places, in pixels.

import {searchLayout, sizeOfLayout} from "./search_layout.mjs";
import {grouped} from "./groups.mjs";
import {outputId} from "./layout.mjs";
import {mirrored} from "./mirror.mjs";
import {nodesAndWires} from "./nodes.mjs";
import {rowNumbers, rowsOf, stacked, turnsAtEnds} from "./rows.mjs";
import {keptOf} from "./steady.mjs";
import {openLength, sizeOf, sizes} from "./symbol.mjs";
import {widthOf} from "./text.mjs";
import {straightened} from "./wires.mjs";

const frame = {head: 22, margin: 12, foot: 18};
/** On a page of 1400 pixels names of ports are 9 high in a picture of this width. */
const widest = (1400 * sizes.port) / 9;
/** What is so many times as wide does not become readable in narrower frames. */
const hopeless = 3;
/** Two rows are drawn where they are that much less wide than one. */
const worthwhile = 0.85;
/** Beyond so many rows nothing is gained. */
const mostRows = 20;
const band = {width: 1000, ratio: 3.5};
const unbounded = {whole: Infinity, frame: Infinity};

/** What is recorded and fed to nothing ends in an arrow; no wire turns that close to a block. */
function openEnds(nodes) {
  return nodes.flatMap((node) => node.outputs.filter((port) => port.isOpen).map((port) => {
    const x = node.x + port.x, y = node.y + port.y, end = port.side === "EAST" ? x + openLength : x - openLength;
    return {from: {node: node.id, port: port.port}, points: [[x, y], [end, y]]};
  }));
}

/** The picture of what is in a part; parts that differ in their own name only are laid out once. */
async function pictureOf(node, elk, known, room) {
  const own = `"${node.id}.`, any = '"\u0001', general = (drawn) => JSON.stringify(drawn).replaceAll(own, any);
  const text = general(node.graph), keyOf = (frame) => `${room.like ? "like " : ""}${frame} ${text}`, drawn = (key) => JSON.parse(known.get(key).replaceAll(any, own));
  if (known.has(keyOf(Infinity))) {
    const picture = drawn(keyOf(Infinity));
    if (picture.width <= room.frame) return picture;  // and so is every frame in it
  }
  const key = keyOf(room.frame);
  if (!known.has(key)) known.set(key, general(await arrangeIn(node.graph, elk, false, known, room.like ? {...room, like: room.like.parts?.[node.id] ?? {}} : room)));
  return drawn(key);
}

/**
 * An opened part is a frame around its own picture, whose ports lie where its words for them are. Whether it is active is no
 * word of the picture, and leaves the frame below it.
 */
async function openPart(node, elk, known, room) {
  const picture = await pictureOf(node, elk, known, room);
  const at = (kind) => picture.blocks.filter((block) => block.own === kind && !block.within).map((block) => block.y + block.height / 2);
  const down = (ys) => ys.map((y) => y + frame.head);
  node.width = Math.max(picture.width, Math.ceil(widthOf(node.name, sizes.name)) + 2 * frame.margin);
  node.height = picture.height + frame.head;
  const outputs = down(at("output"));
  if (node.outputs.some(({guard}) => guard)) {
    outputs.push(node.height + frame.foot / 2);
    node.height += frame.foot;
  }
  node.inner = {picture, inputs: down(at("input")), outputs};
}

/** Wires of a group go on to its edge. */
function reachEdge(wires, width) {
  const edge = (x) => (x < width / 2 ? 0 : width);
  for (const {from, to, points} of wires) {
    if (from.node.startsWith(":input:")) points[0][0] = edge(points[0][0]);
    if (to?.node.startsWith(":output:")) points.at(-1)[0] = edge(points.at(-1)[0]);
  }
}

/** The picture in a frame as it lies there. */
function innerPicture({inner, flipped, isGroup, width}) {
  const picture = flipped ? mirrored({...inner.picture, width}) : inner.picture;
  if (isGroup) reachEdge(picture.wires.filter((wire) => !wire.within), width);
  return picture;
}

/** Two pieces of a wire that meet at the edge of a frame as one. */
const joined = (first, second) => ({
  from: first.from, to: second.to, within: [...(first.within ?? []), ...(second.within ?? [])],
  points: straightened([...first.points, ...second.points]),
});

/** Wires that cross the edge of a group: each piece within goes on outside. */
function joinAtEdge(group, outer, inner) {
  const ends = (end, kind, wire) => wire[end] && wire[end].node === `:${kind}:${wire[end].port}` && wire.within.length === 1;
  const entering = (wire) => ends("from", "input", wire), leaving = (wire) => ends("to", "output", wire);
  const at = (port) => (end) => end?.node === group.id && end.port === port;
  return [
    ...outer.filter(({from, to}) => from.node !== group.id && to?.node !== group.id),
    ...inner.filter((wire) => !entering(wire) && !leaving(wire)),
    ...inner.filter(entering).map((wire) => joined(outer.find(({to}) => at(wire.from.port)(to)), wire)),
    ...inner.filter(leaving).flatMap((wire) => outer.filter(({from}) => at(wire.to.port)(from)).map((one) => joined(wire, one))),
  ];
}

/** Moves what lies in a frame to where the frame is. */
function embed(block, picture) {
  const inner = innerPicture(block), dx = block.x, dy = block.y + frame.head;
  const move = ([x, y]) => [x + dx, y + dy], within = (one) => [block.id, ...(one.within ?? [])];
  const blocks = inner.blocks.filter((one) => !(block.isGroup && one.own && !one.within));
  const wires = inner.wires.map((wire) => ({...wire, within: within(wire), points: wire.points.map(move)}));
  picture.blocks.push(...blocks.map((one) => ({...one, within: within(one), x: one.x + dx, y: one.y + dy})));
  picture.wires = block.isGroup ? joinAtEdge(block, picture.wires, wires) : [...picture.wires, ...wires];
}

/** How wide a row of these nodes is at most, with generous room between them. */
const widthAtMost = (nodes) => nodes.reduce((sum, {width}) => sum + width + 100, 0);

/** The nodes of a graph with their sizes; opened parts have their picture. */
async function sizedNodes(graph, isRoot, elk, known, room) {
  const {nodes, wires} = nodesAndWires(graph, isRoot);
  for (const node of nodes) {
    if (node.graph) await openPart(node, elk, known, room);
    else Object.assign(node, sizeOf(node));
  }
  return {nodes, wires};
}

/** The picture of what has its sizes, in one row. */
async function inOneRow({nodes, wires}, elk, like) {
  const laid = await searchLayout(nodes, wires, elk, like);
  const blocks = nodes.map((node) => Object.assign(node, laid.places.get(node.id)));
  for (const node of nodes)
    for (const port of node.outputs) port.noteAt = laid.notes.get(outputId({node: node.id, port: port.port}));
  const ends = openEnds(nodes), right = Math.max(...ends.map(({points}) => points[1][0] + 8));
  const parts = Object.fromEntries(nodes.filter(({inner}) => inner).map(({id, inner}) => [id, inner.picture.like]));
  const picture = {
    width: Math.max(laid.width, right), height: laid.height, blocks, wires: [...laid.wires, ...ends],
    like: {...keptOf(nodes, laid), parts}, cost: laid.cost.total,
  };
  for (const block of [...blocks]) if (block.inner) embed(block, picture);
  return picture;
}

/** The picture of a graph in rows; nothing where it cannot be divided. */
async function inRows(count, graph, {nodes, wires}, elk, isRoot, known, room) {
  const numbers = rowNumbers(nodes, wires, count), rows = [];
  if (!numbers || !turnsAtEnds(graph, numbers)) return undefined;
  for (const row of rowsOf(graph, numbers)) rows.push(await inOneRow(await sizedNodes(row, isRoot, elk, known, room), elk));
  return stacked(rows);
}

/** The picture of a chain of blocks in as few rows as are `wanted` wide, where the wires lead from the end of each row to the next. */
async function inMoreRows(width, wanted, ...graph) {
  const least = Math.max(3, Math.ceil(width / wanted));
  let best;
  for (let count = least; count <= Math.min(least + 3, mostRows); ++count) {
    const picture = await inRows(count, ...graph);
    if (picture && !(best?.width <= picture.width)) best = picture;
    if (best?.width <= wanted) break;
  }
  return best;
}

/** True if a picture is wider than it may be, or a band that leaves most of a page empty. */
const isTooWide = ({width, height}, room) => width > room || (width > band.width && width > band.ratio * height);

/**
 * The picture of a graph: {width, height, blocks, wires}. A block is a node with x, y, width, height and ports that
 * have a side and a place on it; a wire has the corners that it goes through. What lies in frames names them in `within`.
 * Frames that become wider than `room.frame` are drawn in rows, and so is the whole beyond `room.whole`.
 */
async function arrangeIn(graph, elk, isRoot, known, room) {
  if (room.like) return inOneRow(await sizedNodes(graph, isRoot, elk, known, room), elk, room.like);
  const whole = grouped(graph), sized = () => sizedNodes(whole, isRoot, elk, known, room);
  const limit = room.whole === Infinity ? Infinity : isRoot ? Math.min(room.whole, band.width) : room.frame, task = await sized();
  if (widthAtMost(task.nodes) > limit) {
    const size = await sizeOfLayout(task.nodes, task.wires, elk);
    if (isRoot ? isTooWide(size, room.whole) : size.width > room.frame) {
      const two = await inRows(2, whole, task, elk, isRoot, known, room);
      const wanted = isRoot ? room.whole : room.frame, isPlain = task.nodes.every((node) => !node.graph);
      const more = two && two.width > wanted && isPlain ? await inMoreRows(size.width, wanted, whole, task, elk, isRoot, known, room) : undefined;
      if (more && more.width < worthwhile * two.width) return more;
      if (two && two.width < worthwhile * size.width) return two;
    }
  }
  return inOneRow(await sized(), elk);
}

/** The same, narrow enough to be read on a page if that can be had; `known` keeps pictures of parts for further calls. */
export async function arrange(graph, elk, known = new Map()) {
  let best, last;
  for (const frame of [Infinity, 1000, 600]) {
    const hasWider = last?.blocks.some(({inner, width}) => inner && width > frame) ?? true;
    if (!hasWider) continue;
    last = await arrangeIn(graph, elk, true, known, {whole: widest, frame});
    if (!best || last.width < best.width) best = last;
    if (best.width <= widest || best.width > hopeless * widest) break;
  }
  return best;
}

/** The best picture in one row, for who can move it about and look closer. */
export const arrangeRow = (graph, elk, known = new Map()) => arrangeIn(graph, elk, true, known, unbounded);

/**
 * A picture without a search, soon enough for who edits: close to an earlier picture of nearly the same graph, of which only
 * its `like` is needed, or of none ({}).
 */
export const arrangeLike = (like, graph, elk, known = new Map()) => arrangeIn(graph, elk, true, known, {...unbounded, like});
