// Graphs and pictures of the drawing's module, engine/view/drawing.

/** What the server draws: see engine/view/drawing/graph.hpp. */
export interface Graph {
  title?: string;
  nodes: {id: string; name: string; type?: string; part?: boolean; graph?: Graph}[];
  [key: string]: unknown;
}

export interface End {
  node: string;
  port: string;
}

/** Pixels of the picture; a port's place is relative to its block. */
export interface Port {
  port: string;
  x: number;
  y: number;
  unit?: string;
}

export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** A block, a port of the file (":input:u") or a constant (":constant:3"). */
export interface Shape extends Box {
  id: string;
  name: string;
  type: string;
  isPart: boolean;
  isFrame: boolean;
  own: "input" | "output" | "";
  lines: string[];
  within: string[];
  inputs: Port[];
  outputs: Port[];
  svg: string;
}

export interface Wire {
  from: End;
  to: End | null;
  within: string[];
  unit: string;
  points: [number, number][];
  svg: string;
}

/** What a layout gives: the picture in pieces, and what the next layout needs to keep to it. */
export interface Picture {
  /** By which the worker knows it. */
  id: number;
  /** Are only words other than in the picture before? */
  isRelabeled: boolean;
  width: number;
  height: number;
  shapes: Shape[];
  wires: Wire[];
  forks: string;
  cost: number;
}

export interface TextRange {
  file: number;
  from: number;
  to: number;
}

/** What the page orders of the worker: a sketch close to a picture by its id (0 for none), the best picture, or the text of a file. */
export type Order = {id: number; graph: Graph} & ({want: "sketch"; like: number} | {want: "best"} | {want: "text"});
export type Answer = {id: number; picture?: Picture; text?: string; stopped?: boolean; fault?: string};
