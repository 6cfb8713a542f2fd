// Painter of pieces on a canvas: for moving scenes, and for more marks than SVG can show.

import type {CellsPiece, DotsPiece, PathPiece, Piece, Stroke, TextPiece} from "./pieces";
import {lightStops} from "./svg_painter";

type Pen = CanvasRenderingContext2D;

function setStroke(pen: Pen, {color, width, dash, opacity}: Stroke): void {
  pen.strokeStyle = color;
  pen.lineWidth = width;
  pen.lineJoin = "round";
  pen.lineCap = "round";
  pen.setLineDash(dash ? [...dash] : []);
  pen.globalAlpha = opacity ?? 1;
}

function strokeAndFill(pen: Pen, {fill, stroke}: {fill?: string; stroke?: Stroke}, opacity = 1): void {
  if (fill !== undefined) {
    pen.fillStyle = fill;
    pen.globalAlpha = opacity;
    pen.fill();
  }
  if (stroke) {
    setStroke(pen, stroke);
    pen.stroke();
  }
  pen.globalAlpha = 1;
}

function paintPath(pen: Pen, piece: PathPiece): void {
  pen.beginPath();
  for (const line of piece.lines) {
    for (let i = 0; i + 1 < line.length; i += 2) i === 0 ? pen.moveTo(line[0]!, line[1]!) : pen.lineTo(line[i]!, line[i + 1]!);
    if (piece.closed) pen.closePath();
  }
  strokeAndFill(pen, piece, piece.opacity);
}

function paintDots(pen: Pen, piece: DotsPiece): void {
  pen.beginPath();
  for (let i = 0; i + 1 < piece.at.length; i += 2) {
    pen.moveTo(piece.at[i]! + piece.radius, piece.at[i + 1]!);
    pen.arc(piece.at[i]!, piece.at[i + 1]!, piece.radius, 0, 2 * Math.PI);
  }
  strokeAndFill(pen, piece);
}

function paintText(pen: Pen, {x, y, text, size, color, anchor, angle, rim}: TextPiece): void {
  pen.save();
  pen.translate(x, y);
  if (angle) pen.rotate((angle * Math.PI) / 180);
  pen.font = `${size}px Helvetica, Arial, sans-serif`;
  pen.textAlign = anchor === "middle" ? "center" : anchor;
  if (rim !== undefined) {
    setStroke(pen, {color: rim, width: 3});
    pen.strokeText(text, 0, 0);
  }
  pen.fillStyle = color;
  pen.fillText(text, 0, 0);
  pen.restore();
}

function paintCells(pen: Pen, {x, y, width, height, columns, rows, pixels}: CellsPiece): void {
  const image = document.createElement("canvas");
  [image.width, image.height] = [columns, rows];
  image.getContext("2d")?.putImageData(new ImageData(pixels, columns, rows), 0, 0);
  pen.imageSmoothingEnabled = false;
  pen.drawImage(image, x, y, width, height);
}

function paintLight(pen: Pen, x: number, y: number, radius: number): void {
  const [cx, cy] = [x + 2 * (0.36 - 0.5) * radius, y + 2 * (0.32 - 0.5) * radius], light = pen.createRadialGradient(cx, cy, 0, cx, cy, 1.5 * radius);
  for (const [offset, color, opacity] of lightStops) light.addColorStop(offset, color + Math.round(255 * opacity).toString(16).padStart(2, "0"));
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.fillStyle = light;
  pen.fill();
}

/** Paints pieces in their own units; the caller has scaled the pen. */
export function paint(pen: Pen, pieces: readonly Piece[]): void {
  for (const piece of pieces)
    if (piece.piece === "path") paintPath(pen, piece);
    else if (piece.piece === "dots") paintDots(pen, piece);
    else if (piece.piece === "text") paintText(pen, piece);
    else if (piece.piece === "cells") paintCells(pen, piece);
    else if (piece.piece === "light") paintLight(pen, piece.x, piece.y, piece.radius);
    else if (piece.piece === "ground") {
      const {x, y, width, height, radius, colors} = piece, fill = pen.createLinearGradient(0, y, 0, y + height);
      colors.forEach((color, i) => fill.addColorStop(i, color));
      pen.beginPath();
      pen.roundRect(x, y, width, height, radius);
      pen.fillStyle = fill;
      pen.fill();
    } else {
      pen.save();
      pen.beginPath();
      pen.rect(piece.x, piece.y, piece.width, piece.height);
      pen.clip();
      paint(pen, piece.pieces);
      pen.restore();
    }
}
