import {svg} from "../shell/dom";
import type {Curve} from "./content";
import {shownOf} from "./display_unit";
import {decimalsOf, fixedText} from "./numbers";
import {traceStyle} from "./palette";
import type {Scope} from "./scope";
import type {Trace} from "./trace";
import type {Range} from "./y_range";

const size = {width: 800, height: 360}, frame = {left: 70, top: 34, width: 640, height: 276};

interface Axis {
  range: Range;
  position: (value: number) => number;
}

/** Returns about `count` ticks at multiples of 1, 2 or 5 times a power of ten. */
export function ticksOf({low, high}: Range, count: number): {values: number[]; step: number} {
  const rough = (high - low) / count, power = 10 ** Math.floor(Math.log10(rough)), share = rough / power;
  const step = power * (share > 5 ? 10 : share > 2 ? 5 : share > 1 ? 2 : 1), first = Math.ceil(low / step - 1e-9);
  const many = Math.floor(high / step + 1e-9) - first + 1;
  return {values: Array.from({length: Math.max(0, many)}, (_, i) => (first + i) * step), step};
}

/** Returns the picture of a scope as the content of a file. Texts are inserted as text, never as markup. */
export function scopeSvg({name, picture: {axes, curves}}: Pick<Scope, "name" | "picture">): string {
  const across = (value: number) => frame.left + ((value - axes.x.low) / (axes.x.high - axes.x.low)) * frame.width;
  const ups = axes.ys.map(({range: {low, high}}) => (value: number) => frame.top + frame.height - ((value - low) / (high - low)) * frame.height);
  const root = svg("svg", {xmlns: "http://www.w3.org/2000/svg", width: size.width, height: size.height, viewBox: `0 0 ${size.width} ${size.height}`,
    "font-family": "sans-serif", "font-size": 12, fill: "#222"}, svg("rect", {width: size.width, height: size.height, fill: "#fff"}));
  const clip = svg("clipPath", {id: "inside"}, svg("rect", {x: frame.left, y: frame.top, width: frame.width, height: frame.height}));
  const drawn = svg("g", {fill: "none", "stroke-linejoin": "bevel", "clip-path": "url(#inside)"},
    ...curves.map((curve) => path(curve, across, (value) => ups[curve.axis](shownOf(value, curve.unit)))));
  root.append(text(size.width / 2, 18, name, "middle"), ...axisBelow({range: axes.x, position: across}, axes.unitOfX),
    ...axes.ys.flatMap(({range, unit}, i) => axisBeside({range, position: ups[i]}, unit, i)), clip, drawn, ...names(curves.map(({trace}) => trace)));
  return new XMLSerializer().serializeToString(root);
}

/** Colours of the light theme, for print. */
const lightColors = ["#054cb4", "#d07b0d", "#00955c", "#a21478", "#7d4f00", "#3f3b2f"];

function text(x: number, y: number, content: string, anchor: "start" | "middle" | "end"): SVGTextElement {
  return svg("text", {x, y, "text-anchor": anchor, "paint-order": "stroke", stroke: "#fff", "stroke-width": 4}, content);
}

function line(x1: number, y1: number, x2: number, y2: number): SVGLineElement {
  return svg("line", {x1, y1, x2, y2, stroke: "#ddd"});
}

function axisBelow({range, position}: Axis, unit: string): SVGElement[] {
  const {values, step} = ticksOf(range, 8), bottom = frame.top + frame.height;
  const ticks = values.flatMap((value) => [line(position(value), frame.top, position(value), bottom), text(position(value), bottom + 16, fixedText(value, decimalsOf(step)), "middle")]);
  return [...ticks, text(frame.left + frame.width / 2, size.height - 14, unit === "s" ? "time [s]" : unit, "middle"),
    svg("rect", {x: frame.left, y: frame.top, width: frame.width, height: frame.height, fill: "none", stroke: "#888"})];
}

/** Returns the axis at the left or right. Further axes are omitted: their curves are drawn, and their numbers are in the CSV. */
function axisBeside({range, position}: Axis, unit: string, place: number): SVGElement[] {
  if (place > 1) return [];
  const {values, step} = ticksOf(range, 6), edge = place === 0 ? frame.left : frame.left + frame.width, away = place === 0 ? -6 : 6;
  const ticks = values.flatMap((value) => [
    ...(place === 0 ? [line(edge, position(value), edge + frame.width, position(value))] : []),
    text(edge + away, position(value) + 4, fixedText(value, decimalsOf(step)), place === 0 ? "end" : "start")]);
  return [...ticks, text(edge, frame.top - 6, unit, "middle")];
}

function path({trace, x, low, high}: Curve, across: (value: number) => number, up: (value: number) => number): SVGPathElement {
  const {color, dash} = traceStyle(trace.style, lightColors), points: string[] = [];
  for (let row = 0, pen = "M"; row < x.length; ++row) {
    const at = across(x[row]).toFixed(2), below = up(low[row]), above = up(high[row]);
    if (!Number.isNaN(below + above)) points.push(`${pen}${at} ${below.toFixed(2)}`, ...(low[row] === high[row] ? [] : [`L${at} ${above.toFixed(2)}`]));
    pen = Number.isNaN(below + above) ? "M" : "L";
  }
  return svg("path", {d: points.join(""), stroke: color, "stroke-width": low === high ? 1.5 : 1, "stroke-dasharray": dash.join(" ") || undefined});
}

function names(traces: Trace[]): SVGElement[] {
  return traces.flatMap((trace, i) => {
    const {color, dash} = traceStyle(trace.style, lightColors), x = frame.left + 8 + (i % 4) * 155, y = frame.top + 14 + Math.floor(i / 4) * 16;
    return [svg("line", {x1: x, y1: y - 4, x2: x + 18, y2: y - 4, stroke: color, "stroke-width": 2, "stroke-dasharray": dash.join(" ") || undefined}), text(x + 24, y, trace.label, "start")];
  });
}
