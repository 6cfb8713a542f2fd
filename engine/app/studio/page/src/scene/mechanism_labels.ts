import type {Camera} from "three";
import {Vector3} from "three";
import {piecesOf} from "../../../../../view/drawing/text.mjs";
import {h} from "../shell/dom";

interface Label {
  element: HTMLElement;
  at: Vector3;
}

const step = 16; // px from a name to one that stands below it

/** Names over a 3-D view, none on another. What follows "_" stands lower. */
export class MechanismLabels {
  readonly element = h("div", {class: "mechanism-labels", "aria-hidden": true});
  private labels: Label[] = [];

  clear(): void {
    this.labels = [];
    this.element.replaceChildren();
  }

  /** Adds a name; what comes back moves it. */
  add(name: string): Vector3 {
    const pieces = piecesOf(name).map(({text, low}: {text: string; low: boolean}) => (low ? h("sub", {}, text) : text));
    const label = {element: h("span", {}, ...pieces), at: new Vector3()};
    this.labels.push(label);
    this.element.append(label.element);
    return label.at;
  }

  put(camera: Camera, width: number, height: number): void {
    const taken: {x: number; y: number; half: number}[] = [];
    for (const {element, at} of this.labels) {
      const seen = at.clone().project(camera), x = 0.5 * (seen.x + 1) * width, half = 0.5 * element.offsetWidth;
      let y = 0.5 * (1 - seen.y) * height - step;
      element.hidden = !(Math.abs(seen.z) <= 1);
      if (element.hidden) continue;
      while (taken.some((other) => Math.abs(other.x - x) < other.half + half && Math.abs(other.y - y) < step)) y += step;
      taken.push({x, y, half});
      element.style.setProperty("transform", `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, -50%)`);
    }
  }
}
