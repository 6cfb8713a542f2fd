// Mechanism as described by the server: each coordinate is a number [m] or the text of an expression over signals of the run.

import {numberText} from "../figures/axis";

export type Coordinate = number | string;
export type Point = [x: number, y: number, z: number]; // [m]

export interface MechanismElement {
  kind: string;
  name?: string;
  body?: number;
  offset?: number;
  direction?: number[];
  points: Coordinate[][];
}

export interface Mechanism {
  title: string;
  dimensions: 2 | 3;
  axes?: string[];
  up?: "z";
  elements: MechanismElement[];
}

/** Element with the positions of its points at one instant. */
export interface Placed {
  element: MechanismElement;
  points: Point[];
}

/** Returns all different expressions of a mechanism. */
export const expressionsOf = ({elements}: Mechanism): string[] =>
  [...new Set(elements.flatMap(({points}) => points.flat()).filter((one): one is string => typeof one === "string"))];

/** Returns the positions at one instant; NaN for unknown values. */
export function placed({elements}: Mechanism, values: ReadonlyMap<string, number>): Placed[] {
  const number = (one: Coordinate | undefined) => (one === undefined ? 0 : typeof one === "number" ? one : (values.get(one) ?? Number.NaN));
  return elements.map((element) => ({element, points: element.points.map((point): Point => [number(point[0]), number(point[1]), number(point[2])])}));
}

export const isKnown = ({points}: Placed) => points.every((point) => point.every(Number.isFinite));

const links = new Set(["damper", "motor", "spring", "rod", "dashpot", "bouc_wen", "potentiometer", "lvdt", "load_cell"]);
/** True for an element that connects its two points. */
export const isLink = ({kind, points}: MechanismElement) => links.has(kind) && points.length === 2;

export const distance = ([ax, ay, az]: Point, [bx, by, bz]: Point) => Math.hypot(bx - ax, by - ay, bz - az);

/** Returns the centre of all points, and the largest distance from it [m]. */
export function extentOf(all: readonly Placed[]): {middle: Point; radius: number} {
  const points = all.filter(isKnown).flatMap(({points}) => points);
  if (points.length === 0) return {middle: [0, 0, 0], radius: 0.1};
  const middle = [0, 1, 2].map((i) => 0.5 * (Math.min(...points.map((point) => point[i])) + Math.max(...points.map((point) => point[i])))) as Point;
  return {middle, radius: Math.max(0.01, ...points.map((point) => distance(point, middle)))};
}

const millimetres = (metres: number) => `${numberText(Math.round(1e4 * metres) / 10)} mm`;
const plain = (name: string) => name.replaceAll(/_\{?(\w+)\}?/g, " $1");

export interface Fact {
  name: string;
  value: string;
}

/** Returns the lengths of links and the positions of moving points, in words. */
export function factsOf(mechanism: Mechanism, all: readonly Placed[]): Fact[] {
  const axes = mechanism.axes ?? ["x", "y", "z"];
  return all.filter(isKnown).flatMap(({element, points}): Fact[] => {
    const name = plain(element.name ?? element.kind.replaceAll("_", " "));
    if (isLink(element)) return [{name, value: `${millimetres(distance(points[0], points[1]))} long`}];
    if (element.kind !== "end_effector" || !points[0]) return [];
    return [{name, value: points[0].slice(0, mechanism.dimensions).map((one, i) => `${axes[i] ?? ""} ${millimetres(one)}`).join(", ")}];
  });
}
