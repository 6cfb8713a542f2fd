import {textColor} from "./colors";
import type {Drawing, Point} from "./drawing";
import {letter} from "./layout";
import type {Piece} from "./pieces";
import type {Text} from "./spec";

const anchors = {left: "start", center: "middle", right: "end"} as const;

/** Returns texts in front of all marks, each with its dot. */
export function textPieces(texts: readonly Text[], drawing: Drawing, place: (x: number, y: number) => Point): Piece[] {
  const {frame, theme} = drawing;
  return texts.flatMap((text): Piece[] => {
    const [x, y] = text.in_frame
      ? [frame.left + (text.x ?? 0) * (frame.right - frame.left), frame.bottom - (text.y ?? 0) * (frame.bottom - frame.top)]
      : place(text.x ?? 0, text.y ?? 0);
    if (!Number.isFinite(x) || !Number.isFinite(y)) return [];
    const color = textColor(text.rim ? "#101010" : (text.color ?? "#111111"), theme), size = text.size ?? 13, [right, up] = text.offset ?? [0, 0];
    const pieces: Piece[] = text.dot ? [{piece: "dots", at: [x, y], radius: 0.5 * text.dot, fill: color}] : [];
    if (!text.text) return pieces;
    const at = {x: x + right * letter.width, y: y - up * letter.height + 0.325 * size};
    return [...pieces, {piece: "text", ...at, text: text.text, size, color, anchor: anchors[text.align ?? "center"], ...(text.rim ? {rim: theme.paper} : {})}];
  });
}
