// The picture in the page: one group for each shape and wire, which are marked, selected and moved one by one.

import {svg} from "../shell/dom";
import {svgElement} from "./svg_guard";
import type {Picture, Shape, Wire} from "./types";

const moveTime = 150;  // ms
/** So many pieces are made at a time, and for so long without a pause [ms]. */
const slice = 12, longest = 8;
const frame = (pieces: string[]) => `<svg xmlns="http://www.w3.org/2000/svg" font-family="Helvetica, Arial, sans-serif">${pieces.map((piece) => `<g>${piece}</g>`).join("")}</svg>`;
const idOf = (prefix: string, id: string) => `${prefix}-${[...id].map((letter) => (/[\w-]/.test(letter) ? letter : `_${letter.codePointAt(0)!.toString(16)}_`)).join("")}`;

/** A shape by its place too, since constants of different parts may have one name. */
export const keyOf = ({id, within}: {id: string; within: string[]}) => [...within, id].join("/");

export interface Placed {
  shape: Shape;
  element: SVGGElement;
}

export interface Laid {
  wire: Wire;
  element: SVGGElement;
}

export class Shapes {
  readonly root = svg("svg", {class: "picture", width: "100%", height: "100%"});
  placed = new Map<string, Placed>();
  laid: Laid[] = [];
  private readonly over = svg("g", {class: "over"});

  /** Makes the elements of a picture, some at a time, so that the page answers meanwhile: of its wires, its shapes, its forks. */
  async made(picture: Picture): Promise<SVGGElement[]> {
    const texts = [...picture.wires, ...picture.shapes].map(({svg: text}) => text).concat(picture.forks), groups: SVGGElement[] = [];
    for (let from = 0, begin = performance.now(); from < texts.length; from += slice) {
      groups.push(...[...svgElement(frame(texts.slice(from, from + slice))).children] as SVGGElement[]);
      if (performance.now() - begin < longest) continue;
      await new Promise((resolve) => setTimeout(resolve));
      begin = performance.now();
    }
    return groups;
  }

  /** Shows a picture by its elements; what was there before moves to its new place unless `isStill`. */
  show(picture: Picture, groups: SVGGElement[], describe: (shape: Shape) => string, isStill: boolean): void {
    const before = this.placed, count = picture.wires.length;
    this.root.setAttribute("font-family", "Helvetica, Arial, sans-serif");
    this.laid = picture.wires.map((wire, i) => ({wire, element: this.wire(wire, groups[i])}));
    this.placed = new Map(picture.shapes.map((shape, i) => [keyOf(shape), {shape, element: this.shape(shape, groups[count + i], describe(shape))}]));
    const of = (isFrame: boolean) => [...this.placed.values()].filter(({shape}) => shape.isFrame === isFrame).map(({element}) => element);
    const wires = svg("g", {class: "wires"}, ...this.laid.map(({element}) => element), groups[groups.length - 1]);
    this.root.replaceChildren(svg("g", {class: "frames"}, ...of(true)), wires, svg("g", {class: "blocks"}, ...of(false)), this.over);
    if (before.size > 0 && !isStill) this.animate(before, wires);
  }

  /** What is drawn above all, such as the wire that is dragged. */
  overlay(...children: SVGElement[]): void {
    this.over.replaceChildren(...children);
  }

  /** The shape of a block that is not a constant, by its name. */
  find(id: string): Placed | undefined {
    return [...this.placed.values()].find(({shape}) => shape.id === id);
  }

  /** The shape that an event is for. */
  of(target: EventTarget | null): Placed | undefined {
    const element = target instanceof Element ? target.closest<SVGGElement>("[data-shape]") : null;
    return element ? this.placed.get(element.dataset.shape!) : undefined;
  }

  /** Marks blocks by their names as faulty, with why. */
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

  private shape(shape: Shape, element: SVGGElement, text: string): SVGGElement {
    const {x, y, width, height} = shape, by = shape.isFrame ? 0 : 4, dot = (kind: string) => (port: Shape["inputs"][number]) =>
      svg("circle", {class: `port port-${kind}`, cx: x + port.x, cy: y + port.y, r: 5, "data-port": port.port});
    element.setAttribute("class", `shape${shape.isFrame ? " frame" : ""}${shape.isPart ? " part" : ""}`);
    element.setAttribute("data-shape", keyOf(shape));
    element.setAttribute("id", idOf("shape", keyOf(shape)));
    element.setAttribute("role", "option");
    element.setAttribute("aria-label", text);
    element.prepend(svg("rect", {class: "halo", x: x - by, y: y - by, width: width + 2 * by, height: height + 2 * by, rx: 4}));
    element.append(svg("text", {class: "warning", x: x + width, y: y - 2, "text-anchor": "middle"}, "!"),
      ...shape.inputs.map(dot("input")), ...shape.outputs.map(dot("output")));
    return element;
  }

  private wire(wire: Wire, element: SVGGElement): SVGGElement {
    element.setAttribute("class", "wire");
    element.setAttribute("data-wire", "");
    const d = wire.points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${x} ${y}`).join("");
    element.append(svg("path", {class: "grip", d}));
    return element;
  }

  private animate(before: Map<string, Placed>, wires: SVGGElement): void {
    const options = {duration: moveTime, easing: "ease-out"};
    let isMoved = false;
    for (const [key, {shape, element}] of this.placed) {
      const old = before.get(key)?.shape;
      if (!old) element.animate([{opacity: 0}, {opacity: 1}], options);
      else if (old.x !== shape.x || old.y !== shape.y) element.animate([{transform: `translate(${old.x - shape.x}px, ${old.y - shape.y}px)`}, {transform: "none"}], options);
      isMoved ||= !old || old.x !== shape.x || old.y !== shape.y;
    }
    if (isMoved) wires.animate([{opacity: 0}, {opacity: 0.2, offset: 0.6}, {opacity: 1}], options);
  }
}
