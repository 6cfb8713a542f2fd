import type {Theme} from "./colors";
import type {PathPiece, Piece, TextPiece} from "./pieces";
import type {Table} from "./spec";
import {textWidth, wrapped} from "./text_size";

const rowHeight = 23, gap = 26, margin = 18, size = 13, noteSize = 12;

/** True if every cell of a column is a number, possibly with a spread or unit. */
const isNumbers = (cells: readonly string[]) => cells.some((cell) => cell !== "") && cells.every((cell) => /^\s*$|^[-–−]$|^[<>≤≥~±]?\s*[-−+]?[\d.]/.test(cell));

/** Returns a table as pieces, with its size; numbers are right-aligned, words left-aligned. */
export function tablePieces({title, columns, rows, notes}: Table, theme: Theme): {pieces: Piece[]; width: number; height: number} {
  const cells = columns.map((_, i) => rows.map((row) => row[i] ?? "")), right = cells.map(isNumbers);
  const widths = columns.map((head, i) => Math.max(...[head, ...cells[i]!].map((cell) => textWidth(cell, size))));
  const needed = widths.reduce((sum, width) => sum + width + gap, 2 * margin - gap), width = Math.max(needed, 420, textWidth(title, 15) + 2 * margin);
  const pieces: Piece[] = [];
  let y = 0;
  const text = (x: number, anchor: TextPiece["anchor"], letters: number, color: string, words: string) => pieces.push({piece: "text", x, y, text: words, size: letters, color, anchor});
  const rule = (thick: number) => pieces.push({piece: "path", lines: [[margin, y, width - margin, y]], stroke: {color: theme.frame, width: thick}} as PathPiece);
  const row = (list: readonly string[], color: string) => {
    y += rowHeight - 6;
    let x = margin;
    widths.forEach((wide, i) => {
      text(right[i] ? x + wide : x, right[i] ? "end" : "start", size, color, list[i] ?? "");
      x += wide + gap;
    });
    y += 6;
  };
  y += 28;
  text(0.5 * width, "middle", 15, theme.ink, title);
  y += 12;
  rule(1.4);
  row(columns, theme.ink);
  rule(0.8);
  for (const list of rows) row(list, theme.ticks);
  rule(1.4);
  y += 4;
  for (const line of notes.flatMap((note) => wrapped(note, noteSize, width - 2 * margin))) {
    y += 16;
    text(margin, "start", noteSize, theme.ticks, line);
  }
  return {pieces, width, height: y + margin};
}
