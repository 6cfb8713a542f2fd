import {widthOf} from "../../../../../view/drawing/text.mjs";

/** Returns an upper estimate of the width of a text in any system font; some are wider than Helvetica [px]. */
export const textWidth = (text: string, size: number): number => 1.06 * widthOf(text, size);

/** Returns the size at which a text is no wider than `room` [px]. */
export const fittedSize = (text: string, usual: number, room: number): number =>
  Math.max(7, Math.min(usual, (usual * room) / Math.max(1, textWidth(text, usual))));

/** Breaks a text into lines no wider than `room`. */
export function wrapped(text: string, size: number, room: number): string[] {
  const lines: string[] = [];
  for (const word of text.split(/\s+/)) {
    const longer = lines.length === 0 ? word : `${lines[lines.length - 1]} ${word}`;
    if (lines.length > 0 && textWidth(longer, size) <= room) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}
