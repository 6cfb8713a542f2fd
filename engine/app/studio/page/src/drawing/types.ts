// Graphs and pictures of the module engine/view/drawing.

/** Graph of a diagram from the server; see engine/view/drawing/graph.hpp. */
export interface Graph {
  title?: string;
  nodes: {id: string; name: string; type?: string; part?: boolean; graph?: Graph}[];
  [key: string]: unknown;
}

export interface End {
  node: string;
  port: string;
}

/** Port at a position relative to its block, in pixels of the picture. */
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

/** Block, port of the file (":input:u") or constant (":constant:3"). */
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

/** Result of a layout: the picture in pieces, and the data for a similar next layout. */
export interface Picture {
  /** Number by which the worker identifies the picture. */
  id: number;
  /** True if only words differ from the previous picture. */
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

/** Order for the worker: a sketch similar to a picture (id 0: none), the best picture, or the text of a file. */
export type Order = {id: number; graph: Graph} & ({want: "sketch"; like: number} | {want: "best"} | {want: "text"});
export type Answer = {id: number; picture?: Picture; text?: string; stopped?: boolean; fault?: string};
