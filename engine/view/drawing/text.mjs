// Widths of texts, without a browser: those of Helvetica, in thousandths of the font's size.

const widths = [
  278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278, 556, 556, 556, 556, 556, 556, 556,
  556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833,
  722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556,
  556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334,
  260, 334, 584,
];
const other = 600;

/** Width of a text in pixels. */
export function widthOf(text, size) {
  let sum = 0;
  for (const letter of text) {
    const code = letter.codePointAt(0);
    sum += code >= 32 && code < 127 ? widths[code - 32] : other;
  }
  return (sum * size) / 1000;
}

/** Pieces of a text in which what follows "_" stands lower: letters and figures, or what is in braces: F_d, x_{max}. */
export function piecesOf(text) {
  return [...text.matchAll(/_\{([^}]*)\}|_([\p{L}\p{N}]+)|[^_]+|_/gu)]
    .map(([all, braced, word]) => ({text: braced ?? word ?? all, low: (braced ?? word) !== undefined}));
}

/** Lowered letters are smaller, and stand lower by so much of the size. */
export const lowered = {size: 0.78, by: 0.28};

/** Width of such a text in pixels. */
export const widthOfPieces = (text, size) =>
  piecesOf(text).reduce((sum, piece) => sum + widthOf(piece.text, piece.low ? lowered.size * size : size), 0);

/** True for the name of a quantity, F_e or x, and not for a word. */
export const isQuantity = (name) => /^\p{L}{1,2}(_(\{[^}]*\}|[\p{L}\p{N}]+))?$/u.test(name);

/** Size of names in a mechanism; those of quantities are larger. */
export const nameSize = (name) => (isQuantity(name) ? 15 : 12);
export const widthOfName = (name) => (isQuantity(name) ? widthOfPieces : widthOf)(name, nameSize(name));

// Controls, separators of lines, marks of direction, annotations and tags; the same as in engine/base/text/characters.cpp.
const unseen =
  // eslint-disable-next-line no-control-regex
  /[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ufdd0-\ufdef\ufeff\ufff9-\ufffb\ufffe\uffff\u{e0000}-\u{e007f}]|\p{Cs}/gu;

/** A text as it may stand in XML; what XML does not allow, or what is not seen, becomes a blank. */
export function escaped(text) {
  const names = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"};
  return text.replace(unseen, " ").replace(/[&<>"]/g, (c) => names[c]);
}
