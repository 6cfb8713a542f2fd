import type {Camera} from "three";
import {Vector3} from "three";
import {piecesOf} from "../../../../../view/drawing/text.mjs";
import {h, svg} from "../shell/dom";
import {type Box, type Place, placeLabel} from "./label_places";

interface Label extends Place {
  element: HTMLElement;
  at: Vector3;
}

/** Distance from its point above which a label has a leader line [px]. */
const near = 22;

/** Labels over a 3-D view, without overlaps or clipping; a label without space is omitted. Text after "_" is a subscript. */
export class MechanismLabels {
  private readonly leaders = svg("path", {fill: "none"});
  private readonly lines = svg("svg", {class: "mechanism-leaders", width: "100%", height: "100%"}, this.leaders);
  readonly element = h("div", {class: "mechanism-labels", "aria-hidden": true}, this.lines);
  private labels: Label[] = [];

  clear(): void {
    this.labels = [];
    this.element.replaceChildren(this.lines);
  }

  /** Adds a label; the returned vector is its position. */
  add(name: string): Vector3 {
    const pieces = piecesOf(name).map(({text, low}: {text: string; low: boolean}) => (low ? h("sub", {}, text) : text));
    const label = {element: h("span", {}, ...pieces), at: new Vector3(), width: 0, last: 0};
    this.labels.push(label);
    this.element.append(label.element);
    return label.at;
  }

  put(camera: Camera, width: number, height: number): void {
    const taken: Box[] = [];
    let leaders = "";
    for (const label of this.labels) {
      const seen = label.at.clone().project(camera), x = 0.5 * (seen.x + 1) * width, y = 0.5 * (1 - seen.y) * height;
      label.width ||= label.element.offsetWidth;
      const box = Math.abs(seen.z) <= 1 ? placeLabel(label, x, y, taken, width, height) : undefined;
      label.element.style.setProperty("visibility", box ? "visible" : "hidden");
      if (!box) continue;
      taken.push(box);
      label.element.style.setProperty("transform", `translate(${box.x.toFixed(1)}px, ${box.y.toFixed(1)}px) translate(-50%, -50%)`);
      const toX = Math.min(Math.max(x, box.x - box.half), box.x + box.half), toY = box.y + Math.sign(y - box.y) * Math.min(Math.abs(y - box.y), 8);
      if (Math.hypot(toX - x, toY - y) > near - 8) leaders += `M${x.toFixed(1)} ${y.toFixed(1)}L${toX.toFixed(1)} ${toY.toFixed(1)}`;
    }
    this.leaders.setAttribute("d", leaders);
  }
}
