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

/** What a layout gives: the picture in pieces, and in which way it was laid out. */
export interface Picture {
  width: number;
  height: number;
  shapes: Shape[];
  wires: Wire[];
  forks: string;
  like: {style?: object; flips?: boolean};
  cost: number;
}

export interface TextRange {
  file: number;
  from: number;
  to: number;
}

/** What the page orders of the worker, and what it answers. */
export type Order = {id: number; graph: Graph} & ({want: "picture"; like: Picture["like"] | null} | {want: "text"});
export type Answer = {id: number; picture?: Picture; text?: string; stopped?: boolean; fault?: string};
