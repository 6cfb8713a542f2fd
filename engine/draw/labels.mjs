// Finds places for names where they cover nothing.

import {widthOf} from "./text.mjs";

const height = 12, gap = 3, between = 8;

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
  for (const distance of [17, 25, 35, 47])
    for (const share of [0.5, 0.38, 0.62, 0.26, 0.74])
      for (const side of [1, -1]) {
        const [dx, dy] = across.map((one) => side * one);
        const at = [ax + share * (bx - ax) + distance * dx, ay + share * (by - ay) + distance * dy];
        const outward = (at[0] - centre[0]) * dx + (at[1] - centre[1]) * dy > 0;
        found.push({at, anchor: anchorOf(dx), rank: distance + (outward ? 0 : 8)});
      }
  return found.sort((a, b) => a.rank - b.rank);
}

function aroundBox({left, right, top, bottom}) {
  const [cx, cy] = [(left + right) / 2, (top + bottom) / 2];
  const found = [];
  for (const distance of [9, 18, 30, 44])
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
function leaderTo([x, y], {left, right, top, bottom}) {
  const from = [Math.min(Math.max(x, left), right), Math.min(Math.max(y, top), bottom)];
  const distance = Math.hypot(from[0] - x, from[1] - y), radius = 10;
  if (distance < 22) return undefined;
  return [from, [x + (radius * (from[0] - x)) / distance, y + (radius * (from[1] - y)) / distance]];
}

/**
 * Places for the names of things: each {name, at: [point], isLink}. `obstacles` are {segment, half} and boxes. Returns
 * {name, at, anchor, leader} for each.
 */
export function placeNames(things, obstacles, centre, page) {
  const taken = [], inside = ({left, right, top, bottom}) => left >= 4 && top >= 4 && right <= page.width - 4 && bottom <= page.height - 4;
  const free = (box) => inside(box) && !taken.some((other) => overlaps(grown(box, between), other)) && !obstacles.some((one) =>
    one.segment ? meets(one.segment, grown(box, one.half + gap)) : overlaps(box, one));
  return things.map(({name, at, isLink}) => {
    const candidates = isLink ? besideLink(at, centre) : aroundBox(hull(at, at.length > 1 ? 0 : 8)), width = widthOf(name, height);
    const best = candidates.find((one) => free(boxOf(one.at, one.anchor, width))) ?? candidates[0];
    const box = boxOf(best.at, best.anchor, width);
    taken.push(box);
    return {name, ...best, leader: at.length === 1 ? leaderTo(at[0], grown(box, 2)) : undefined};
  });
}
