// Description of a figure in words, for screen readers.

import {labelOf, numberText} from "./axis";
import type {Axis, Figure, Mark, Named, Panel, Plot} from "./spec";

const names: Record<Mark["mark"], [one: string, several: string]> = {
  line: ["line", "lines"], band: ["band", "bands"], span: ["shaded range", "shaded ranges"], area: ["area", "areas"], points: ["set of points", "sets of points"],
  boxes: ["row of boxes", "rows of boxes"], rectangles: ["row of bars or cells", "rows of bars or cells"], image: ["map", "maps"],
  vectors: ["field of strokes", "fields of strokes"], surface: ["surface", "surfaces"],
};

function axisText(axis: Axis | undefined): string {
  if (!axis) return "";
  const label = labelOf(axis) || axis.named_ticks?.map((tick) => tick.label).join(", ") || "";
  return axis.range ? `${label} from ${numberText(axis.range[0])} to ${numberText(axis.range[1])}` : label;
}

function marksText(marks: readonly Mark[]): string {
  const counts = new Map<Mark["mark"], number>();
  for (const {mark} of marks) counts.set(mark, (counts.get(mark) ?? 0) + 1);
  return [...counts].map(([mark, count]) => `${count} ${names[mark][count === 1 ? 0 : 1]}`).join(", ");
}

function plotText(plot: Plot): string {
  const legend = (plot.marks ?? []).flatMap((mark) => ("legend" in mark && mark.legend ? [mark.legend] : []));
  const axes = [axisText(plot.y), axisText(plot.x)].filter(Boolean).join(" over ");
  const more = [plot.z && `upwards ${axisText(plot.z)}`, plot.color && `colour ${axisText(plot.color)}`, marksText(plot.marks ?? []), legend.length > 0 && `legend: ${legend.join(", ")}`];
  return [plot.title, axes, ...more].filter(Boolean).join("; ");
}

const namesIn = (parts: Named[] | undefined) => {
  const list = (parts ?? []).flatMap(({name, kind}) => name || kind?.replaceAll("_", " ") || []);
  return list.length > 0 ? `of ${list.join(", ")}` : "";
};

function panelText(panel: Panel): string {
  switch (panel.panel) {
    case "plot":
      return plotText(panel);
    case "table":
      return `table ${panel.title}: ${panel.rows.length} rows of ${panel.columns.join(", ")}`;
    case "scene":
      return `scene at ${panel.instants.length} instants: ${panel.instants.map(({words}) => words).filter(Boolean).join("; ")}`;
    case "diagram":
      return ["block diagram", panel.graph.title, namesIn(panel.graph.nodes)].filter(Boolean).join(" ");
    case "rig":
      return ["mechanism", panel.graph.title, namesIn(panel.graph.elements)].filter(Boolean).join(" ");
  }
}

/** Returns one sentence per panel. */
export function describe(figure: Figure): string {
  const panels = (figure.panels ?? []).map(panelText).filter(Boolean);
  return [figure.title, ...panels].filter(Boolean).join(". ") || "empty figure";
}
