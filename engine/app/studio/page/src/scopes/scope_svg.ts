import {svg} from "../shell/dom";
import {decimalsOf, fixedText} from "./numbers";
import {traceStyle} from "./palette";
import {isEvery, rowsWithin, type Samples} from "./samples";
import type {Scope} from "./scope";
import type {Range} from "./y_range";

const size = {width: 800, height: 360}, frame = {left: 70, top: 34, width: 640, height: 276};

interface Axis {
  range: Range;
  position: (value: number) => number;
}

/** Ticks of 1, 2 or 5 times a power of ten, about `count` of them. */
export function ticksOf({low, high}: Range, count: number): {values: number[]; step: number} {
  const rough = (high - low) / count, power = 10 ** Math.floor(Math.log10(rough)), share = rough / power;
  const step = power * (share > 5 ? 10 : share > 2 ? 5 : share > 1 ? 2 : 1), first = Math.ceil(low / step - 1e-9);
  const many = Math.floor(high / step + 1e-9) - first + 1;
  return {values: Array.from({length: Math.max(0, many)}, (_, i) => (first + i) * step), step};
}

/** The picture of a scope over time as a file of its own, as wide and high as the page's figures. Texts are text, never markup. */
export function scopeSvg(scope: Scope): string {
  const window = scope.window.at(scope.shared.now);
  const x: Axis = {range: window, position: (time) => frame.left + ((time - window.low) / (window.high - window.low)) * frame.width};
  const root = svg("svg", {xmlns: "http://www.w3.org/2000/svg", width: size.width, height: size.height, viewBox: `0 0 ${size.width} ${size.height}`,
    "font-family": "sans-serif", "font-size": 12, fill: "#222"}, svg("rect", {width: size.width, height: size.height, fill: "#fff"}));
  root.append(text(size.width / 2, 18, scope.name, "middle"), ...axisOfTime(x));
  const clip = svg("clipPath", {id: "inside"}, svg("rect", {x: frame.left, y: frame.top, width: frame.width, height: frame.height}));
  const curves = svg("g", {fill: "none", "stroke-linejoin": "bevel", "clip-path": "url(#inside)"});
  scope.groups.forEach((group, i) => {
    const {low, high} = group.range.now, y: Axis = {range: {low: low * group.unit.scale + group.unit.offset, high: high * group.unit.scale + group.unit.offset},
      position: (value) => frame.top + frame.height - ((value - low) / (high - low)) * frame.height};
    root.append(...axisOfValues(y, group.unit.text, i, (shown) => (shown - group.unit.offset) / group.unit.scale));
    for (const trace of group.traces) {
      const samples = scope.feed.samples.get(trace.column);
      if (samples) curves.append(curve(samples, window, x, y, traceStyle(trace.style, lightColors)));
    }
  });
  root.append(clip, curves, ...names(scope));
  return new XMLSerializer().serializeToString(root);
}

/** The colours of the light theme, in which pictures are printed. */
const lightColors = ["#054cb4", "#d07b0d", "#00955c", "#a21478", "#7d4f00", "#3f3b2f"];

function text(x: number, y: number, content: string, anchor: "start" | "middle" | "end"): SVGTextElement {
  return svg("text", {x, y, "text-anchor": anchor}, content);
}

function line(x1: number, y1: number, x2: number, y2: number): SVGLineElement {
  return svg("line", {x1, y1, x2, y2, stroke: "#ddd"});
}

function axisOfTime({range, position}: Axis): SVGElement[] {
  const {values, step} = ticksOf(range, 8), bottom = frame.top + frame.height;
  const ticks = values.flatMap((value) => [line(position(value), frame.top, position(value), bottom), text(position(value), bottom + 16, fixedText(value, decimalsOf(step)), "middle")]);
  return [...ticks, text(frame.left + frame.width / 2, size.height - 14, "time [s]", "middle"),
    svg("rect", {x: frame.left, y: frame.top, width: frame.width, height: frame.height, fill: "none", stroke: "#888"})];
}

/** Left, right, and further axes not at all: their curves are there, their numbers in the CSV. */
function axisOfValues({range, position}: Axis, unit: string, place: number, si: (shown: number) => number): SVGElement[] {
  if (place > 1) return [];
  const {values, step} = ticksOf(range, 6), edge = place === 0 ? frame.left : frame.left + frame.width, away = place === 0 ? -6 : 6;
  const anchor = place === 0 ? "end" : "start";
  const ticks = values.flatMap((value) => [
    ...(place === 0 ? [line(edge, position(si(value)), edge + frame.width, position(si(value)))] : []),
    text(edge + away, position(si(value)) + 4, fixedText(value, decimalsOf(step)), anchor)]);
  return [...ticks, text(edge, frame.top - 6, unit, "middle")];
}

function curve(samples: Samples, window: Range, x: Axis, y: Axis, style: {color: string; dash: number[]}): SVGPathElement {
  const {from, to} = rowsWithin(samples.time, window), points: string[] = [];
  let pen = "M";
  for (let row = from; row < to; ++row) {
    const at = x.position(samples.time[row]).toFixed(2), low = y.position(samples.low[row]), high = y.position(samples.high[row]);
    if (Number.isNaN(low + high)) pen = "M";
    else {
      points.push(`${pen}${at} ${low.toFixed(2)}`, ...(low === high ? [] : [`L${at} ${high.toFixed(2)}`]));
      pen = "L";
    }
  }
  return svg("path", {d: points.join(""), stroke: style.color, "stroke-width": isEvery(samples) ? 1.5 : 1, "stroke-dasharray": style.dash.join(" ") || undefined});
}

function names(scope: Scope): SVGElement[] {
  return scope.traces.flatMap((trace, i) => {
    const {color, dash} = traceStyle(trace.style, lightColors), x = frame.left + 8 + (i % 4) * 155, y = frame.top + 14 + Math.floor(i / 4) * 16;
    return [svg("line", {x1: x, y1: y - 4, x2: x + 18, y2: y - 4, stroke: color, "stroke-width": 2, "stroke-dasharray": dash.join(" ") || undefined}), text(x + 24, y, trace.label, "start")];
  });
}
