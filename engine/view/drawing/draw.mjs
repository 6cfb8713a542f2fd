// Draws block diagrams and mechanisms: what is to be drawn goes in, as engine/view/drawing/graph.hpp and rig.mjs describe it, and
// SVG comes out. It needs neither a browser nor node; elk (an ELK of elkjs) is handed in.

import {drawCompared} from "./compared.mjs";
import {arrange, arrangeLike, arrangeRow} from "./picture.mjs";
import {relabeled} from "./relabeled.mjs";
import {arrangeRig, drawRig} from "./rig.mjs";
import {piecesOf, svgOf} from "./svg.mjs";

export {arrange, arrangeLike, arrangeRow, arrangeRig, drawCompared, drawRig, piecesOf, relabeled, svgOf};

/** The picture of a graph as the text of an SVG file; the same graph gives the same text. */
export async function draw(graph, elk) {
  return svgOf(await arrange(graph, elk), graph.title);
}
