import {h, svg} from "../shell/dom";
import {shownOf} from "./display_unit";
import type {AxisGroup} from "./axis_group";
import {numberText} from "./numbers";
import {colorCount, traceStyle} from "./palette";
import type {Trace} from "./trace";
import type {Range} from "./y_range";

const indices = Array.from({length: colorCount}, (_, i) => `var(--trace-${i + 1})`);

/** Returns a short line in the style of a trace. */
export function swatch(style: number): SVGElement {
  const {color, dash} = traceStyle(style, indices);
  const line = svg("line", {x1: 0, y1: 5, x2: 18, y2: 5, stroke: "currentColor", "stroke-width": 2.5, "stroke-dasharray": dash.length > 0 ? "5 3" : undefined});
  const picture = svg("svg", {class: "swatch", width: 18, height: 10, viewBox: "0 0 18 10", "aria-hidden": "true"}, line);
  picture.style.setProperty("color", color);
  return picture;
}

/** Names and values of the traces of a scope. */
export class Legend {
  readonly element = h("ul", {class: "legend", "aria-label": "Signals"});
  private values = new Map<Trace, HTMLElement>();

  constructor(private readonly remove: (trace: Trace) => void) {}

  list(traces: Trace[]): void {
    this.values = new Map(traces.map((trace) => [trace, h("span", {class: "trace-value"})]));
    this.element.replaceChildren(...traces.map((trace) => this.entry(trace)));
  }

  /** Shows a value for each trace, or a range. */
  show(groups: AxisGroup[], valueOf: (trace: Trace) => Range | undefined): void {
    for (const {traces, unit} of groups) for (const trace of traces) this.put(trace, unit, valueOf(trace));
  }

  private put(trace: Trace, unit: AxisGroup["unit"], value: Range | undefined): void {
    const place = this.values.get(trace), text = value ? valueText(value, unit) : trace.column < 0 ? "not in this run" : "";
    if (place && place.textContent !== text) place.textContent = text;
  }

  private entry(trace: Trace): HTMLElement {
    const label = `Remove ${trace.label}`;
    return h("li", {class: "trace", title: trace.source}, swatch(trace.style), h("span", {class: "trace-name"}, trace.label), this.values.get(trace),
      h("button", {type: "button", class: "plain small", "aria-label": label, title: label, onclick: () => this.remove(trace)}, "×"));
  }
}

/** Formats "49.8 mm", or "1 … 3 mm" for a range. */
export function valueText({low, high}: Range, unit: AxisGroup["unit"]): string {
  const a = numberText(shownOf(low, unit), 4), b = numberText(shownOf(high, unit), 4), text = a === b ? a : `${a} … ${b}`;
  return unit.text === "" || unit.text === "1" ? text : `${text} ${unit.text}`;
}
