import type {Box, Figure, Panel} from "./spec";

const least = 300; // px width that a readable panel needs
const lowest = 230; // px height that a readable panel needs
const close = 0.9; // down to this share a picture is scaled instead of rearranged

const columnsOf = (panels: readonly Panel[]): number => {
  const tops = new Map<number, number>();
  for (const {box} of panels) if (box) tops.set(Math.round(box[1]), (tops.get(Math.round(box[1])) ?? 0) + 1);
  return Math.max(1, ...tops.values());
};

type Placed = Extract<Panel, {panel: "plot"}>;

/** Returns a panel in another box; its frame is computed again. */
function placedAt(panel: Panel, box: Box): Panel {
  const {frame: _, ...rest} = panel as Placed;
  return {...rest, box};
}

/** Arranges panels in fewer and narrower columns if there is too little space, and reduces their height if they then fit. Letters keep their size. */
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
