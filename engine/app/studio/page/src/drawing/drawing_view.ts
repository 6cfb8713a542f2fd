import type {Context, View} from "../shell/context";
import {h} from "../shell/dom";

/** The drawing of the diagram. */
export class DrawingView implements View {
  constructor(host: HTMLElement, _context: Context) {
    host.append(h("p", {class: "empty"}, "The drawing follows."));
  }

  dispose(): void {}
}
