// How large a block is, and where on its outline its ports lie.

import {widthOf} from "./text.mjs";

export const sizes = {text: 13, name: 12, port: 10.5, sign: 13, unit: 9.5, mark: 14};
export const portPitch = 24;
/** Between the name of a signal and its unit, and around them. */
export const markGap = 3;
/** How long the arrow at a signal is that is recorded and fed to nothing. */
export const openLength = 15;
const lineHeight = 16;

/** A sign of mathematics alone is written larger. */
export const textSize = (lines) => (lines.length === 1 && /^[×÷Σ]$/u.test(lines[0]) ? 20 : sizes.text);

const widest = (texts, size) => Math.max(0, ...texts.map((text) => widthOf(text, size)));
const even = (value) => 2 * Math.ceil(value / 2);

/** Widths of the columns of port labels inside of a box. */
function labelWidths(node) {
  const column = (ports) => widest(ports.map((port) => port.label ?? ""), sizes.port);
  return {left: column(node.inputs.filter((port) => !port.condition)), right: column(node.outputs)};
}

function boxSize(node) {
  const {left, right} = labelWidths(node);
  const inner = node.curve ? 34 : widest(node.lines, sizes.text);
  const lines = node.fraction ? 2.4 : node.lines.length;
  const conditions = node.inputs.filter((port) => port.condition);
  const rows = Math.max(node.inputs.length - conditions.length, node.outputs.length);
  const above = conditions.length > 0 ? lineHeight : 0;
  const room = (label) => (label > 0 ? label + 6 : 0);
  const margins = room(left) + room(right), shift = (room(left) - room(right)) / 2;
  const height = Math.max(node.part ? 48 : 38, lines * lineHeight + 10, rows * portPitch) + 2 * above;
  return {width: even(Math.max(node.part ? 68 : 42, inner + margins + 16, conditions.length * (widest(conditions.map((port) => port.label ?? ""), sizes.port) + 8))), height: even(height), shift};
}

function triangleSize(node) {
  const text = widest(node.lines, sizes.text);
  const width = Math.max(44, 1.2 * text + 20);
  return {width: even(width), height: even(Math.min(56, Math.max(42, 0.7 * width)))};
}

const rules = {
  box: boxSize,
  triangle: triangleSize,
  circle: () => ({width: 28, height: 28}),
  bar: (node) => ({width: 6, height: Math.max(40, Math.max(node.inputs.length, node.outputs.length) * portPitch)}),
  oval: (node) => ({width: even(Math.max(34, widest(node.lines, sizes.name) + 20)), height: 20}),
  text: (node) => ({width: even(widest(node.lines, sizes.text) + 6), height: 14}),
};

/** Width and height of a node, its name aside. */
export function sizeOf(node) {
  return rules[node.outline](node);
}

/** Sums of many signals have no room on a circle. */
export function drawnOutline(node) {
  const many = node.outline === "circle" && node.inputs.length > 3;
  return many ? {...node, outline: "box", lines: ["Σ"]} : node;
}

/** Where the ports of one side lie along it, in the order of the list. */
export function spread(count, length) {
  return Array.from({length: count}, (_, i) => Math.round(((i + 0.5) * length) / count));
}
