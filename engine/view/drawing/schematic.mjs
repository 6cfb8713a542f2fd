// Symbols of schematics and of what acts on a mechanism. Distances between points are to scale, symbols have their own size.

import {arrowHead, circle, faint, frameOf, polygon, polyline} from "./pen.mjs";

export const acting = "#b03020";
const body = "#e6ecf3", plate = "#f1f1ee";
const fill = (color) => ` fill="${color}"`, none = ` fill="none"`;
const reach = {force: [12, 62], motion: [-26, 26]};

/** Where a direction points to on paper, with length 1. */
export function pointing({points: [point], direction = [1, 0]}, {place}) {
  const far = point.map((one, i) => one + 0.01 * (direction[i] ?? 0)), [a, b] = [place(point), place(far)];
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1e-9;
  return [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
}

/** Both ends of the arrow of a force or a motion; that of a motion lies beside its point, since what moves lies on it. */
export function arrowEnds(element, page) {
  const [x, y] = page.place(element.points[0]), [dx, dy] = pointing(element, page), aside = element.kind === "motion" ? 22 : 0;
  return reach[element.kind].map((far) => [x + far * dx + aside * dy, y + far * dy - aside * dx]);
}

function force(element, page) {
  const [from, to] = arrowEnds(element, page), {base, head} = arrowHead(to, pointing(element, page), acting, 1.4);
  return polyline([from, base], ` stroke="${acting}" stroke-width="2.4"`) + head;
}

function motion(element, page) {
  const ends = arrowEnds(element, page), [dx, dy] = pointing(element, page);
  const heads = [arrowHead(ends[0], [-dx, -dy]), arrowHead(ends[1], [dx, dy])];
  return polyline(heads.map(({base}) => base), ` stroke-width="1.4"`) + heads.map(({head}) => head).join("");
}

/** Three quarters of a circle around a point. */
function torque({at: [[x, y]]}) {
  const r = 26, at = (angle) => [x + r * Math.cos(angle), y - r * Math.sin(angle)], tip = at(3.9);
  const {base, head} = arrowHead(tip, [-Math.sin(3.9 - 0.15), -Math.cos(3.9 - 0.15)], acting, 1.4);
  const points = Array.from({length: 31}, (_, i) => at(-0.6 + (4.3 * i) / 30));
  return polyline([...points, base], ` fill="none" stroke="${acting}" stroke-width="2"`) + head;
}

/** A line of symmetry or about which something turns. */
const axis = ({at}) => `<g stroke-dasharray="12 3 2 3" stroke-width="0.9">${polyline(at)}</g>`;

/** A cylinder that is open at one end, and its piston. */
function dashpot({at}) {
  const {length, line} = frameOf(at), from = 0.36 * length, to = 0.64 * length, half = 11;
  return line([0, 0], [from, 0]) + line([to, half], [from, half], [from, -half], [to, -half]) +
    line([0.53 * length, half - 2], [0.53 * length, 2 - half]) + line([0.53 * length, 0], [length, 0]);
}

/** A loop of hysteresis in a box. */
function boucWen({at}) {
  const {length, line, box, at: place} = frameOf(at), k = Math.min(1.6, Math.max(1, length / 160));
  const half = 17 * k, [from, to] = [length / 2 - 24 * k, length / 2 + 24 * k];
  const curve = (sign) => Array.from({length: 25}, (_, i) => {
    const x = -1 + i / 12;
    return place(length / 2 + 18 * k * x, -11 * k * Math.tanh(3 * (x - 0.35 * sign)) / Math.tanh(1.95));
  });
  return line([0, 0], [from, 0]) + line([to, 0], [length, 0]) + box(from, to, half, fill("#fff")) +
    [1, -1].map((sign) => polyline(curve(sign), `${none} stroke-width="1.1"`)).join("");
}

const rectangle = ([[ax, ay], [bx, by]]) => [[ax, ay], [bx, ay], [bx, by], [ax, by]];
const box = ({at}) => polygon(rectangle(at), fill(body));

/** A line with hatching to the left of its way; nothing stands on that side. */
function wall({at}) {
  const {length, line} = frameOf(at), hatch = [];
  for (let u = 5; u < length; u += 9) hatch.push(line([u, 0], [u - 6, -8]));
  return line([0, 0], [length, 0]) + `<g stroke-width="0.9">${hatch.join("")}</g>`;
}

const base = (element, lines) =>
  lines.map((line) => polygon(line, `${fill(plate)} stroke="${faint}" stroke-width="1.6"`)).join("");

/** A block on two rails. */
function slide(element, page) {
  const [x, y] = element.at[0], [dx, dy] = pointing({...element, direction: element.direction ?? [0, 1]}, page);
  const at = (u, v) => [x + u * dx - v * dy, y + u * dy + v * dx];
  const rail = (v) => polyline([at(-34, v), at(34, v)]) + polyline([at(-34, 1.3 * v), at(34, 1.3 * v)]);
  return rail(-10) + rail(10) + polygon([at(-13, -9), at(13, -9), at(13, 9), at(-13, 9)], fill(body)) + circle([x, y], 4);
}

/** Symbols between two points, at points, and behind everything. */
export const between = {dashpot, bouc_wen: boucWen, axis};
export const at = {force, motion, torque, slide};
export const behind = {base, box, wall};
