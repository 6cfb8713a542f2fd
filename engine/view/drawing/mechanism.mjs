// The symbols of mechanisms. Distances along a link are to scale, widths are those of symbols.

import {arrowHead, circle, faint, frameOf, ink, polygon, polyline} from "./pen.mjs";
import * as schematic from "./schematic.mjs";

const body = "#e6ecf3", dark = "#c3cfdd", joint = 4, neck = 3;

/** How long the housing of a link is, in pixels: as the file says, or a good half. */
const housing = ({body: given}, length, scale) => Math.min(given ? 1000 * given * scale : 0.58 * length, 0.9 * length);

const fill = (color) => ` fill="${color}"`;
const ends = (element) => element.at.map((point) => circle(point, joint)).join("");

/** Cylinder with its piston, and the rod. */
function damper(element, {scale}) {
  const {length, box} = frameOf(element.at), to = housing(element, length, scale), piston = 0.62 * to;
  return box(0, 14, neck) + box(14, to, 8, fill(body)) + box(piston, length - joint, 2) +
    box(piston - 5, piston + 1, 8, fill(dark)) + ends(element);
}

/** Housing with windings, and a thrust rod. */
function motor(element, {scale}) {
  const {length, box, line} = frameOf(element.at), to = housing(element, length, scale), windings = [];
  for (let u = 22; u < to - 8; u += 10) windings.push(line([u, -9], [u + 5, 9]));
  return box(0, 12, neck) + box(to, length - joint, 2.5) + box(12, to, 9, fill(body)) + windings.join("") + ends(element);
}

function spring(element) {
  const {length, line} = frameOf(element.at), turns = 8, from = 0.2 * length, step = (0.6 * length) / turns;
  const zigzag = Array.from({length: turns}, (_, i) => [from + (i + 0.5) * step, i % 2 ? -7 : 7]);
  return line([0, 0], [from, 0], ...zigzag, [length - from, 0], [length, 0]);
}

function rod(element) {
  const {length, box} = frameOf(element.at);
  return box(0, length, 2) + ends(element);
}

/** On which side of a link the middle of the rig does not lie. */
function outerSide([a, b], centre) {
  const cross = (b[0] - a[0]) * (centre[1] - a[1]) - (b[1] - a[1]) * (centre[0] - a[0]);
  return cross > 1e-6 || (Math.abs(cross) <= 1e-6 && b[0] >= a[0]) ? -1 : 1;
}

/** How far from the link what is beside it lies. */
const besides = {potentiometer: 17, lvdt: 24};

/** Beside a link: a drum at one end, and the string to the other. */
function potentiometer(element, page, centre) {
  const {length, at, line} = frameOf(element.at), v = besides.potentiometer * outerSide(element.at, centre);
  const string = `<g stroke-dasharray="5 3" stroke-width="1">${line([24, v], [length, v])}</g>`;
  const arm = (u) => polygon([at(u - 2, 0), at(u + 2, 0), at(u + 2, v), at(u - 2, v)]);
  return string + arm(0) + arm(length) + circle(at(length, v), 2.5) +
    polygon([at(-4, v - 7), at(22, v - 7), at(22, v + 7), at(-4, v + 7)], fill(body)) + circle(at(9, v), 4);
}

/** Beside a link: a coil, and its core on a rod. */
function lvdt(element, page, centre) {
  const {length, at, line} = frameOf(element.at), v = besides.lvdt * outerSide(element.at, centre), half = 5.5;
  const rect = (from, to, width, more) => polygon([at(from, v - width), at(to, v - width), at(to, v + width), at(from, v + width)], more);
  const middle = 0.45 * length, pin = Math.sign(v) * joint, windings = [0.15, 0.22, 0.29, 0.36, 0.43, 0.5, 0.57].map((u) => line([u * length, v - half], [u * length, v + half]));
  return `<g stroke-width="1">${line([0.6 * length, v], [length, v], [length, pin])}${line([0.1 * length, v], [0, v], [0, pin])}</g>` +
    rect(0.1 * length, 0.62 * length, half, fill(body)) + windings.join("") + rect(middle, 0.75 * length, 2);
}

/** In a link, at its second end; a short one is a link by itself. */
function loadCell(element) {
  const {length, box, line} = frameOf(element.at), [from, to] = [length - 26, length - 10];
  const start = length < 90 ? joint : length - 40;
  return line([Math.max(0, start), 0], [length, 0]) + box(from, to, 8, fill(dark)) + line([from, -8], [to, 8]) + line([from, 8], [to, -8]);
}

/** The corners of what stands in the link, not of the link. */
export function bodyOfLoadCell({at}) {
  const {length, at: place} = frameOf(at);
  return [place(length - 26, -8), place(length - 10, -8), place(length - 10, 8), place(length - 26, 8)];
}

function arrow(element) {
  const [from, to] = element.at, length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1e-9;
  const {base, head} = arrowHead(to, [(to[0] - from[0]) / length, (to[1] - from[1]) / length]);
  return polyline([from, base], ` stroke-width="1.8"`) + head;
}

/** Symbols between two points. */
export const linear = {damper, motor, spring, rod, potentiometer, lvdt, load_cell: loadCell, arrow, ...schematic.between};

/** A joint that turns about one axis. */
const hinge = (point) => circle(point, joint);

/** A joint that turns about two: a cross in a ring. */
function cross([x, y]) {
  const r = 8, d = r * Math.SQRT1_2;
  return circle([x, y], r) + polyline([[x - d, y - d], [x + d, y + d]]) + polyline([[x - d, y + d], [x + d, y - d]]);
}

/** A joint at the ground: it stands on the side from which no link comes. */
const standing = (symbol) => (element, page, links) => {
  return element.at.map(([x, y]) => {
    const away = [0, 0];
    for (const [a, b] of links)
      for (const [here, there] of [[a, b], [b, a]]) {
        if (Math.hypot(here[0] - x, here[1] - y) > 1) continue;
        const length = Math.hypot(there[0] - x, there[1] - y) || 1;
        away[0] -= (there[0] - x) / length;
        away[1] -= (there[1] - y) / length;
      }
    const level = Math.abs(away[0]) > 1.5 * Math.abs(away[1]);
    const [dx, dy] = level ? [Math.sign(away[0]), 0] : [0, Math.sign(away[1]) || 1];
    const at = (u, v) => [x + u * dx - v * dy, y + u * dy + v * dx];
    const hatch = [-14, -7, 0, 7, 14].map((v) => polyline([at(15, v), at(21, v - 6)], ` stroke-width="0.9"`));
    return polygon([[x, y], at(15, -9), at(15, 9)]) + polyline([at(15, -17), at(15, 17)]) + hatch.join("") + symbol([x, y]);
  }).join("");
};

const onEach = (symbol) => (element) => element.at.map(symbol).join("");

/** A carriage on a rail. */
function carriage([x, y]) {
  const wheel = (dx) => circle([x + dx, y + 20], 4), hatch = [];
  for (let dx = -58; dx <= 58; dx += 9) hatch.push(polyline([[x + dx, y + 24], [x + dx - 5, y + 30]], ` stroke-width="0.9"`));
  return polygon([[x - 2, y - 16], [x + 46, y - 16], [x + 46, y + 16], [x - 2, y + 16]], fill(dark)) +
    wheel(8) + wheel(36) + polyline([[x - 62, y + 24], [x + 62, y + 24]]) + hatch.join("") + circle([x, y], joint);
}

/** A shaker, which moves what ends at it in its direction. */
function shaker(element, page) {
  const [[x, y]] = element.at, [dx, dy] = schematic.pointing(element, page), at = (u, v) => [x + u * dx - v * dy, y + u * dy + v * dx];
  const wave = Array.from({length: 25}, (_, i) => at(-50 + (28 * i) / 24, -12 * Math.sin((2 * Math.PI * i) / 24)));
  return polygon([at(-58, -26), at(-14, -26), at(-14, 26), at(-58, 26)], fill(body)) + polyline(wave, ` fill="none"`) +
    polygon([at(-14, -3), at(0, -3), at(0, 3), at(-14, 3)]) + circle([x, y], joint);
}

/** What a shaker takes up. */
function aroundShaker([x, y], element, page) {
  const [dx, dy] = schematic.pointing(element, page), along = [-60 * dx, 2 * dx], up = [-60 * dy, 2 * dy];
  const across = 27 * Math.abs(dy), upright = 27 * Math.abs(dx);
  return [{left: x + Math.min(...along) - across, right: x + Math.max(...along) + across,
    top: y + Math.min(...up) - upright, bottom: y + Math.max(...up) + upright}];
}

/** Symbols at one point or at several. */
export const atPoint = {
  ground: standing(hinge),
  universal: standing(cross),
  pin: onEach((point) => circle(point, joint)),
  end_effector: onEach((point) => circle(point, 8) + circle(point, 3, fill(ink))),
  carriage: onEach(carriage),
  shaker,
  rotary_damper: onEach((point) => circle(point, 17, fill(body)) + circle(point, 12, fill(dark)) + circle(point, joint)),
  ...schematic.at,
};

const dashed = ` stroke="${faint}" stroke-dasharray="5 4"`;

/** What lies behind the rig, by its lines. */
export const areas = {
  workspace: (element, lines) => lines.map((line) => polyline(line, dashed)).join(""),
  ...schematic.behind,
  path: (element, lines) => lines.map((line) => polyline(line, ` stroke="#0072b2" stroke-width="1.1"`)).join(""),
};

const around = (left, right, top, bottom) => ([x, y]) => [{left: x - left, right: x + right, top: y - top, bottom: y + bottom}];
const beside = (kind, half) => ({at}, centre) => {
  const {length, at: place} = frameOf(at), v = besides[kind] * outerSide(at, centre);
  return [{segment: [place(0, v), place(length, v)], half}];
};

/** How far symbols reach beside the line between their points, where that is farther than dampers do. */
export const halves = {dashpot: 13, bouc_wen: 30};

/** What symbols take up beside the line between their points. */
export const extents = {
  potentiometer: beside("potentiometer", 8), lvdt: beside("lvdt", 7),
  ground: around(20, 20, 22, 22), universal: around(20, 20, 22, 22), slide: around(36, 36, 36, 36), torque: around(30, 30, 30, 30), pin: around(5, 5, 5, 5), end_effector: around(9, 9, 9, 9),
  carriage: around(62, 62, 17, 30), shaker: aroundShaker, rotary_damper: around(18, 18, 18, 18),
};

/** Symbols that are themselves as large as a name. */
export const wide = {carriage, shaker, slide: schematic.at.slide, torque: schematic.at.torque};
