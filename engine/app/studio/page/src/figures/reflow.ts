import type {Box, Figure, Panel} from "./spec";

const least = 300; // px that a panel needs to be read
const close = 0.9; // a picture may be made this much smaller as it is

const columnsOf = (panels: readonly Panel[]): number => {
  const tops = new Map<number, number>();
  for (const {box} of panels) if (box) tops.set(Math.round(box[1]), (tops.get(Math.round(box[1])) ?? 0) + 1);
  return Math.max(1, ...tops.values());
};

/** The same panels in fewer and narrower columns where there is too little room, so that their letters stay as large [px]. */
export function reflowed(figure: Figure, room: number): Figure {
  const {panels = [], width = 0} = figure;
  if (!(room > 0) || room >= close * width || panels.some((panel) => panel.panel !== "plot" || !panel.box)) return figure;
  const columns = Math.min(columnsOf(panels), Math.max(1, Math.floor(room / least))), wide = Math.max(260, room / columns);
  let top = Math.min(...panels.map(({box}) => box![1])), high = 0;
  const placed = panels.map((panel, i): Panel => {
    if (i > 0 && i % columns === 0) [top, high] = [top + high, 0];
    const [, , oldWidth, oldHeight] = panel.box!, height = oldHeight * Math.min(1, Math.max(0.7, wide / oldWidth));
    high = Math.max(high, height);
    const {frame: _, ...rest} = panel as Extract<Panel, {panel: "plot"}>;
    return {...rest, box: [(i % columns) * wide, top, wide, height] as Box};
  });
  return {...figure, width: columns * wide, height: top + high, panels: placed};
}
