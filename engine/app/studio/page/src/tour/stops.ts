/** Stop of the tour: its target, the pane that must be visible for it, and its text. */
export interface Stop {
  target: string;
  pane?: string;
  title: string;
  text: string;
}

export const stops: Stop[] = [
  {target: ".pane-text", pane: "text", title: "The diagram is text", text: "A line is a block: its name, its type, its numbers with units, and its sources. Faults are marked while you type, with a correction; Ctrl+Space completes, Ctrl+S saves."},
  {target: ".pane-drawing", pane: "drawing", title: "The drawing follows it", text: "Select a block and its text is selected, and the other way round. Drag from an output to an input to connect; I inserts a block. Each such edit is an edit of the text, so Ctrl+Z undoes it."},
  {target: ".bar-run", title: "Run it", text: "Play, pause (Space), one tick, slower or faster. Drag the bar to go back to any instant, and continue from there."},
  {target: ".pane-scopes", pane: "scopes", title: "Look at signals", text: "Wheel or drag to zoom while data flow; F follows the newest again. Two cursors give differences and statistics, and a line of “claims”."},
  {target: ".pane-tuning", pane: "tuning", title: "Change a number while it runs", text: "Each parameter is a slider. The run takes the value at its next tick; “write to text” makes it one edit of the file."},
  {target: ".pane-figures", pane: "figures", title: "See the result", text: "Figures are drawn as they will be in the report. Diagrams with a scene can be played by mouse, finger or gamepad: the resistance is seen, not felt."},
  {target: ".bar-end", title: "More", text: "Under ☰: examples and figures of the thesis to start from, this tour, licences, light and dark. The key ? lists all keys."},
];
