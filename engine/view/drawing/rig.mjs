// Draws a mechanism to scale: a rig is {title, dimensions, elements}, an element {kind, points, name}, a point a list of
// two or three coordinates in metres. engine/view/plot/plot_rig.cpp says what kinds there are.

import {placeNames} from "./labels.mjs";
import {areas, atPoint, bodyOfLoadCell, extents, halves, linear, wide} from "./mechanism.mjs";
import {arrowHead, faint, group, ink, n, page, polyline, text, written} from "./pen.mjs";
import {arrowEnds} from "./schematic.mjs";
import {widthOfName} from "./text.mjs";
import {segmentsOf} from "./wires.mjs";

const largest = {width: 480, height: 420}, margin = {left: 110, right: 110, top: 64, bottom: 90, inSpace: 40, schematic: -30};
/** How far the eye is turned about y, from z towards x, and raised. */
const turned = (50 * Math.PI) / 180, raised = (22 * Math.PI) / 180;

/** In space a rig may have z upwards: then what is drawn as x, y and z are y, z and x, which turns it only. */
const seen = (rig, [x, y, z]) => (rig.dimensions === 3 && rig.up === "z" ? [y, z ?? 0, x] : z === undefined ? [x, y] : [x, y, z]);

/** From metres to millimetres on paper, y downwards; what lies in space is seen from where x, y and z are positive. */
function project([x, y, z], dimensions) {
  if (dimensions < 3) return [1000 * x, -1000 * y];
  const toEye = x * Math.sin(turned) + z * Math.cos(turned);
  return [1000 * (x * Math.cos(turned) - z * Math.sin(turned)), -1000 * (y * Math.cos(raised) - toEye * Math.sin(raised))];
}

/** How near to the eye something lies. */
const nearness = (rig, points) => points.map((point) => seen(rig, point)).reduce((sum, [x, y, z = 0]) => sum + x * Math.sin(turned) + z * Math.cos(turned) + 0.4 * y, 0) / points.length;

/** The line of a dimension lies beside what it measures, to the left of the way. */
function dimensionEnds({points: [from, to], offset = 0}) {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]], length = Math.hypot(dx, dy) || 1;
  return [from, to].map(([x, y, ...rest]) => [x - (dy / length) * offset, y + (dx / length) * offset, ...rest]);
}

const outerPoints = (element) => (element.kind === "dimension" ? [...element.points, ...dimensionEnds(element)] : element.points);

/** Pixels for each millimetre, and where things lie on the page. */
function sheet(rig) {
  const onPaper = (point) => project(seen(rig, point), rig.dimensions);
  const all = rig.elements.flatMap((element) => outerPoints(element).map(onPaper));
  const [xs, ys] = [all.map(([x]) => x), all.map(([, y]) => y)];
  const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const scale = Math.min(largest.width / Math.max(right - left, 1e-6), largest.height / Math.max(bottom - top, 1e-6));
  const place = (point) => {
    const [x, y] = onPaper(point);
    return [margin.left + scale * (x - left), margin.top + scale * (y - top)];
  };
  const width = margin.left + scale * (right - left) + margin.right;
  const below = margin.bottom + (rig.dimensions === 3 ? margin.inSpace : 0) + (rig.schematic ? margin.schematic : 0);
  return {place, scale, width: Math.max(width, 300), height: margin.top + scale * (bottom - top) + below};
}

const nice = [500, 200, 100, 50, 20, 10, 5, 2, 1];
const plain = ` fill="${ink}" stroke="none"`, rimmed = ` fill="${ink}" stroke="#fff" stroke-width="4" style="paint-order:stroke"`;

/** The axes: in the plane they show directions, in space also how long a distance along each of them looks. */
function axes(rig, {scale, width, height}, length) {
  const ends = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].slice(0, rig.dimensions)
    .map((axis) => project(seen(rig, axis.map((one) => (one * length) / 1000)), rig.dimensions));
  const stretch = rig.dimensions === 3 ? scale : 32 / length, left = Math.min(0, ...ends.map(([u]) => u)), low = Math.max(0, ...ends.map(([, v]) => v));
  const right = Math.max(...ends.map(([u]) => u));
  const origin = rig.dimensions === 3 ? [width - 50 - stretch * right, height - 50 - stretch * low] : [28 - stretch * left, height - 26 - stretch * low];
  return ends.map(([u, v], i) => {
    const size = Math.hypot(u, v), direction = [u / size, v / size];
    const tip = [origin[0] + stretch * u, origin[1] + stretch * v], {base, head} = arrowHead(tip, direction);
    const letter = text(tip[0] + 9 * direction[0], tip[1] + 9 * direction[1], (rig.axes ?? ["x", "y", "z"])[i] ?? "", {size: 12, style: `${plain} font-style="italic"`});
    return polyline([origin, base]) + head + letter;
  }).join("");
}

/** How long so many millimetres are: a bar, and in space the arrows of the axes. */
function scaleBar(rig, {scale, width, height}, length) {
  const [x, y] = [width - 34, height - 26];
  if (rig.dimensions === 3) return text(x, y, `arrows of the axes: ${length} mm`, {size: 11, anchor: "end", style: plain});
  const from = x - length * scale;
  return `<path d="M${n(from)} ${n(y - 4)}V${n(y + 4)}M${n(x)} ${n(y - 4)}V${n(y + 4)}M${n(from)} ${n(y)}H${n(x)}"/>` +
    text((from + x) / 2, y - 10, `${length} mm`, {size: 11, style: plain});
}

/** The lines to what is measured begin where the symbol of a joint ends. */
const besidePoint = 25;

/** A dimension with the true distance of its points. */
function dimension(element, {place}) {
  const [from, to] = element.points, millimetres = 1000 * Math.hypot(...from.map((one, i) => one - to[i]));
  const [a, b] = element.points.map(place), [p, q] = dimensionEnds(element).map(place);
  const long = Math.hypot(q[0] - p[0], q[1] - p[1]) || 1, [ux, uy] = [(q[0] - p[0]) / long, (q[1] - p[1]) / long];
  const heads = [arrowHead(p, [-ux, -uy]), arrowHead(q, [ux, uy])];
  const helper = ([x, y], [px, py]) => {
    const far = Math.hypot(px - x, py - y) || 1, from = Math.min(besidePoint, 0.5 * far) / far, to = 1 + 5 / far;
    return polyline([from, to].map((share) => [x + share * (px - x), y + share * (py - y)]), ` stroke="${faint}"`);
  };
  const angle = (Math.atan2(uy, ux) * 180) / Math.PI, upright = angle > 90 || angle <= -90 ? angle + 180 : angle;
  const label = text(0, -9, `${n(Math.round(10 * millimetres) / 10)} mm`, {size: 11, style: rimmed});
  return helper(a, p) + helper(b, q) + polyline(heads.map(({base}) => base)) + heads.map(({head}) => head).join("") +
    `<g transform="translate(${n((p[0] + q[0]) / 2)} ${n((p[1] + q[1]) / 2)}) rotate(${n(upright)})">${label}</g>`;
}

/** What names must not cover. */
function obstaclesOf(placed, page, centre) {
  const segments = (points) => points.slice(1).map((point, i) => ({segment: [points[i], point], half: 1}));
  const corners = [{left: 0, right: 90, top: page.height - 80, bottom: page.height},
    {left: page.width - 140, right: page.width, top: page.height - 50, bottom: page.height}];
  return corners.concat(placed.flatMap((element) => {
    if (element.kind === "dimension") {
      const [p, q] = dimensionEnds(element).map(page.place), [a, b] = element.at;
      return [...segments([a, p]), {segment: [p, q], half: 14}, ...segments([q, b])];
    }
    if (element.kind in linear) return [{segment: element.at, half: halves[element.kind] ?? 9}, ...(extents[element.kind]?.(element, centre) ?? [])];
    if (element.kind === "box") return [hull(element.at)];
    if (element.kind === "force" || element.kind === "motion") return [{segment: arrowEnds(element, page), half: 6}];
    if (element.kind in areas) return areaLines(element, page).flatMap(segments);
    return element.at.flatMap((point) => extents[element.kind]?.(point, element, page) ?? []);
  }));
}

/** The lines of an area: of a rectangle, of a box, or as it was given. */
function areaLines({kind, points, at}, {place}) {
  if (kind === "path" || kind === "wall") return [at];
  if (points.length !== 2) return [[...at, at[0]]];
  const [low, high] = points, face = [[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]];
  const outline = (...rest) => face.map(([i, j]) => place([points[i][0], points[j][1], ...rest]));
  if (low.length < 3) return [outline()];
  const [back, front] = [outline(low[2]), outline(high[2])];
  return [back, front, ...back.map((corner, i) => [corner, front[i]])];
}

/** Where what a name is for lies: a link, or what is beside it; an area or a point. */
function namedThing(element, paper, centre) {
  const {name, kind, at} = element;
  if (kind === "force" || kind === "motion") return {name, at: [arrowEnds(element, paper)[1]], isLink: false, isNear: true};
  if (kind === "base") return {name, at: [], edges: areaLines(element, paper).flatMap((points) => segmentsOf([...points, points[0]]))};
  if (kind === "load_cell") return {name, at: bodyOfLoadCell(element), isBody: true};
  if (kind in areas) return {name, at: areaLines(element, paper).flat(), isLink: false};
  if (kind in wide) return {name, at: extents[kind](at[0], element, paper).flatMap(({left, right, top, bottom}) => [[left, top], [right, bottom]]), isLink: false};
  const beside = kind in linear ? extents[kind]?.(element, centre)[0] : undefined;
  return {name, at: beside?.segment ?? at, isLink: kind in linear && kind !== "arrow" && kind !== "axis", half: halves[kind]};
}

const hull = (points) => {
  const [xs, ys] = [0, 1].map((i) => points.map((point) => point[i]));
  return {left: Math.min(...xs), right: Math.max(...xs), top: Math.min(...ys), bottom: Math.max(...ys)};
};

/** True if a name is in its box. */
function isInside({name, kind, at}) {
  if (!name || kind !== "box") return false;
  const {left, right, top, bottom} = hull(at);
  return right - left > widthOfName(name) + 8 && bottom - top > 16;
}

/** How much more room arrows of a fixed length need at each side of the page. */
function moreRoom(rig, paper) {
  const ends = rig.elements.filter(({kind}) => kind === "force" || kind === "motion").flatMap((element) => arrowEnds(element, paper));
  const {left, right, top, bottom} = hull([...ends, [40, 40], [paper.width - 40, paper.height - 40]]), room = 36;
  return {left: Math.max(0, room - left), top: Math.max(0, room - top),
    right: Math.max(0, right + room - paper.width), bottom: Math.max(0, bottom + room - paper.height)};
}

/** A page with more room at its sides. */
function widened(paper, {left, right, top, bottom}) {
  const place = (point) => {
    const [x, y] = paper.place(point);
    return [x + left, y + top];
  };
  return {...paper, place, width: paper.width + left + right, height: paper.height + top + bottom};
}

/**
 * What a rig's picture is made of: {paper, placed, names, centre}. The paper has a scale [pixels per mm] and tells where a
 * point lies on it; an element has `at`, its points there. Where a name finds no place, the page becomes larger.
 */
export function arrangeRig(rig) {
  for (const {kind} of rig.elements)
    if (!(kind in linear || kind in atPoint || kind in areas || kind === "dimension")) throw new Error(`there is no element '${kind}'`);
  const narrow = sheet(rig);
  let paper = widened(narrow, moreRoom(rig, narrow)), arranged;
  for (let tries = 0; tries < 6; ++tries) {
    arranged = arrangeOn(paper, rig);
    if (arranged.names.every(({isFree}) => isFree)) break;
    paper = widened(paper, {left: 40, right: 40, top: 30, bottom: 30});
  }
  return arranged;
}

function arrangeOn(paper, rig) {
  const placed = rig.elements.map((element) => ({...element, at: element.points.map(paper.place)}));
  const joints = placed.filter(({kind}) => kind in linear || kind in atPoint).flatMap(({at}) => at);
  const centre = [0, 1].map((i) => joints.reduce((sum, point) => sum + point[i], 0) / Math.max(1, joints.length));
  const named = placed.filter((element) => element.name && !isInside(element)).map((element) => namedThing(element, paper, centre));
  return {paper, placed, centre, names: placeNames(named, obstaclesOf(placed, paper, centre), centre, paper)};
}

/** A name in its box. */
function innerName(element) {
  const {left, right, top, bottom} = hull(element.at);
  return written(element.name, [(left + right) / 2, (top + bottom) / 2], "middle");
}

/** The height that a title takes. */
const heightOf = (title) => (title ? 28 : 0);

/** The title in the middle above the parts. */
const titled = (title, paper, parts) => (title
  ? [group(`fill="${ink}"`, [text(paper.width / 2, heightOf(title) / 2, title, {size: 15, anchor: "middle"})]),
    group(`transform="translate(0,${heightOf(title)})"`, parts)]
  : parts);

/** The picture of a rig as the text of an SVG file. */
export function drawRig(rig) {
  const above = heightOf(rig.title);
  const {paper, placed, centre, names} = arrangeRig(rig), of = (kinds) => placed.filter(({kind}) => kind in kinds);
  const length = nice.find((one) => one * paper.scale <= 90) ?? 1;
  const line = `stroke="${ink}" stroke-width="1.3" stroke-linejoin="round" stroke-linecap="round"`;
  const links = of(linear).map(({at}) => at), fromFar = of(linear).sort((a, b) => nearness(rig, a.points) - nearness(rig, b.points));
  const parts = [
    group(`fill="none" ${line}`, of(areas).map((element) => areas[element.kind](element, areaLines(element, paper)))),
    group(`fill="#fff" ${line}`, [
      ...fromFar.map((element) => linear[element.kind](element, paper, centre)),
      ...of(atPoint).map((element) => atPoint[element.kind](element, paper, links)),
    ]),
    group(`fill="none" stroke="${ink}" stroke-width="0.9"`, [
      ...placed.filter(({kind}) => kind === "dimension").map((element) => dimension(element, paper)),
      ...(rig.schematic ? [] : [axes(rig, paper, length), scaleBar(rig, paper, length)]),
    ]),
    group(`stroke="${faint}" stroke-width="0.8"`, names.map(({leader}) => (leader ? polyline(leader) : ""))),
    group(`fill="${ink}"`, [
      ...placed.filter(isInside).map(innerName), ...names.map(({name, at, anchor}) => written(name, at, anchor)),
    ]),
  ];
  return page({width: paper.width, height: paper.height + above}, rig.title, titled(rig.title, paper, parts));
}
