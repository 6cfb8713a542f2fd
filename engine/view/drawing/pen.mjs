// What pictures are written with: the pieces of an SVG file.

import {escaped, isQuantity, lowered, nameSize, piecesOf} from "./text.mjs";

export const ink = "#1a1a1a", faint = "#9a9a9a";
const arrow = {length: 8, half: 3.3};

/** A number as short as it may be; none has more than two decimals. */
export const n = (value) => String(Math.round(value * 100) / 100 + 0);

/** A text whose middle line is at y. */
export function text(x, y, content, {size = 13, anchor = "middle", fill = ink, style = ""} = {}) {
  const more = (anchor === "start" ? "" : ` text-anchor="${anchor}"`) + (fill === ink ? "" : ` fill="${fill}"`) + style;
  return `<text x="${n(x)}" y="${n(y + 0.35 * size)}" font-size="${n(size)}"${more}>${escaped(content)}</text>`;
}

/** The inside of a text element; where letters stand lower, the next ones stand as high as before. */
function spans(content, size) {
  const pieces = piecesOf(content);
  return pieces.map(({text: one, low}, i) => {
    const shift = low === (pieces[i - 1]?.low ?? false) ? "" : ` dy="${n((low ? 1 : -1) * lowered.by * size)}"`;
    if (low) return `<tspan font-size="${n(lowered.size * size)}"${shift}>${escaped(one)}</tspan>`;
    return shift ? `<tspan${shift}>${escaped(one)}</tspan>` : escaped(one);
  }).join("");
}

/** The name of a quantity: its letters slant, and what follows "_" stands lower. */
export function quantity(x, y, content, {size = 13, anchor = "start", fill = ink} = {}) {
  const more = (anchor === "start" ? "" : ` text-anchor="${anchor}"`) + (fill === ink ? "" : ` fill="${fill}"`);
  return `<text x="${n(x)}" y="${n(y + 0.35 * size)}" font-size="${n(size)}" font-style="italic"${more}>${spans(content, size)}</text>`;
}

/** A name, of a quantity or a word. */
export const written = (name, [x, y], anchor) =>
  (isQuantity(name) ? quantity : text)(x, y, name, {size: nameSize(name), anchor});

export const path = (data, more = "") => `<path d="${data}"${more}/>`;
export const polyline = (points, more = "") =>
  path(points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${n(x)} ${n(y)}`).join(""), more);
export const polygon = (points, more = "") =>
  path(points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${n(x)} ${n(y)}`).join("") + "Z", more);
export const circle = ([x, y], r, more = "") => `<circle cx="${n(x)}" cy="${n(y)}" r="${n(r)}"${more}/>`;
export const dot = (point) => circle(point, 2.4, ` fill="${ink}" stroke="none"`);

/** The head of an arrow, and where its line ends; `direction` has length 1. */
export function arrowHead(tip, [dx, dy], color = ink, times = 1) {
  const {length, half} = {length: times * arrow.length, half: times * arrow.half};
  const base = [tip[0] - dx * length, tip[1] - dy * length];
  const corner = (side) => [base[0] - side * dy * half, base[1] + side * dx * half];
  return {base, head: polygon([tip, corner(1), corner(-1)], ` fill="${color}" stroke="none"`)};
}

/** The frame of a link: from its first end along it (u) and across (v), in pixels. */
export function frameOf([a, b]) {
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1e-9;
  const [ux, uy] = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
  const at = (u, v) => [a[0] + u * ux - v * uy, a[1] + u * uy + v * ux];
  const box = (from, to, half, more) => polygon([at(from, -half), at(to, -half), at(to, half), at(from, half)], more);
  return {length, at, box, line: (...points) => polyline(points.map(([u, v]) => at(u, v)), ` fill="none"`)};
}

export const group = (attributes, parts) => [`<g ${attributes}>`, ...parts.filter((part) => part !== ""), "</g>"].join("\n");

/** On a dark screen lightness is turned round and hues stay, as engine/view/svg/svg.hpp has it for plots. */
const dark = "<style>@media screen and (prefers-color-scheme: dark){:root{filter:invert(.9) hue-rotate(180deg)}}</style>";

/** The whole file. */
export function page({width, height}, title, parts) {
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${n(width)}" height="${n(height)}" ` +
      `viewBox="0 0 ${n(width)} ${n(height)}" font-family="Helvetica, Arial, sans-serif">`,
    ...(title ? [`<title>${escaped(title)}</title>`] : []),
    dark,
    `<rect width="100%" height="100%" fill="#fff"/>`,
    ...parts,
    "</svg>",
    "",
  ].join("\n");
}
