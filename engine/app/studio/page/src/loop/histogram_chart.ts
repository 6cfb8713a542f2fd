import {svg} from "../shell/dom";
import type {Histogram} from "./loop_news";
import {timeText} from "./time_text";

const width = 640, height = 220, left = 46, right = 26, top = 14, bottom = 34;

/** Returns the range of decades for histograms and a deadline, in log10 of s. */
export function decadesOf(histograms: Histogram[], deadline: number): [number, number] {
  const edges = histograms.flatMap((one) => (one.edges.length > 0 ? [one.edges[0], one.edges[one.edges.length - 1]] : [])).filter((edge) => edge > 0);
  const low = Math.floor(Math.log10(Math.min(...edges, deadline))), high = Math.ceil(Math.log10(Math.max(...edges, deadline)) + 1e-9);
  return [low, Math.max(high, low + 1)];
}

/** Chart of histograms with the deadline. Both axes are logarithmic, so that a single late tick is visible. */
export class HistogramChart {
  readonly element = svg("svg", {class: "loop-chart", viewBox: `0 0 ${width} ${height}`, role: "img"});

  show(named: [string, Histogram][], deadline: number): void {
    const histograms = named.map(([, one]) => one), [low, high] = decadesOf(histograms, deadline), most = Math.max(10, ...histograms.flatMap(({counts}) => counts));
    const x = (time: number) => left + ((Math.log10(Math.max(time, 10 ** low)) - low) / (high - low)) * (width - left - right);
    const rows = Math.ceil(Math.log10(most)), y = (count: number) => height - bottom - (Math.log10(1 + count) / Math.log10(1 + 10 ** rows)) * (height - top - bottom);
    this.element.replaceChildren(...this.grid(low, high, rows, x, y), ...named.map(([kind, one]) => svg("path", {class: `loop-bars loop-${kind}`, d: outline(one, x, y)})),
      svg("line", {class: "loop-deadline", x1: x(deadline), x2: x(deadline), y1: top, y2: height - bottom}),
      svg("text", {class: "loop-deadline-text", x: x(deadline) - 4, y: top + 10, "text-anchor": "end"}, `deadline ${timeText(deadline)}`));
    this.element.setAttribute("aria-label", named.map(([kind, {p50, p99, max, count}]) => `${kind}: median ${timeText(p50)}, 99 % below ${timeText(p99)}, at most ${timeText(max)}, of ${count}`).join("; "));
  }

  private grid(low: number, high: number, rows: number, x: (time: number) => number, y: (count: number) => number): SVGElement[] {
    const upright = Array.from({length: high - low + 1}, (_, i) => 10 ** (low + i)), level = Array.from({length: rows + 1}, (_, i) => 10 ** i);
    return [
      ...upright.flatMap((time, i) => [svg("line", {class: "loop-grid", x1: x(time), x2: x(time), y1: top, y2: height - bottom}), svg("text", {class: "loop-label", x: x(time), y: height - bottom + 14, "text-anchor": i === upright.length - 1 ? "end" : "middle"}, timeText(time))]),
      ...level.flatMap((count) => [svg("line", {class: "loop-grid", x1: left, x2: width - right, y1: y(count), y2: y(count)}), svg("text", {class: "loop-label", x: left - 4, y: y(count) + 4, "text-anchor": "end"}, count >= 1e6 ? `${count / 1e6} M` : count >= 1e3 ? `${count / 1e3} k` : String(count))]),
      svg("line", {class: "loop-axis", x1: left, x2: width - right, y1: height - bottom, y2: height - bottom}),
      svg("text", {class: "loop-label", x: (left + width - right) / 2, y: height - 4, "text-anchor": "middle"}, "time since the tick was due"),
    ];
  }
}

/** Returns the outline of a histogram as an SVG path. */
function outline({edges, counts}: Histogram, x: (time: number) => number, y: (count: number) => number): string {
  const points = counts.flatMap((count, i) => [`${x(edges[i]).toFixed(1)} ${y(count).toFixed(1)}`, `${x(edges[i + 1]).toFixed(1)} ${y(count).toFixed(1)}`]);
  return counts.length === 0 ? "" : `M${x(edges[0]).toFixed(1)} ${y(0)}L${points.join("L")}L${x(edges[edges.length - 1]).toFixed(1)} ${y(0)}Z`;
}
