// A picture as in a mirror that stands to its side: for frames that are drawn from right to left.

const otherSide = {WEST: "EAST", EAST: "WEST", NORTH: "NORTH", SOUTH: "SOUTH"};

function mirroredPort(port, width) {
  const noteAt = port.noteAt && [-port.noteAt[0] - port.noteAt[2], port.noteAt[1], port.noteAt[2]];
  return {...port, side: otherSide[port.side], x: width - port.x, noteAt};
}

function mirroredBlock(block, width) {
  const ports = (list) => list.map((port) => mirroredPort(port, block.width));
  return {
    ...block, x: width - block.x - block.width, flipped: !block.flipped,
    inputs: ports(block.inputs), outputs: ports(block.outputs),
  };
}

/** The same picture with left and right exchanged; texts stay readable. */
export function mirrored({width, height, blocks, wires}) {
  const line = (points) => points.map(([x, y]) => [width - x, y]);
  return {
    width, height, blocks: blocks.map((block) => mirroredBlock(block, width)),
    wires: wires.map((wire) => ({...wire, points: line(wire.points)})),
  };
}
