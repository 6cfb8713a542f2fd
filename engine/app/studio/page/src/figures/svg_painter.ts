// Pieces as a tree of SVG elements, for elements of the page or the text of a file.

import type {ClippedPiece, DotsPiece, PathPiece, Piece, Stroke, TextPiece} from "./pieces";
import {pngAddress} from "./png";

export interface Element {
  name: string;
  attributes: Record<string, string>;
  children: Element[];
  text?: string;
}

const number = (value: number) => String(Math.round(value * 100) / 100 + 0);

function element(name: string, attributes: Record<string, string | number | undefined>, children: Element[] = [], text?: string): Element {
  const kept: Record<string, string> = {};
  for (const [key, value] of Object.entries(attributes)) if (value !== undefined) kept[key] = typeof value === "number" ? number(value) : value;
  return text === undefined ? {name, attributes: kept, children} : {name, attributes: kept, children, text};
}

const strokeAttributes = (stroke: Stroke | undefined) => stroke && {
  stroke: stroke.color, "stroke-width": number(stroke.width), "stroke-linecap": "round", "stroke-linejoin": "round",
  "stroke-dasharray": stroke.dash?.map(number).join(" "), "stroke-opacity": stroke.opacity === undefined ? undefined : number(stroke.opacity),
};

function pathText(lines: PathPiece["lines"], closed: boolean | undefined): string {
  let text = "";
  for (const line of lines) {
    for (let i = 0; i + 1 < line.length; i += 2) text += `${i === 0 ? "M" : "L"}${number(line[i]!)} ${number(line[i + 1]!)}`;
    if (closed) text += "Z";
  }
  return text;
}

function pathElement({lines, closed, fill, opacity, stroke}: PathPiece): Element[] {
  if (lines.length === 0) return [];
  return [element("path", {d: pathText(lines, closed), fill: fill ?? "none", "fill-opacity": opacity, ...strokeAttributes(stroke)})];
}

function dotElements({at, radius, fill, stroke}: DotsPiece): Element[] {
  const circles: Element[] = [];
  for (let i = 0; i < at.length; i += 2) circles.push(element("circle", {cx: at[i], cy: at[i + 1], r: radius}));
  return circles.length === 0 ? [] : [element("g", {fill: fill ?? "none", ...strokeAttributes(stroke)}, circles)];
}

function textElement({x, y, text, size, color, anchor, angle, rim}: TextPiece): Element {
  const turned = angle ? `rotate(${number(angle)} ${number(x)} ${number(y)})` : undefined;
  const around = rim === undefined ? {} : {stroke: rim, "stroke-width": "3", "stroke-linejoin": "round", "paint-order": "stroke"};
  return element("text", {x, y, "font-size": size, fill: color, "text-anchor": anchor === "start" ? undefined : anchor, transform: turned, ...around}, [], text);
}

/** Painter of one picture; the ids of its definitions begin with `prefix`. */
export class SvgPainter {
  private readonly definitions: Element[] = [];
  constructor(private readonly prefix: string) {}

  /** Returns the definitions and the elements of all layers. */
  paint(pieces: readonly Piece[]): Element[] {
    const drawn = this.elements(pieces);
    return this.definitions.length === 0 ? drawn : [element("defs", {}, this.definitions), ...drawn];
  }

  private elements(pieces: readonly Piece[]): Element[] {
    return pieces.flatMap((piece) => this.one(piece));
  }

  private one(piece: Piece): Element[] {
    switch (piece.piece) {
      case "path":
        return pathElement(piece);
      case "dots":
        return dotElements(piece);
      case "text":
        return [textElement(piece)];
      case "clipped":
        return [this.clipped(piece)];
      case "cells": {
        const {x, y, width, height, columns, rows, pixels} = piece;
        return [element("image", {x, y, width, height, preserveAspectRatio: "none", "image-rendering": "pixelated", href: pngAddress(pixels, columns, rows)})];
      }
      case "ground": {
        const {x, y, width, height, radius, colors} = piece;
        return [element("rect", {x, y, width, height, rx: radius, fill: this.gradient("linearGradient", {x1: 0, y1: 0, x2: 0, y2: 1}, [[0, colors[0], 1], [1, colors[1], 1]])})];
      }
      case "light":
        return [element("circle", {cx: piece.x, cy: piece.y, r: piece.radius, fill: this.gradient("radialGradient", {cx: 0.36, cy: 0.32, r: 0.75}, lightStops)})];
    }
  }

  private define(made: (id: string) => Element): string {
    const id = `${this.prefix}-${this.definitions.length}`;
    this.definitions.push(made(id));
    return `url(#${id})`;
  }

  private gradient(name: string, attributes: Record<string, number>, stops: readonly (readonly [number, string, number])[]): string {
    const children = stops.map(([offset, color, opacity]) => element("stop", {offset, "stop-color": color, "stop-opacity": opacity}));
    return this.define((id) => element(name, {id, ...attributes}, children));
  }

  private clipped({x, y, width, height, pieces}: ClippedPiece): Element {
    const region = this.define((id) => element("clipPath", {id}, [element("rect", {x, y, width, height})]));
    return element("g", {"clip-path": region}, this.elements(pieces));
  }
}

export const lightStops = [[0, "#ffffff", 0.85], [0.35, "#ffffff", 0.1], [1, "#000000", 0.55]] as const;

// Characters that XML does not allow or that are invisible.
// eslint-disable-next-line no-control-regex
const unseen = /[\u0000-\u0008\u000b-\u001f\u007f-\u009f\ufffe\uffff]/g;
const escapes: Record<string, string> = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"};
const escaped = (text: string) => text.replace(unseen, " ").replace(/[&<>"]/g, (sign) => escapes[sign]!);

/** Serialises an element, with texts escaped. */
export function svgText({name, attributes, children, text}: Element): string {
  const list = Object.entries(attributes).map(([key, value]) => ` ${key}="${escaped(value)}"`).join("");
  const inside = (text === undefined ? "" : escaped(text)) + children.map(svgText).join("");
  return inside === "" ? `<${name}${list}/>` : `<${name}${list}>${inside}</${name}>`;
}

/** Returns a whole picture as the text of an SVG file. */
export function svgFile(width: number, height: number, paper: string, pieces: readonly Piece[], title: string): string {
  const root = element("svg", {xmlns: "http://www.w3.org/2000/svg", width, height, viewBox: `0 0 ${number(width)} ${number(height)}`, "font-family": "Helvetica, Arial, sans-serif"}, [
    element("title", {}, [], title), element("rect", {width, height, fill: paper}), ...new SvgPainter("f").paint(pieces)]);
  return svgText(root) + "\n";
}

/** Creates an element of the page. */
export function pageElement({name, attributes, children, text}: Element): SVGElement {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  made.append(...children.map(pageElement));
  return made;
}
