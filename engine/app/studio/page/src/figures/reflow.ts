import type {Box, Figure, Panel} from "./spec";

const least = 300; // px that a panel needs to be read
const lowest = 230; // px that its height needs
const close = 0.9; // a picture may be made this much smaller as it is

const columnsOf = (panels: readonly Panel[]): number => {
  const tops = new Map<number, number>();
  for (const {box} of panels) if (box) tops.set(Math.round(box[1]), (tops.get(Math.round(box[1])) ?? 0) + 1);
  return Math.max(1, ...tops.values());
};

type Placed = Extract<Panel, {panel: "plot"}>;

/** A panel at another place; its frame follows from it. */
function placedAt(panel: Panel, box: Box): Panel {
  const {frame: _, ...rest} = panel as Placed;
  return {...rest, box};
}

/**
 * The same panels in fewer and narrower columns where there is too little room, and less high where that makes them fit, so that their
 * letters stay as large [px].
 */
export function reflowed(figure: Figure, room: number, tall = Infinity): Figure {
  const {panels = [], width = 0} = figure;
  if (!(room > 0) || panels.length === 0 || panels.some((panel) => panel.panel !== "plot" || !panel.box)) return figure;
  return squeezed(room >= close * width ? figure : narrowed(figure, panels, room), tall);
}

function narrowed(figure: Figure, panels: Panel[], room: number): Figure {
  const columns = Math.min(columnsOf(panels), Math.max(1, Math.floor(room / least))), wide = Math.max(260, room / columns);
  let top = Math.min(...panels.map(({box}) => box![1])), high = 0;
  const placed = panels.map((panel, i): Panel => {
    if (i > 0 && i % columns === 0) [top, high] = [top + high, 0];
    const [, , oldWidth, oldHeight] = panel.box!, height = oldHeight * Math.min(1, Math.max(0.7, wide / oldWidth));
    high = Math.max(high, height);
    return placedAt(panel, [(i % columns) * wide, top, wide, height]);
  });
  return {...figure, width: columns * wide, height: top + high, panels: placed};
}

function squeezed(figure: Figure, tall: number): Figure {
  const {panels = [], height = 0} = figure, factor = Math.max(tall / height, lowest / Math.min(...panels.map(({box}) => box![3])));
  if (!(factor < close)) return figure;
  const placed = panels.map((panel) => { const [x, y, wide, high] = panel.box!; return placedAt(panel, [x, y * factor, wide, high * factor]); });
  return {...figure, height: height * factor, panels: placed};
}
