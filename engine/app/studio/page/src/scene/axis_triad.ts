import {type Camera, Vector3} from "three";
import {h, svg} from "../shell/dom";

const length = 26, half = 42; // px
const ends = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];

/** Directions of the axes of a mechanism, in a corner of its view. */
export class AxisTriad {
  private readonly lines: SVGLineElement[];
  private readonly names: SVGTextElement[];
  readonly element: HTMLElement;

  constructor(axes: readonly string[]) {
    this.lines = axes.map(() => svg("line", {x1: 0, y1: 0}));
    this.names = axes.map((name) => svg("text", {"text-anchor": "middle", "dominant-baseline": "central"}, name));
    const picture = svg("svg", {width: 2 * half, height: 2 * half, viewBox: `${-half} ${-half} ${2 * half} ${2 * half}`}, ...this.lines, ...this.names);
    this.element = h("div", {class: "mechanism-axes", "aria-hidden": true}, picture);
  }

  turn(camera: Camera): void {
    this.lines.forEach((line, i) => {
      const {x, y} = ends[i].clone().transformDirection(camera.matrixWorldInverse);
      line.setAttribute("x2", (length * x).toFixed(1));
      line.setAttribute("y2", (-length * y).toFixed(1));
      this.names[i].setAttribute("x", ((length + 9) * x).toFixed(1));
      this.names[i].setAttribute("y", (-(length + 9) * y).toFixed(1));
    });
  }
}
