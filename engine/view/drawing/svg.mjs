// Writes a picture as SVG.

import {arrowHead, dot, faint, group, ink, n, page, path, polyline, quantity, text} from "./pen.mjs";
import {markGap, sizes, textSize} from "./symbol.mjs";
import {widthOf, widthOfPieces} from "./text.mjs";
import {forks, netOf, segmentsOf} from "./wires.mjs";

/** A curve from the square -1..1 with y upwards into the place around a centre. */
function curvePath(data, cx, cy, half) {
  const command = /([MLHVCZ])([^MLHVCZ]*)/g;
  const axis = {H: [cx, half], V: [cy, -half]};
  return data.replace(command, (_, letter, numbers) => {
    const values = (numbers.match(/-?\d*\.?\d+/g) ?? []).map(Number);
    const place = (value, i) => {
      const [centre, scale] = axis[letter] ?? (i % 2 === 0 ? [cx, half] : [cy, -half]);
      return n(centre + scale * value);
    };
    return letter + values.map(place).join(" ");
  });
}

function curve(block, cx, cy) {
  const half = 13, reach = half + 2;
  const axes = `M${n(cx - reach)} ${n(cy)}H${n(cx + reach)}M${n(cx)} ${n(cy - reach)}V${n(cy + reach)}`;
  return (block.axes ? path(axes, ` stroke="${faint}" stroke-width="0.7"`) : "") +
    path(curvePath(block.curve, cx, cy, half), ` stroke-width="1.3"`);
}

const shapes = {
  box: ({x, y, width, height}) => `<rect x="${n(x)}" y="${n(y)}" width="${n(width)}" height="${n(height)}"/>`,
  triangle: ({x, y, width, height, flipped}) =>
    path(flipped ? `M${n(x + width)} ${n(y)}V${n(y + height)}L${n(x)} ${n(y + height / 2)}Z`
                 : `M${n(x)} ${n(y)}V${n(y + height)}L${n(x + width)} ${n(y + height / 2)}Z`),
  circle: ({x, y, width}) => `<circle cx="${n(x + width / 2)}" cy="${n(y + width / 2)}" r="${n(width / 2)}"/>`,
  bar: ({x, y, width, height}) =>
    `<rect x="${n(x)}" y="${n(y)}" width="${n(width)}" height="${n(height)}" fill="${ink}"/>`,
  oval: ({x, y, width, height}) =>
    `<rect x="${n(x)}" y="${n(y)}" width="${n(width)}" height="${n(height)}" rx="${n(height / 2)}"/>`,
  text: () => "",
};

/** Middle of what is written inside: a triangle's weight lies towards its base. */
function middle(block) {
  const forward = (block.outline === "triangle" ? -0.12 * block.width : 0) + (block.shift ?? 0);
  return [block.x + block.width / 2 + (block.flipped ? -forward : forward), block.y + block.height / 2];
}

const fractionStep = 9.5, lineStep = 16;

/** Half of the bar of a fraction: as wide as the block, or between the names of its ports. */
function halfBar({width, lines, inputs, outputs}) {
  const named = [...inputs, ...outputs].some(({label}) => label);
  return named ? Math.max(...lines.map((line) => widthOf(line, sizes.text))) / 2 + 5 : width / 2 - 6;
}

/** What is drawn inside: a curve, or the bar of a fraction. */
function inside(block) {
  const [cx, cy] = middle(block), half = halfBar(block);
  if (block.curve) return curve(block, cx, cy);
  return block.fraction ? path(`M${n(cx - half)} ${n(cy)}H${n(cx + half)}`, ` stroke-width="1"`) : "";
}

function lines(block) {
  const [cx, cy] = middle(block);
  if (block.curve) return "";
  const step = block.fraction ? 2 * fractionStep : lineStep;
  const first = cy - ((block.lines.length - 1) * step) / 2;
  return block.lines.map((line, i) => text(cx, first + step * i, line, {size: textSize(block.lines)})).join("");
}

/** Names of ports inside of a box, and signs inside of a circle. */
function portTexts(block, ports = [...block.inputs, ...block.outputs]) {
  if (block.outline === "bar") return "";
  const towards = {WEST: [1, 0], EAST: [-1, 0], NORTH: [0, 1], SOUTH: [0, -1]};
  return ports.map((port) => {
    const [dx, dy] = towards[port.side], x = block.x + port.x, y = block.y + port.y;
    if (port.sign) {
      const sign = port.sign === "-" ? "−" : port.sign;
      return text(x + 7 * dx, y + 7 * dy, sign, {size: sizes.sign});
    }
    if (!port.label) return "";
    if (port.side === "NORTH") return text(x, y + 8, port.label, {size: sizes.port, fill: "#444"});
    return text(x + 5 * dx, y, port.label, {size: sizes.port, anchor: dx > 0 ? "start" : "end", fill: "#444"});
  }).join("");
}

/** The name of a signal and its unit side by side, from the end that is nearer to the block: fonts differ in width. */
function notes(block) {
  return block.outputs.filter((port) => port.noteAt).map((port) => {
    const [dx, dy, width] = port.noteAt, left = block.x + port.x + dx, middle = block.y + port.y + dy + (port.mark ? sizes.mark : sizes.unit) / 2;
    const anchor = port.side === "WEST" ? "end" : "start", both = port.mark && port.unit;
    const [x, away] = anchor === "end" ? [left + width - markGap / 2, -1] : [left + markGap / 2, 1];
    const beyond = (written, size) => (both ? away * (widthOfPieces(written, size) + markGap) : 0);
    const markX = x + (anchor === "end" ? beyond(port.unit, sizes.unit) : 0), unitX = x + (anchor === "start" ? beyond(port.mark, sizes.mark) : 0);
    return (port.mark ? quantity(markX, middle, port.mark, {size: sizes.mark, anchor}) : "") +
      (port.unit ? text(unitX, middle, port.unit, {size: sizes.unit, anchor, fill: "#666"}) : "");
  }).join("");
}

function name(block) {
  if (!block.nameSide) return "";
  const y = block.nameSide === "TOP" ? block.y - 9 : block.y + block.height + 11;
  return text(block.x + block.width / 2, y, block.name, {size: sizes.name, fill: "#333"});
}

function frameRect({x, y, width, height}) {
  return `<rect x="${n(x)}" y="${n(y)}" width="${n(width)}" height="${n(height)}" rx="4"/>`;
}

function frameName(block) {
  return text(block.x + 10, block.y + 13, block.name, {size: sizes.name, anchor: "start", fill: "#333"});
}

/** What is written on a frame: its name, what its signals are called, and the port that says whether it is active. */
const frameTexts = (block) => frameName(block) + notes(block) + portTexts(block, block.outputs.filter(({guard}) => guard));

/** The parts of a straight line that others on it leave free, in its direction. */
function freeParts([start, end], drawn) {
  const axis = start[1] === end[1] ? 0 : 1, sign = Math.sign(end[axis] - start[axis]), other = 1 - axis;
  const at = (point) => sign * point[axis], place = (value) => (axis ? [start[0], sign * value] : [sign * value, start[1]]);
  const taken = drawn.filter((one) => one.every((point) => point[other] === start[other]))
    .map((one) => one.map(at).sort((a, b) => a - b)).sort(([a], [b]) => a - b);
  const parts = [];
  let from = at(start);
  for (const [low, high] of [...taken, [at(end), at(end)]]) {
    if (low > from) parts.push([from, Math.min(low, at(end))].map(place));
    from = Math.max(from, high);
    if (from >= at(end)) break;
  }
  return parts;
}

/**
 * What of a wire is not drawn yet by others of its net, as lines: no line is drawn twice, which would look bold. The last one
 * ends at the tip.
 */
function remainder(points, drawn) {
  const lines = [];
  for (const [start, end] of segmentsOf(points).flatMap((segment) => freeParts(segment, drawn))) {
    const last = lines.at(-1);
    if (last && last.at(-1)[0] === start[0] && last.at(-1)[1] === start[1]) last.push(end);
    else lines.push([start, end]);
  }
  const tip = points.at(-1), end = lines.at(-1)?.at(-1);
  return end && end[0] === tip[0] && end[1] === tip[1] ? lines : [...lines, points.slice(-2)];
}

function drawNets(wires) {
  const nets = new Map();
  return wires.map((wire) => {
    const drawn = nets.get(netOf(wire)) ?? [], lines = remainder(wire.points, drawn);
    nets.set(netOf(wire), [...drawn, ...lines.flatMap(segmentsOf)]);
    const net = lines.slice(0, -1).map((points) => polyline(points)).join("") + drawWire(lines.at(-1));
    return wire.bus ? group(`stroke-width="2.8"`, [net]) : net;
  });
}

/** A wire up to the base of its arrow, and the arrow. */
function drawWire(corners) {
  const points = corners.map((point) => [...point]);
  const tip = points.at(-1), before = points.at(-2);
  const [dx, dy] = [Math.sign(tip[0] - before[0]), Math.sign(tip[1] - before[1])];
  const {base, head} = arrowHead(tip, [dx, dy]);
  points[points.length - 1] = base;
  return polyline(points) + head;
}

/** Which element of a signal or field of a bus a wire brings, before its arrow. */
function elementOf({element, points}) {
  if (!element) return "";
  const [tip, before] = [points.at(-1), points.at(-2)], dx = Math.sign(tip[0] - before[0]);
  const [x, y] = dx ? [tip[0] - 9 * dx, tip[1] - 6] : [tip[0] + 4, tip[1] - 9 * Math.sign(tip[1] - before[1])];
  return text(x, y, element, {size: sizes.unit, anchor: dx > 0 ? "end" : "start", fill: "#666"});
}

const line = `stroke="${ink}" stroke-width="1.2" stroke-linejoin="round"`;
const isFrame = ({inner}) => inner !== undefined;
const textsOf = (block) => lines(block) + portTexts(block) + notes(block) + name(block);

/**
 * The same picture in pieces for who moves or marks them one by one: {frames, wires, forks, blocks}, where a frame or block is
 * {block, svg}, a wire {wire, svg} and forks the text of their dots.
 */
export function piecesOf(picture) {
  const frame = (block) => group(`fill="#fafafa" stroke="${faint}"`, [frameRect(block)]) + group(`fill="${ink}"`, [frameTexts(block)]);
  const whole = (block) => group(`fill="#fff" ${line}`, [shapes[block.outline](block)]) + group(`fill="none" ${line}`, [inside(block)]) +
    group(`fill="${ink}"`, [textsOf(block)]);
  const nets = drawNets(picture.wires);
  return {
    frames: picture.blocks.filter(isFrame).map((block) => ({block, svg: frame(block)})),
    wires: picture.wires.map((wire, i) => ({wire, svg: group(`fill="none" ${line}`, [nets[i]]) + elementOf(wire)})),
    forks: group(`fill="none" ${line}`, forks(picture.wires).map(dot)),
    blocks: picture.blocks.filter((block) => !isFrame(block)).map((block) => ({block, svg: whole(block)})),
  };
}

/** The picture as the text of an SVG file. */
export function svgOf(picture, title = "") {
  const frames = picture.blocks.filter(isFrame);
  const blocks = picture.blocks.filter((block) => !isFrame(block));
  return page(picture, title, [
    group(`fill="#fafafa" stroke="${faint}"`, frames.map(frameRect)),
    group(`fill="none" ${line}`, [...drawNets(picture.wires), ...forks(picture.wires).map(dot)]),
    group(`fill="#fff" ${line}`, blocks.map((block) => shapes[block.outline](block))),
    group(`fill="none" ${line}`, blocks.map(inside)),
    group(`fill="${ink}"`, [
      ...picture.wires.map(elementOf),
      ...frames.map(frameTexts),
      ...blocks.map(textsOf),
    ]),
  ]);
}
