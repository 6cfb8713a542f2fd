// Finds places for names where they cover nothing.

import {widthOfName} from "./text.mjs";

const height = 12, gap = 3, between = 8, apart = 24;

const overlaps = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
const grown = (box, by) => ({left: box.left - by, right: box.right + by, top: box.top - by, bottom: box.bottom + by});

/** Does a segment meet a box? Both ends on the same outer side mean no; else the box's corners tell. */
function meets([[ax, ay], [bx, by]], {left, right, top, bottom}) {
  if (Math.max(ax, bx) < left || Math.min(ax, bx) > right || Math.max(ay, by) < top || Math.min(ay, by) > bottom) return false;
  const side = (x, y) => Math.sign((bx - ax) * (y - ay) - (by - ay) * (x - ax));
  return new Set([side(left, top), side(right, top), side(left, bottom), side(right, bottom)]).size > 1;
}

/** The box of a text that is anchored at a point. */
function boxOf([x, y], anchor, width) {
  const left = anchor === "start" ? x : anchor === "end" ? x - width : x - width / 2;
  return {left, right: left + width, top: y - height / 2, bottom: y + height / 2};
}

const anchorOf = (dx) => (dx > 0.3 ? "start" : dx < -0.3 ? "end" : "middle");

/** Places beside a link, from its middle outwards, near ones first. */
function besideLink([[ax, ay], [bx, by]], centre) {
  const length = Math.hypot(bx - ax, by - ay) || 1, across = [-(by - ay) / length, (bx - ax) / length];
  const found = [];
  for (const distance of [17, 25, 35, 47, 62, 80, 110])
    for (const share of [0.5, 0.38, 0.62, 0.26, 0.74, 0.14, 0.86])
      for (const side of [1, -1]) {
        const [dx, dy] = across.map((one) => side * one), foot = [ax + share * (bx - ax), ay + share * (by - ay)];
        const at = [foot[0] + distance * dx, foot[1] + distance * dy];
        const outward = (at[0] - centre[0]) * dx + (at[1] - centre[1]) * dy > 0;
        found.push({at, anchor: anchorOf(dx), foot, rank: distance + (outward ? 0 : 8)});
      }
  return found.sort((a, b) => a.rank - b.rank);
}

function aroundBox({left, right, top, bottom}) {
  const [cx, cy] = [(left + right) / 2, (top + bottom) / 2];
  const found = [];
  for (const distance of [9, 18, 30, 44, 64])
    for (const [dx, dy] of [[1, 0], [0, 1], [-1, 0], [0, -1], [1, 1], [-1, 1], [1, -1], [-1, -1]]) {
      const x = dx > 0 ? right + distance : dx < 0 ? left - distance : cx;
      const y = dy > 0 ? bottom + distance : dy < 0 ? top - distance : cy;
      found.push({at: [x, y], anchor: anchorOf(dx)});
    }
  return found;
}

const hull = (points, by) => ({
  left: Math.min(...points.map(([x]) => x)) - by, right: Math.max(...points.map(([x]) => x)) + by,
  top: Math.min(...points.map(([, y]) => y)) - by, bottom: Math.max(...points.map(([, y]) => y)) + by,
});

/** A line from a name to what it is for, where that is not close by. */
function leaderTo([x, y], {left, right, top, bottom}, radius = 10, least = 22) {
  const from = [Math.min(Math.max(x, left), right), Math.min(Math.max(y, top), bottom)];
  const distance = Math.hypot(from[0] - x, from[1] - y);
  if (distance < least) return undefined;
  return [from, [x + (radius * (from[0] - x)) / distance, y + (radius * (from[1] - y)) / distance]];
}

const middleOf = ({left, right, top, bottom}) => [(left + right) / 2, (top + bottom) / 2];

/** How far a box is from a line, by its middle and by its ends. */
function farFrom(box, [[ax, ay], [bx, by]]) {
  const [, cy] = middleOf(box), square = (bx - ax) ** 2 + (by - ay) ** 2 || 1;
  return Math.min(...[box.left, (box.left + box.right) / 2, box.right].map((x) => {
    const share = Math.min(1, Math.max(0, ((x - ax) * (bx - ax) + (cy - ay) * (by - ay)) / square));
    return Math.hypot(x - ax - share * (bx - ax), cy - ay - share * (by - ay));
  }));
}

/** True if another link is nearer to the name of a link, so that a reader would take it for the name of that one. */
const isNearerToAnother = (box, own, others) => others.some((other) => farFrom(box, other) < 1.25 * farFrom(box, own));

/** A line from the name of a link to it, where it is not close by. */
const leaderToLink = (foot, box, half = 9) => leaderTo(foot, box, half, half + 25);

/** The line from a name to what it is for, if it needs one. */
function leaderOf({at, isLink, isBody, isNear, half, edges}, {foot}, box) {
  if (edges || isNear) return undefined;
  if (isLink) return leaderToLink(foot, box, half);
  if (isBody) return leaderTo(middleOf(hull(at, 0)), box);
  return at.length === 1 ? leaderTo(at[0], box) : undefined;
}

/** Places for a name, the best first: beside a link or an edge, or around what is named. */
function placesFor({at, isLink, edges}, centre) {
  if (edges) return edges.flatMap((edge) => besideLink(edge, centre)).sort((a, b) => a.rank - b.rank);
  return isLink ? besideLink(at, centre) : aroundBox(hull(at, at.length > 1 ? 0 : 8));
}

/** The link that is the mirror image of a link about a vertical line, if there is one. */
function mirrorImage({at, isLink}, others) {
  const isImage = (other) => other.isLink && other.name && at.every(([x, y], i) =>
    Math.abs(other.at[i][1] - y) < 0.5 && Math.abs(other.at[i][0] + x - other.at[0][0] - at[0][0]) < 0.5);
  return isLink ? others.find(isImage) : undefined;
}

/** A place on the other side of the vertical line between two links. */
function mirrored({at: [x, y], anchor, foot, rank}, [[ax]], [[bx]]) {
  const other = {start: "end", end: "start", middle: "middle"};
  return {at: [ax + bx - x, y], anchor: other[anchor], foot: foot && [ax + bx - foot[0], foot[1]], rank};
}

const nameBox = ({name}, {at, anchor}) => boxOf(at, anchor, widthOfName(name));

/** True if a link can have its name at a place, and its mirror image at the mirrored one. */
function suitInPair(link, image, place, suits) {
  const other = mirrored(place, link.at, image.at);
  return suits(link, place) && suits(image, other) && !overlaps(grown(nameBox(link, place), apart), nameBox(image, other));
}

/**
 * Places for the names of things: each {name, at: [point], isLink}, or {name, edges};
 * what is not a link may be a body (isBody) or have its name close by in any case (isNear). `obstacles` are {segment, half} and boxes. Returns
 * {name, at, anchor, leader, isFree} for each; `isFree` is false where it covers something. Names of two links that are mirror
 * images have mirrored places where these are free.
 */
export function placeNames(things, obstacles, centre, page) {
  const taken = [], inside = ({left, right, top, bottom}) => left >= 10 && top >= 4 && right <= page.width - 10 && bottom <= page.height - 4;
  const free = (box) => inside(box) && !taken.some((other) => overlaps(grown(box, between), other)) && !obstacles.some((one) =>
    one.segment ? meets(one.segment, grown(box, one.half + gap)) : overlaps(box, one));
  const suits = (thing, place) => {
    const box = nameBox(thing, place), others = things.filter((one) => one.isLink && one !== thing).map(({at}) => at);
    return free(box) && !(thing.isLink && isNearerToAnother(box, thing.at, others));
  };
  const reserved = new Map();  // places of links whose mirror images have theirs
  return things.map((thing, index) => {
    const candidates = placesFor(thing, centre), first = reserved.get(thing) ?? candidates.find((place) => suits(thing, place));
    const image = !reserved.has(thing) && first && mirrorImage(thing, things.slice(index + 1));
    const inPair = image && candidates.find((place) => place.rank <= first.rank && suitInPair(thing, image, place, suits));
    if (inPair) reserved.set(image, mirrored(inPair, thing.at, image.at));
    const found = inPair || first, best = found ?? candidates[0], box = nameBox(thing, best);
    taken.push(box);
    return {name: thing.name, at: best.at, anchor: best.anchor, leader: leaderOf(thing, best, grown(box, 2)), isFree: found !== undefined};
  });
}
