// Draws two versions of a graph as one: what is new, gone and changed has a colour, a sign and a stroke of its own.

import {arrange} from "./picture.mjs";
import {group, ink, n, page, path, text} from "./pen.mjs";
import {piecesOf} from "./svg.mjs";
import {lies, segmentsOf} from "./wires.mjs";

/** Colours that differ for every kind of colour vision (M. Okabe, K. Ito, Color Universal Design, 2008). */
export const looks = {
  added: {color: "#0072b2", sign: "+", word: "new", stroke: `stroke-width="2.4"`},
  removed: {color: "#d55e00", sign: "−", word: "gone", stroke: `stroke-dasharray="5 3"`},
  changed: {color: "#8e4585", sign: "~", word: "changed", stroke: `stroke-width="1.8"`},
};

const sizeOfLine = 12, stepOfLine = 17, mostLines = 40, longestLine = 105, leastWidth = 620;
const indent = "\u00a0".repeat(4);  // blanks at the beginning of a text of SVG are left out

/** Name of an end of a wire under the new names of blocks. */
const renamedEnd = (end, names) => (end.node ? {...end, node: names[end.node] ?? end.node} : end);

const endText = (end) => (end.constant === undefined ? `${end.node}.${end.port}` : `=${end.constant}`);
const keyOf = ({from, to}) => `${endText(from)} ${endText(to)}`;

/** Ports of the new version, then those that only the old one has. */
const unitedPorts = (now, before) => [...now, ...before.filter(({port}) => !now.some((one) => one.port === port))];

function unitedNode(node, old, {was, isChanged}) {
  const ports = {inputs: unitedPorts(node.inputs, old.inputs), outputs: unitedPorts(node.outputs, old.outputs)};
  const name = was ? `${node.name} (was ${old.name})` : node.name;
  return {...node, ...ports, name, ...(was || isChanged || node.type !== old.type ? {change: "changed"} : {})};
}

/** Puts each gone node behind the neighbour that it had, so that it is drawn near it. */
function withGone(nodes, gone, order) {
  const all = [...nodes];
  for (const node of gone) {
    const at = order.indexOf(node.id), before = order.slice(0, at).reverse().find((id) => all.some((one) => one.id === id));
    all.splice(before === undefined ? 0 : all.findIndex(({id}) => id === before) + 1, 0, node);
  }
  return all;
}

/** Ends of the wires that begin at a number. */
const fedByNumber = (wires) => new Set(wires.filter(({from}) => from.constant !== undefined).map(({to}) => endText(to)));

/** A number with another value at the same input is one changed wire. */
function unitedWires(before, after) {
  const old = new Set(before.map(keyOf)), now = new Set(after.map(keyOf));
  const hadNumber = fedByNumber(before), hasNumber = fedByNumber(after);
  const isOtherNumber = ({from, to}, others) => from.constant !== undefined && others.has(endText(to));
  const gone = before.filter((wire) => !now.has(keyOf(wire)) && !isOtherNumber(wire, hasNumber));
  const changeOf = (wire) => (isOtherNumber(wire, hadNumber) ? "changed" : "added");
  return [
    ...after.map((wire) => (old.has(keyOf(wire)) ? wire : {...wire, change: changeOf(wire)})),
    ...gone.map((wire) => ({...wire, change: "removed"})),
  ];
}

/**
 * Gives a gone wire an input of its own beside the one that now has another wire, so that both lead to the block apart from
 * each other. A circle has no room for it.
 */
function apart(nodes, wires) {
  const fed = new Set(wires.filter(({change}) => change !== "removed").map(({to}) => endText(to)));
  return wires.map((wire) => {
    const node = nodes.find(({id}) => id === wire.to.node);
    if (wire.change !== "removed" || !node || node.outline === "circle" || !fed.has(endText(wire.to))) return wire;
    const at = node.inputs.findIndex(({port}) => port === wire.to.port), port = `${wire.to.port} before`;
    node.inputs.splice(at + 1, 0, {...node.inputs[at], port});
    return {...wire, to: {...wire.to, port}};
  });
}

/** One graph of both versions. `names` are new names of blocks by old ones, `changed` names of blocks with other values. */
export function united({before, after, names = {}, changed = []}) {
  const was = new Map(Object.entries(names).map(([from, to]) => [to, from]));
  const olds = new Map(before.nodes.map((node) => [names[node.id] ?? node.id, node]));
  const isChanged = (id) => changed.some((name) => name === id || name.startsWith(`${id}.`));
  const nodes = after.nodes.map((node) => {
    const old = olds.get(node.id);
    return old ? unitedNode(node, old, {was: was.get(node.id), isChanged: isChanged(node.id)}) : {...node, change: "added"};
  });
  const ids = new Set(after.nodes.map(({id}) => id)), order = [...olds.keys()];
  const gone = [...olds].filter(([id]) => !ids.has(id)).map(([id, node]) => ({...node, id, change: "removed"}));
  const wires = before.wires.map((wire) => ({...wire, from: renamedEnd(wire.from, names), to: renamedEnd(wire.to, names)}));
  const all = withGone(nodes, gone, order);
  return {
    ...after, inputs: unitedPorts(after.inputs, before.inputs), outputs: unitedPorts(after.outputs, before.outputs),
    nodes: all, wires: apart(all, unitedWires(wires, after.wires)),
  };
}

/** The same piece of the picture in the colour of its change. */
function inColor(svg, change) {
  if (!change) return svg;
  const {color, stroke} = looks[change];
  return svg.replaceAll(`"${ink}"`, `"${color}"`).replace(/stroke-width="1\.2"/g, stroke.includes("width") ? stroke : `stroke-width="1.6" ${stroke}`);
}

/** A disc with the sign of a change, at the upper right corner of a block; of a triangle at the corner of its base. */
function badge(block) {
  const look = looks[block.change];
  if (!look) return "";
  const isLeft = block.outline === "triangle" && !block.flipped, x = block.x + (isLeft ? 0 : block.width), y = block.y;
  return `<circle cx="${n(x)}" cy="${n(y)}" r="7.5" fill="${look.color}"/>` + text(x, y, look.sign, {size: 13, fill: "#fff", style: ` font-weight="bold"`});
}

const middleOf = ([[ax, ay], [bx, by]]) => [(ax + bx) / 2, (ay + by) / 2];
const lengthOf = ([[ax, ay], [bx, by]]) => Math.abs(ax - bx) + Math.abs(ay - by);

/** A sign on the longest piece of a wire that it does not share with others. */
function signOfWire({change, points}, others) {
  const look = looks[change];
  if (!look) return "";
  const all = segmentsOf(points), own = all.filter((piece) => !others.some((other) => lies(middleOf(piece), other)));
  const longest = (own.length ? own : all).reduce((best, one) => (lengthOf(one) > lengthOf(best) ? one : best));
  const [x, y] = middleOf(longest);
  return `<circle cx="${n(x)}" cy="${n(y)}" r="6" fill="#fff" stroke="${look.color}"/>` + text(x, y, look.sign, {size: 11, fill: look.color, style: ` font-weight="bold"`});
}

function legend(y) {
  return Object.values(looks).map(({color, sign, word, stroke}, i) => {
    const x = 20 + 130 * i;
    return path(`M${n(x)} ${n(y)}h34`, ` fill="none" stroke="${color}" ${stroke}`) +
      `<circle cx="${n(x + 46)}" cy="${n(y)}" r="7.5" fill="${color}"/>` + text(x + 46, y, sign, {size: 13, fill: "#fff", style: ` font-weight="bold"`}) +
      text(x + 60, y, word, {size: sizeOfLine, anchor: "start"});
  }).join("");
}

/** A line in pieces of a length that can be read, cut between words where there are some. */
function wrapped(line) {
  const pieces = [];
  let rest = line;
  for (let length = longestLine; rest.length > length; length = longestLine - indent.length) {
    const blank = rest.lastIndexOf(" ", length), end = blank > length / 2 ? blank : length;
    pieces.push(rest.slice(0, end));
    rest = rest.slice(end).trimStart();
  }
  return [...pieces, rest].map((piece, i) => (i === 0 ? piece : indent + piece));
}

const colorOfLine = (line) => Object.values(looks).find(({sign}) => line.startsWith(sign === "−" ? "-" : sign))?.color ?? ink;

/** The lines below the drawing with their looks: headings bold, changes in their colour, long ones in pieces. */
function listed(lines) {
  const all = lines.flatMap((line) => (line.heading
    ? [{line: line.heading, style: ` font-weight="bold"`}]
    : wrapped(line).map((piece) => ({line: piece, fill: colorOfLine(line)}))));
  return all.length > mostLines ? [...all.slice(0, mostLines), {line: `… and ${all.length - mostLines} more lines`}] : all;
}

const drawnLine = ({line, fill = ink, style = ""}, y) => text(20, y, line, {size: sizeOfLine, anchor: "start", fill, style});

/**
 * Order of the wires of one source. The first one has the trunk that they share, so it has the look of one that stays. Gone wires
 * are drawn before new ones, so that a gone wire is below the one in its place.
 */
const rank = ({change}) => (change ? (change === "removed" ? 2 : 1) : 0);

/** The picture of two versions as the text of an SVG file: the drawing, a legend, and the changes in words. */
export async function drawCompared(compared, elk) {
  const picture = await arrange(united(compared), elk);
  picture.wires.sort((a, b) => rank(a) - rank(b));
  const pieces = piecesOf(picture);
  const hides = (one, wire) => one !== wire && rank(one) < rank(wire);
  const othersOf = (wire) => picture.wires.filter((one) => hides(one, wire)).flatMap(({points}) => segmentsOf(points));
  const lines = listed(compared.lines ?? []), left = Math.max(0, (leastWidth - picture.width) / 2);
  const below = picture.height + 24, height = below + 30 + lines.length * stepOfLine;
  const size = {width: Math.max(picture.width + 16, leastWidth, ...lines.map(({line}) => 40 + 6.4 * line.length)), height};
  const drawn = group(`transform="translate(${n(left)} 10)"`, [
    ...pieces.frames.map(({block, svg}) => inColor(svg, block.change)),
    ...[0, 2, 1].flatMap((place) => pieces.wires.filter(({wire}) => rank(wire) === place)).map(({wire, svg}) => inColor(svg, wire.change)),
    pieces.forks,
    ...pieces.blocks.map(({block, svg}) => inColor(svg, block.change)),
    ...picture.wires.map((wire) => signOfWire(wire, othersOf(wire))),
    ...picture.blocks.map(badge),
  ]);
  return page(size, compared.after.title, [drawn, legend(below), ...lines.map((line, i) => drawnLine(line, below + 30 + i * stepOfLine))]);
}
