// Rectangles: what nodes and pieces of wire take up.

export const grown = ({left, right, top, bottom}, by) => ({left: left - by, right: right + by, top: top - by, bottom: bottom + by});
export const overlap = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

/** What a piece of wire covers, given by its ends. */
export const areaOf = ([[ax, ay], [bx, by]]) =>
  ({left: Math.min(ax, bx), right: Math.max(ax, bx), top: Math.min(ay, by), bottom: Math.max(ay, by)});
