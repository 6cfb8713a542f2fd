// Draws block diagrams: the graph of a diagram goes in, as engine/draw/graph.hpp describes it, and SVG comes out.
// It needs neither a browser nor node; elk (an ELK of elkjs) is handed in.

import {arrange} from "./layout.mjs";
import {svgOf} from "./svg.mjs";

export {arrange, svgOf};

/** The picture of a graph as the text of an SVG file; the same graph gives the same text. */
export async function draw(graph, elk) {
  return svgOf(await arrange(graph, elk), graph.title);
}
