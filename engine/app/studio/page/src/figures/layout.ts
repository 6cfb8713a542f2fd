// Positions of axes, labels and legend of a panel. Distances equal those of gnuplot's pictures, with letters of 13 px. The page and
// figure.svg thus have the same frames.

import type {Scale} from "./axis";
import type {Box, Plot} from "./spec";

export const letter = {width: 9.1, height: 13};

export interface Frame {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export const gaps = {
  tick: 5.85,
  tickLabel: 14.95, // from the frame to labels beside it
  tickBase: 29.6, // from the frame to the base line of labels below it
  xLabel: 58.8,
  yLabel: 27.3, // and one letter for each of the widest tick
  title: 26.2,
  barLabel: 34.6,
  base: 4.23, // from the middle of letters to their base line
};

const widest = (scale: Scale) => Math.max(0, ...scale.ticks.map(({label}) => [...label].length));

/** Returns the depth of rotated tick labels below the frame. */
export function depthOfTicks({axis, ticks}: Scale): number {
  if (ticks.length === 0) return 0;
  const angle = (Math.abs(axis.label_angle ?? 0) * Math.PI) / 180;
  return letter.height + Math.sin(angle) * Math.max(0, ...ticks.map(({label}) => 0.8 * letter.width * [...label].length));
}

/** Returns the number of rows of the title. */
export const titleRows = (title: string) => (title === "" ? 0 : 1);

export const rowHeight = 20.7;

export interface Margins {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

interface Room {
  aligned: boolean;
  anyColor: boolean; // in the figure
  legendRows: number; // above
  legendLetters: number; // beside
}

function rightMargin(plot: Plot, width: number, left: number, room: Room): number {
  if (room.aligned) return (room.anyColor ? 15 : 3) * letter.width;
  const edge = 3 * letter.width;
  if (plot.legend === "beside" && room.legendLetters > 0) return edge + 46 + 8.4 * room.legendLetters;
  return plot.color ? edge + 28.2 + 0.1 * (width - left - edge) : edge;
}

export function marginsOf(plot: Plot, width: number, x: Scale, y: Scale, room: Room): Margins {
  const yTicks = y.ticks.length === 0 ? 0 : gaps.tickLabel + letter.width * widest(y);
  const yLabel = y.label === "" ? 0 : 33.15;
  const left = room.aligned ? 10 * letter.width : Math.max(yTicks + (yLabel || 8), 2 * letter.width);
  const below = (x.ticks.length === 0 ? 0 : 25.6 + depthOfTicks(x) - letter.height) + (x.label === "" ? 0 : 29.25);
  const bottom = Math.max(13 + below + (x.label === "" ? 13 : 0.2), 13);
  return {left, right: rightMargin(plot, width, left, room), top: 19.5 + 40.5 * titleRows(plot.title ?? "") + rowHeight * room.legendRows, bottom};
}

/** Returns a centred frame with equal scales along both axes. */
function equalFrame(free: Frame, x: Scale, y: Scale): Frame {
  const across = Math.abs(x.high - x.low), up = Math.abs(y.high - y.low), [width, height] = [free.right - free.left, free.bottom - free.top];
  const pixels = Math.min(width / across, height / up);
  if (!(pixels > 0) || !Number.isFinite(pixels)) return free;
  const [dx, dy] = [0.5 * (width - pixels * across), 0.5 * (height - pixels * up)];
  return {left: free.left + dx, right: free.right - dx, top: free.top + dy, bottom: free.bottom - dy};
}

export function frameOf(plot: Plot, box: Box, x: Scale, y: Scale, room: Room): Frame {
  if (plot.frame) return {left: plot.frame[0], top: plot.frame[1], right: plot.frame[0] + plot.frame[2], bottom: plot.frame[1] + plot.frame[3]};
  const [left, top, width, height] = box, margins = marginsOf(plot, width, x, y, room);
  const free = {left: left + margins.left, top: top + margins.top, right: left + width - margins.right, bottom: top + height - margins.bottom};
  if (free.right < free.left + 10) free.right = free.left + 10;
  if (free.bottom < free.top + 10) free.bottom = free.top + 10;
  return plot.equal ? equalFrame(free, x, y) : free;
}

/** Returns the distance of the y axis label from the frame. */
export const yLabelGap = (y: Scale) => gaps.yLabel + letter.width * widest(y);
export const barLabelGap = (color: Scale) => gaps.barLabel + letter.width * widest(color);
