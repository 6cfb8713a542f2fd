// The JSON of a figure: engine/app/studio/protocol.md. Fields with their default value are omitted; `null` in a column is a missing
// number. Sizes are pixels from the upper left corner, angles degrees.

export type Column = (number | null)[];

export interface Rows {
  x?: Column;
  y?: Column;
  z?: Column;
  value?: Column;
}

export interface Line {
  color?: string;
  width?: number;
  dash?: number[];
}

interface Legend {
  legend?: string;
}

export interface LineMark extends Legend {
  mark: "line";
  curves: Rows[];
  line?: Line;
  dots?: number;
}
export interface BandMark {
  mark: "band";
  x: Column;
  low: Column;
  high: Column;
  color: string;
  opacity?: number;
}
export interface SpanMark {
  mark: "span";
  low?: number;
  high?: number;
  color: string;
}
export interface AreaMark {
  mark: "area";
  x: Column;
  y: Column;
  color: string;
}
export interface PointsMark extends Legend {
  mark: "points";
  rows: Rows;
  symbol?: "disc" | "ring" | "asterisk";
  size?: number;
  width?: number;
  color?: string;
}
export interface BoxesMark extends Legend {
  mark: "boxes";
  x: Column;
  low_whisker: Column;
  lower: Column;
  upper: Column;
  high_whisker: Column;
  width?: number;
  color: string;
}
export interface RectanglesMark extends Legend {
  mark: "rectangles";
  x_low: Column;
  x_high: Column;
  y_low: Column;
  y_high: Column;
  value?: Column;
  color?: string;
  edge?: string;
}
export interface ImageMark {
  mark: "image";
  x?: number;
  y?: number;
  dx?: number;
  dy?: number;
  columns: number;
  rows: number;
  values: Column;
}
export interface VectorsMark extends Legend {
  mark: "vectors";
  x: Column;
  y: Column;
  dx: Column;
  dy: Column;
  value?: Column;
  line?: Line;
  pivot?: number;
  head?: number;
  head_angle?: number;
  fixed_heads?: boolean;
}
export interface SurfaceMark {
  mark: "surface";
  lines: Rows[];
}
export type Mark =
  | LineMark | BandMark | SpanMark | AreaMark | PointsMark | BoxesMark | RectanglesMark | ImageMark | VectorsMark | SurfaceMark;

export interface Axis {
  label?: string;
  unit?: string;
  range?: [number, number];
  log?: boolean;
  step?: number;
  more_ticks?: number[];
  named_ticks?: {at?: number; label?: string}[];
  label_angle?: number;
  line?: boolean;
  tick_marks?: boolean;
  grid?: boolean;
  zero_line?: boolean;
}

export interface Text {
  text?: string;
  x?: number;
  y?: number;
  in_frame?: boolean;
  align?: "left" | "center" | "right";
  offset?: [number, number];
  size?: number;
  color?: string;
  rim?: boolean;
  dot?: number;
}

export type Box = [left: number, top: number, width: number, height: number];

export interface Plot {
  panel: "plot";
  box?: Box;
  title?: string;
  x?: Axis;
  y?: Axis;
  z?: Axis;
  color?: Axis;
  palette?: {at?: number; color: string}[];
  view?: {elevation?: number; azimuth?: number};
  equal?: boolean;
  closed_frame?: boolean;
  legend?: "none" | "above" | "beside";
  frame?: Box;
  marks?: Mark[];
  texts?: Text[];
}
export interface Table {
  panel: "table";
  box?: Box;
  title: string;
  columns: string[];
  rows: string[][];
  notes: string[];
}
/** Block of a diagram, or element of a mechanism. */
export interface Named {
  name?: string;
  kind?: string;
}
export interface Graph {
  panel: "diagram" | "rig";
  box?: Box;
  graph: {title?: string; nodes?: Named[]; elements?: Named[]};
}
/** Shape of a scene in metres; `points` of walls are the lines of their boundary. */
export interface Shape {
  kind: string;
  name?: string;
  points: [number, number][];
  size: number;
  width: number;
  color: string;
  shown: boolean;
  closed?: boolean;
  text?: string;
}
export interface SceneStill {
  panel: "scene";
  box?: Box;
  x: [number, number];
  y: [number, number];
  background: string;
  instants: {words: string; shapes: Shape[]}[];
}
export type Panel = Plot | Table | Graph | SceneStill;

export interface Figure {
  title?: string;
  width?: number;
  height?: number;
  aligned?: boolean;
  panels?: Panel[];
}
