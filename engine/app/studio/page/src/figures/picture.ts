// Figure as pieces in three layers; the middle one may be painted on a canvas if it has many marks.

import {dark, light, type Theme} from "./colors";
import type {Piece} from "./pieces";
import {figureTitle, type Layers, plotLayers, type Sheet} from "./plot_panel";
import {stillPieces} from "./scene_panel";
import type {Box, Figure, Graph, Panel} from "./spec";
import {tablePieces} from "./table_panel";

/** Panel that the drawing module draws: a diagram or a mechanism. */
export interface GraphPicture {
  kind: "graph";
  graph: Graph;
}
export interface PiecesPicture {
  kind: "pieces";
  width: number;
  height: number;
  back: Piece[];
  /** Marks of each panel. */
  marks: Piece[][];
  front: Piece[];
}
export type Picture = PiecesPicture | GraphPicture;

const whole = ({pieces, width, height}: {pieces: Piece[]; width: number; height: number}): PiecesPicture =>
  ({kind: "pieces", width, height, back: [], marks: [pieces], front: []});

const usualSize = {width: 680, height: 440};

/** Returns the picture of a figure. A panel that is no plot fills the whole picture. */
export function pictureOf(figure: Figure, isDark: boolean): Picture {
  const theme: Theme = isDark ? dark : light, panels = figure.panels ?? [], [first] = panels;
  if (first?.panel === "table") return whole(tablePieces(first, theme));
  if (first?.panel === "scene") return whole(stillPieces(first, figure.title ?? "", theme));
  if (first && first.panel !== "plot") return {kind: "graph", graph: first};
  return plotsPicture(figure, panels, theme);
}

function plotsPicture(figure: Figure, panels: readonly Panel[], theme: Theme): PiecesPicture {
  const {width = usualSize.width, height = usualSize.height} = figure;
  const anyColor = panels.some((panel) => panel.panel === "plot" && panel.color !== undefined);
  const sheet: Sheet = {width, height, aligned: figure.aligned === true, anyColor, theme};
  const layers: Layers[] = panels.flatMap((panel) => (panel.panel === "plot" ? [plotLayers(panel, panel.box ?? ([0, 0, width, height] as Box), sheet)] : []));
  return {
    kind: "pieces", width, height, back: layers.flatMap(({back}) => back), marks: layers.map(({marks}) => marks),
    front: [...figureTitle(figure.title ?? "", sheet), ...layers.flatMap(({front}) => front)],
  };
}
