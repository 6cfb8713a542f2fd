// A figure that shows a diagram or a mechanism: drawn by the drawing's own modules.

import {drawRig} from "../../../../../view/drawing/rig.mjs";
import {drawGraph} from "../drawing/layouter";
import {svgElement} from "../drawing/svg_guard";
import type {Graph} from "./spec";

/** The SVG without what only a file of its own needs: its style for dark screens. */
const forPage = (text: string) => text.replace(/<style>[^<]*<\/style>/g, "").replaceAll(' style="paint-order:stroke"', ' paint-order="stroke"');

export async function graphText({panel, graph}: Graph): Promise<string> {
  return panel === "rig" ? drawRig(graph as Parameters<typeof drawRig>[0]) : drawGraph(graph);
}

export async function graphElement(graph: Graph): Promise<SVGSVGElement> {
  const drawn = svgElement(forPage(await graphText(graph)));
  const [, , width, height] = (drawn.getAttribute("viewBox") ?? "").split(" ");
  drawn.setAttribute("width", width ?? "");
  drawn.setAttribute("height", height ?? "");
  return drawn;
}
