// Bodies for the elements of a mechanism, with lengths to scale and symbolic thickness.

import {
  BoxGeometry, BufferGeometry, CatmullRomCurve3, ConeGeometry, CylinderGeometry, DoubleSide, EdgesGeometry, Group, Line, LineBasicMaterial, LineSegments, Mesh,
  MeshStandardMaterial, type Object3D, SphereGeometry, TorusGeometry, TubeGeometry, Vector3,
} from "three";
import type {MechanismElement, Point} from "./mechanism_model";

export interface Colors {
  housing: string;
  steel: string;
  dark: string;
  ground: string;
  acting: string;
  accent: string;
  line: string;
}

/** Body that follows its points. */
export interface Part {
  object: Object3D;
  move(points: readonly Point[]): void;
}

export interface Making {
  colors: Colors;
  /** Thickness of a housing [m]. */
  thick: number;
  up: Vector3;
}

const vector = ([x, y, z]: Point) => new Vector3(x, y, z);
const along = new Vector3(0, 1, 0);
const metal = (color: string, metalness = 0.35) => new MeshStandardMaterial({color, metalness, roughness: 0.45});
const cylinder = (radius: number, color: string, sides = 24) => new Mesh(new CylinderGeometry(radius, radius, 1, sides), metal(color));
const ball = (radius: number, color: string) => new Mesh(new SphereGeometry(radius, 24, 16), metal(color));

/** Places a body of length 1 along y between two points. */
function span(body: Object3D, from: Vector3, to: Vector3): void {
  const way = to.clone().sub(from), length = way.length();
  body.visible = length > 1e-9;
  body.position.copy(from).addScaledVector(way, 0.5);
  body.quaternion.setFromUnitVectors(along, length > 0 ? way.divideScalar(length) : along);
  body.scale.set(1, Math.max(length, 1e-9), 1);
}

/** Creates a housing of fixed length with a sliding rod. */
function telescope(element: MechanismElement, points: readonly Point[], {colors, thick}: Making, housingColor: string): Part {
  const first = vector(points[0]).distanceTo(vector(points[1])), housing = cylinder(thick, housingColor), rod = cylinder(0.35 * thick, colors.steel);
  const cap = cylinder(1.15 * thick, colors.dark), ends = [ball(0.55 * thick, colors.dark), ball(0.55 * thick, colors.dark)];
  const object = new Group().add(housing, rod, cap, ...ends);
  return {object, move: ([a, b]) => {
    const [from, to] = [vector(a), vector(b)], way = to.clone().sub(from), length = way.length() || 1e-9;
    const at = (share: number) => from.clone().addScaledVector(way, share), body = Math.min(element.body ?? 0.58 * first, 0.95 * length) / length, neck = Math.min(0.06, 0.3 * body);
    span(housing, at(neck), at(body));
    span(cap, at(body), at(Math.min(1, body + (0.5 * thick) / length)));
    span(rod, from, to);
    ends[0].position.copy(from);
    ends[1].position.copy(to);
  }};
}

/** Creates a body that stretches between its points. */
const stretched = (body: Object3D): Part => ({object: new Group().add(body), move: ([a, b]) => span(body, vector(a), vector(b))});

function spring({colors, thick}: Making): Part {
  const turns = 9, points = Array.from({length: 180}, (_, i) => {
    const share = i / 179, coil = Math.min(1, Math.max(0, (share - 0.1) / 0.8)), angle = 2 * Math.PI * turns * coil, radius = coil > 0 && coil < 1 ? 0.9 * thick : 0;
    return new Vector3(radius * Math.cos(angle), share - 0.5, radius * Math.sin(angle));
  });
  return stretched(new Mesh(new TubeGeometry(new CatmullRomCurve3(points), 360, 0.18 * thick, 8), metal(colors.steel)));
}

/** Creates a body at each point. */
function atEach(count: number, make: () => Object3D): Part {
  const bodies = Array.from({length: count}, make);
  return {object: new Group().add(...bodies), move: (points) => points.forEach((point, i) => bodies[i]?.position.copy(vector(point)))};
}

/** Creates a ground joint: a block with a ball on it. */
function ground({colors, thick, up}: Making): Object3D {
  const block = new Mesh(new BoxGeometry(3.2 * thick, 1.1 * thick, 3.2 * thick), metal(colors.ground, 0.1));
  block.quaternion.setFromUnitVectors(along, up);
  return new Group().add(block, ball(0.9 * thick, colors.dark));
}

const directionOf = ({direction = [1, 0, 0]}: MechanismElement) => new Vector3(direction[0] ?? 0, direction[1] ?? 0, direction[2] ?? 0).normalize();

/** Creates an arrow of fixed length from a point; a motion has one in either direction. */
function arrow(element: MechanismElement, {colors, thick}: Making): Part {
  const length = 6 * thick, both = element.kind === "motion", color = both ? colors.accent : colors.acting, object = new Group();
  for (const sign of both ? [1, -1] : [1]) {
    const shaft = cylinder(0.22 * thick, color), head = new Mesh(new ConeGeometry(0.7 * thick, 1.8 * thick, 20), metal(color, 0)), way = directionOf(element).multiplyScalar(sign);
    span(shaft, way.clone().multiplyScalar(1.2 * thick), way.clone().multiplyScalar(length));
    head.position.copy(way.clone().multiplyScalar(length + 0.8 * thick));
    head.quaternion.setFromUnitVectors(along, way);
    object.add(shaft, head);
  }
  return {object, move: ([point]) => object.position.copy(vector(point))};
}

/** Creates a flat convex plate with given corners. */
function plate(points: readonly Point[]): BufferGeometry {
  const geometry = new BufferGeometry().setFromPoints(points.map(vector));
  geometry.setIndex(points.slice(2).flatMap((_, i) => [0, i + 1, i + 2]));
  geometry.computeVertexNormals();
  return geometry;
}

/** Creates a box between opposite corners, or a plate with given corners; a workspace is transparent. */
function region({kind}: MechanismElement, points: readonly Point[], {colors, thick}: Making): Part {
  const isOpen = kind === "workspace", material = new MeshStandardMaterial(
    {color: isOpen ? colors.accent : colors.ground, transparent: true, opacity: isOpen ? 0.08 : 0.55, side: DoubleSide, depthWrite: !isOpen});
  const size = (i: number) => Math.max(Math.abs(points[1][i] - points[0][i]), 0.4 * thick);
  const geometry = points.length === 2 ? new BoxGeometry(size(0), size(1), size(2)) : plate(points);
  const body = new Mesh(geometry, material), edges = new LineSegments(new EdgesGeometry(geometry), new LineBasicMaterial({color: colors.line})), object = new Group().add(body, edges);
  return {object, move: (now) => void (now.length === 2 && object.position.copy(vector(now[0]).add(vector(now[1])).multiplyScalar(0.5)))};
}

function polyline({colors}: Making): Part {
  const object = new Line(new BufferGeometry(), new LineBasicMaterial({color: colors.line}));
  return {object, move: (points) => void object.geometry.setFromPoints(points.map(vector))};
}

const mostOfTrail = 2000;

/** Creates the trail of a point. */
function trail({colors}: Making): Part {
  const object = new Line(new BufferGeometry(), new LineBasicMaterial({color: colors.accent})), points: Vector3[] = [];
  return {object, move: ([point]) => {
    const at = vector(point);
    if (points.length > 0 && points[points.length - 1].distanceTo(at) < 1e-6) return;
    points.push(at);
    if (points.length > mostOfTrail) points.shift();
    object.geometry.dispose();
    object.geometry = new BufferGeometry().setFromPoints(points);
  }};
}

/** Creates the body of an element; `points` are its initial positions. */
export function partOf(element: MechanismElement, points: readonly Point[], making: Making): Part {
  const {colors, thick} = making, count = points.length;
  switch (element.kind) {
    case "damper": case "dashpot": case "bouc_wen":
      return telescope(element, points, making, colors.housing);
    case "motor":
      return telescope(element, points, making, colors.accent);
    case "spring":
      return spring(making);
    case "rod":
      return stretched(cylinder(0.4 * thick, colors.steel));
    case "load_cell":
      return stretched(cylinder(0.5 * thick, colors.dark));
    case "potentiometer": case "lvdt": case "axis": case "dimension": case "arrow": case "wall":
      return polyline(making);
    case "ground": case "universal":
      return atEach(count, () => ground(making));
    case "pin":
      return atEach(count, () => ball(0.7 * thick, colors.dark));
    case "end_effector":
      return atEach(count, () => ball(1.2 * thick, colors.accent));
    case "force": case "motion":
      return arrow(element, making);
    case "torque":
      return atEach(count, () => new Mesh(new TorusGeometry(3 * thick, 0.25 * thick, 10, 40, 4.5), metal(colors.acting, 0)));
    case "rotary_damper":
      return atEach(count, () => new Mesh(new CylinderGeometry(2.4 * thick, 2.4 * thick, 2 * thick, 40).rotateX(Math.PI / 2), metal(colors.housing)));
    case "carriage": case "shaker": case "slide":
      return atEach(count, () => new Mesh(new BoxGeometry(3.4 * thick, 2.4 * thick, 2.4 * thick), metal(colors.housing)));
    case "path":
      return trail(making);
    case "base": case "box": case "workspace":
      return region(element, points, making);
    default:
      return atEach(count, () => ball(0.5 * thick, colors.steel));
  }
}
