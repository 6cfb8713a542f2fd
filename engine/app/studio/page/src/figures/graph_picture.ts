// Picture of a figure with a diagram or a mechanism, by the modules of the drawing.

import {drawRig} from "../../../../../view/drawing/rig.mjs";
import {drawGraph} from "../drawing/layouter";
import {svgElement} from "../drawing/svg_guard";
import type {Graph} from "./spec";

/** Removes the parts of an SVG text that only a separate file needs: its style for dark screens. */
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
