// Picture in the page: one group for each shape and wire, so that each can be marked, selected and moved.

import {svg} from "../shell/dom";
import {svgElement} from "./svg_guard";
import type {Picture, Shape, Wire} from "./types";

const moveTime = 150;  // ms
/** Number of pieces that are created at once, and the time until a pause [ms]. */
const slice = 12, longest = 8;
const frame = (pieces: string[]) => `<svg xmlns="http://www.w3.org/2000/svg" font-family="Helvetica, Arial, sans-serif">${pieces.map((piece) => `<g>${piece}</g>`).join("")}</svg>`;
const idOf = (prefix: string, id: string) => `${prefix}-${[...id].map((letter) => (/[\w-]/.test(letter) ? letter : `_${letter.codePointAt(0)!.toString(16)}_`)).join("")}`;

/** Returns the key of a shape, with its part: constants of different parts may have the same name. */
export const keyOf = ({id, within}: {id: string; within: string[]}) => [...within, id].join("/");

export interface Placed {
  shape: Shape;
  element: SVGGElement;
}

export interface Laid {
  wire: Wire;
  element: SVGGElement;
}

function dressShape(shape: Shape, element: SVGGElement): void {
  const {x, y, width, height} = shape, by = shape.isFrame ? 0 : 4, dot = (kind: string) => (port: Shape["inputs"][number]) =>
    svg("circle", {class: `port port-${kind}`, cx: x + port.x, cy: y + port.y, r: 5, "data-port": port.port});
  const given = {class: `shape${shape.isFrame ? " frame" : ""}${shape.isPart ? " part" : ""}`, "data-shape": keyOf(shape), id: idOf("shape", keyOf(shape)), role: "option"};
  for (const [name, value] of Object.entries(given)) element.setAttribute(name, value);
  element.prepend(svg("rect", {class: "halo", x: x - by, y: y - by, width: width + 2 * by, height: height + 2 * by, rx: 4}));
  element.append(svg("text", {class: "warning", x: x + width, y: y - 2, "text-anchor": "middle"}, "!"),
    ...shape.inputs.map(dot("input")), ...shape.outputs.map(dot("output")));
}

function dressWire(wire: Wire, element: SVGGElement): void {
  element.setAttribute("class", "wire");
  element.setAttribute("data-wire", "");
  element.append(svg("path", {class: "grip", d: wire.points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${x} ${y}`).join("")}));
}

function dress(piece: Wire | Shape | {svg: string}, element: SVGGElement): void {
  if ("points" in piece) dressWire(piece, element);
  else if ("id" in piece) dressShape(piece, element);
}

/** Sets the children of a group; existing ones are not removed and added again. */
function fill(group: SVGGElement, children: SVGGElement[]): void {
  const wanted = new Set<Element>(children);
  for (const child of [...group.children]) if (!wanted.has(child)) child.remove();
  let next = group.firstElementChild;
  for (const child of children) {
    if (child === next) next = next.nextElementSibling;
    else group.insertBefore(child, next);
  }
}

/** Elements of a picture: its wires, its shapes, its forks. */
type Elements = SVGGElement[];

export class Shapes {
  readonly root = svg("svg", {class: "picture", width: "100%", height: "100%", "font-family": "Helvetica, Arial, sans-serif"});
  placed = new Map<string, Placed>();
  laid: Laid[] = [];
  /** Displayed elements by their content. */
  private shown = new Map<string, SVGGElement>();
  private readonly frames = svg("g", {class: "frames"});
  private readonly wires = svg("g", {class: "wires"});
  private readonly blocks = svg("g", {class: "blocks"});
  private readonly over = svg("g", {class: "over"});

  constructor() {
    this.root.append(this.frames, this.wires, this.blocks, this.over);
  }

  /** Returns the elements of a picture. Displayed ones are reused; the others are created in small groups, so that the page stays responsive. */
  async made({wires, shapes, forks}: Picture): Promise<Elements> {
    const pieces = [...wires, ...shapes, {svg: forks}], known = new Map(this.shown), keys = pieces.map((piece) => JSON.stringify(piece));
    const elements = keys.map((key) => (known.delete(key) ? this.shown.get(key) : undefined)), fresh = elements.flatMap((element, i) => (element ? [] : i));
    for (let from = 0, begin = performance.now(); from < fresh.length; from += slice) {
      const some = fresh.slice(from, from + slice), made = [...svgElement(frame(some.map((i) => pieces[i].svg))).children] as SVGGElement[];
      some.forEach((i, k) => dress(pieces[i], elements[i] = made[k]));
      if (performance.now() - begin < longest) continue;
      await new Promise((resolve) => setTimeout(resolve));
      begin = performance.now();
    }
    return elements as Elements;
  }

  /** Shows a picture; shapes move to their new places unless `isStill`. */
  show({wires, shapes, forks}: Picture, elements: Elements, describe: (shape: Shape) => string, isStill: boolean): void {
    const before = this.placed, count = wires.length;
    this.shown = new Map([...wires, ...shapes, {svg: forks}].map((piece, i) => [JSON.stringify(piece), elements[i]]));
    this.laid = wires.map((wire, i) => ({wire, element: elements[i]}));
    this.placed = new Map(shapes.map((shape, i) => [keyOf(shape), {shape, element: elements[count + i]}]));
    for (const {shape, element} of this.placed.values()) element.setAttribute("aria-label", describe(shape));
    const of = (isFrame: boolean) => [...this.placed.values()].filter(({shape}) => shape.isFrame === isFrame).map(({element}) => element);
    fill(this.frames, of(true));
    fill(this.wires, [...elements.slice(0, count), elements[elements.length - 1]]);
    fill(this.blocks, of(false));
    if (before.size > 0 && !isStill) this.animate(before);
  }

  /** Sets the topmost layer, such as a wire during dragging. */
  overlay(...children: SVGElement[]): void {
    this.over.replaceChildren(...children);
  }

  /** Returns the shape of a block by its name, except for constants. */
  find(id: string): Placed | undefined {
    return [...this.placed.values()].find(({shape}) => shape.id === id);
  }

  /** Returns the shape under an event. */
  of(target: EventTarget | null): Placed | undefined {
    const element = target instanceof Element ? target.closest<SVGGElement>("[data-shape]") : null;
    return element ? this.placed.get(element.dataset.shape!) : undefined;
  }

  /** Marks blocks as faulty, with their messages, by name. */
  markFaulty(faults: Map<string, string>): void {
    for (const {shape, element} of this.placed.values()) {
      const message = faults.get(shape.id);
      element.classList.toggle("faulty", message !== undefined);
      if (message) element.setAttribute("aria-description", message);
      else element.removeAttribute("aria-description");
    }
  }

  wireOf(target: EventTarget | null): Laid | undefined {
    const element = target instanceof Element ? target.closest("[data-wire]") : null;
    return this.laid.find((one) => one.element === element);
  }

  private animate(before: Map<string, Placed>): void {
    const options = {duration: moveTime, easing: "ease-out"};
    let isMoved = false;
    for (const [key, {shape, element}] of this.placed) {
      const old = before.get(key)?.shape;
      if (!old) element.animate([{opacity: 0}, {opacity: 1}], options);
      else if (old.x !== shape.x || old.y !== shape.y) element.animate([{transform: `translate(${old.x - shape.x}px, ${old.y - shape.y}px)`}, {transform: "none"}], options);
      isMoved ||= !old || old.x !== shape.x || old.y !== shape.y;
    }
    if (isMoved) this.wires.animate([{opacity: 0}, {opacity: 0.2, offset: 0.6}, {opacity: 1}], options);
  }
}
