// Scene from the server, and its shapes at one instant.

import {numberText} from "../figures/axis";
import type {Shape} from "../figures/spec";

export type Place = [x: number, y: number]; // [m]

export interface SceneObject {
  name: string;
  kind: string;
  text?: string;
  walls?: {points: Place[]; closed: boolean}[];
}

/** Pointer of the scene: names of the inputs for its position and its grip. */
export interface PointerInfo {
  name: string;
  held: string;
  text: string;
  /** True if the page's hand moves it, false for the file's own hand. */
  hand?: boolean;
}

export interface SceneInfo {
  x: [number, number];
  y: [number, number];
  background: string;
  title?: string;
  objects: SceneObject[];
  pointer?: PointerInfo | null;
}

/** Shape at one instant; `object` and `wall` are indices of the scene's objects and their walls. */
export interface ShapeNews {
  object: number;
  wall?: number;
  points: Place[];
  size: number;
  width: number;
  color: string | {value: string};
  crossed?: boolean;
  shown: boolean;
}

export interface SceneNews {
  time: number;
  shapes: ShapeNews[];
  /** Instant of the newest pointer sample that acts in it, by the page's clock [s]. */
  input?: number | null;
}

/** Returns the shapes to draw: the news with the names, kinds, texts and walls of the scene. */
export function shapesOf(info: SceneInfo, news: SceneNews): Shape[] {
  return news.shapes.flatMap((shape): Shape[] => {
    const object = info.objects[shape.object];
    if (!object) return [];
    const wall = shape.wall === undefined ? undefined : object.walls?.[shape.wall], color = typeof shape.color === "string" ? shape.color : shape.color.value;
    const made: Shape = {kind: object.kind, name: object.name, points: wall ? wall.points : shape.points, size: shape.size, width: shape.width, color, shown: shape.shown};
    if (wall) made.closed = wall.closed;
    if (object.text) made.text = object.text;
    return [made];
  });
}

const millimetres = ([x, y]: Place) => `${numberText(Math.round(1e4 * x) / 10)} mm, ${numberText(Math.round(1e4 * y) / 10)} mm`;

/** Describes the instant in words. */
export function describeScene(info: SceneInfo, news: SceneNews): string {
  const parts = news.shapes.filter(({shown}) => shown).flatMap((shape): string[] => {
    const object = info.objects[shape.object];
    if (!object) return [];
    if (object.kind === "walls") return shape.crossed ? [`wall ${(shape.wall ?? 0) + 1} of ${object.name} is crossed`] : [];
    if (object.kind === "text") return object.text ? [`“${object.text}”`] : [];
    const [at] = shape.points.slice(-1);
    return at ? [`${object.name} at ${millimetres(at)}`] : [];
  });
  return [`at ${news.time.toFixed(2)} s`, ...parts].join("; ");
}

/** Returns the start position of a hand without one: that of a moved object, else the centre. */
export function startOf(info: SceneInfo, news: SceneNews | undefined): Place {
  const isMoved = ({object, shown}: ShapeNews) => shown && ["ball", "point"].includes(info.objects[object]?.kind ?? "");
  const shape = news?.shapes.findLast((one) => isMoved(one) && info.objects[one.object]!.kind === "ball") ?? news?.shapes.find(isMoved);
  return shape?.points[0] ?? [0.5 * (info.x[0] + info.x[1]), 0.5 * (info.y[0] + info.y[1])];
}
