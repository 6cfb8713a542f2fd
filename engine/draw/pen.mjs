// What pictures are written with: the pieces of an SVG file.

import {escaped} from "./text.mjs";

export const ink = "#1a1a1a", faint = "#9a9a9a";
const arrow = {length: 8, half: 3.3};

/** A number as short as it may be; none has more than two decimals. */
export const n = (value) => String(Math.round(value * 100) / 100 + 0);

/** A text whose middle line is at y. */
export function text(x, y, content, {size = 13, anchor = "middle", fill = ink, style = ""} = {}) {
  const more = (anchor === "start" ? "" : ` text-anchor="${anchor}"`) + (fill === ink ? "" : ` fill="${fill}"`) + style;
  return `<text x="${n(x)}" y="${n(y + 0.35 * size)}" font-size="${n(size)}"${more}>${escaped(content)}</text>`;
}

export const path = (data, more = "") => `<path d="${data}"${more}/>`;
export const polyline = (points, more = "") =>
  path(points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${n(x)} ${n(y)}`).join(""), more);
export const polygon = (points, more = "") =>
  path(points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${n(x)} ${n(y)}`).join("") + "Z", more);
export const circle = ([x, y], r, more = "") => `<circle cx="${n(x)}" cy="${n(y)}" r="${n(r)}"${more}/>`;
export const dot = (point) => circle(point, 2.4, ` fill="${ink}" stroke="none"`);

/** The head of an arrow, and where its line ends; `direction` has length 1. */
export function arrowHead(tip, [dx, dy]) {
  const base = [tip[0] - dx * arrow.length, tip[1] - dy * arrow.length];
  const corner = (side) => [base[0] - side * dy * arrow.half, base[1] + side * dx * arrow.half];
  return {base, head: polygon([tip, corner(1), corner(-1)], ` fill="${ink}" stroke="none"`)};
}

export const group = (attributes, parts) => [`<g ${attributes}>`, ...parts.filter((part) => part !== ""), "</g>"].join("\n");

/** The whole file. */
export function page({width, height}, title, parts) {
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${n(width)}" height="${n(height)}" ` +
      `viewBox="0 0 ${n(width)} ${n(height)}" font-family="Helvetica, Arial, sans-serif">`,
    ...(title ? [`<title>${escaped(title)}</title>`] : []),
    `<rect width="100%" height="100%" fill="#fff"/>`,
    ...parts,
    "</svg>",
    "",
  ].join("\n");
}
