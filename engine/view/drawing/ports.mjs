// Where ports lie on the outline of their node.

import {spread} from "./symbol.mjs";

const inputSide = (node) => (node.flipped ? "EAST" : "WEST");
const outputSide = (node) => (node.flipped ? "WEST" : "EAST");

function placeOnCircle(node) {
  const middle = node.width / 2;
  const places = {WEST: [0, middle], EAST: [node.width, middle], NORTH: [middle, 0], SOUTH: [middle, node.width]};
  for (const port of node.inputs) {
    port.side ??= inputSide(node);
    [port.x, port.y] = places[port.side];
  }
}

/** What decides whether a block runs enters from above. */
function placeConditions(node) {
  const conditions = node.inputs.filter((port) => port.condition);
  const at = spread(conditions.length, node.width), y = node.outline === "triangle" ? Math.round(node.height / 4) : 0;
  conditions.forEach((port, i) => Object.assign(port, {side: "NORTH", x: at[i], y}));
}

/** Gives each port of a node its side and place: inputs on one side in their order, outputs on the other. */
export function placePorts(node) {
  const along = (ports, side, inner) => {
    const at = inner ?? spread(ports.length, node.height);
    ports.forEach((port, i) => Object.assign(port, {side, x: side === "WEST" ? 0 : node.width, y: at[i]}));
  };
  if (node.outline === "circle") {
    placeOnCircle(node);
  } else {
    placeConditions(node);
    along(node.inputs.filter((port) => !port.condition), inputSide(node), node.inner?.inputs);
  }
  along(node.outputs, outputSide(node), node.inner?.outputs);
}

function enterSum(node, wires, reversed, heights) {
  const feeding = new Map(node.inputs.map((port) =>
    [port, wires.find((wire) => wire.to.node === node.id && wire.to.port === port.port)]));
  const height = (port) => heights.get(feeding.get(port));
  const back = node.inputs.filter((port) => reversed.has(feeding.get(port)));
  const forward = node.inputs.filter((port) => !back.includes(port));
  const straight = forward.length === 3 ? [...forward].sort((a, b) => height(a) - height(b))[1] : forward[0];
  const free = ["WEST", "SOUTH", "NORTH"];
  const take = (port, side) => {
    port.side = free.includes(side) ? side : free[0];
    free.splice(free.indexOf(port.side), 1);
  };
  if (straight) take(straight, "WEST");
  for (const port of back) take(port, "SOUTH");
  for (const port of forward)
    if (port !== straight) take(port, height(port) < height(straight) ? "NORTH" : "SOUTH");
}

/**
 * Sides at which signals enter a sum: what is led back comes from below, one signal from the left, others from where
 * they begin. `heights` has for each wire where it begins.
 */
export function enterSums(nodes, wires, reversed, heights) {
  for (const node of nodes) if (node.outline === "circle") enterSum(node, wires, reversed, heights);
}

/** On which side of a node its name stands: below, or where no wire enters a sum. */
export function nameSide(node) {
  if (node.outline !== "circle") return "BOTTOM";
  const used = new Set(node.inputs.map((port) => port.side));
  return !used.has("NORTH") ? "TOP" : !used.has("SOUTH") ? "BOTTOM" : "";
}
