import type {Wanted} from "../connection/connection";
import {axisOf, fanSamples, grouped, visible} from "./axis_group";
import {type Axes, type Content, type Curve, curveOver, samplesOf, strokeOf, type Subject} from "./content";
import {shownOf} from "./display_unit";
import {numberText, quantityText} from "./numbers";
import {paintOverTime, type Plane} from "./paint";
import type {Plot} from "./plot";
import type {Trace} from "./trace";
import type {Range} from "./y_range";

/** Scope content: curves over time, with pinned runs and a fan behind them. */
export class OverTime implements Content {
  constructor(private readonly subject: Subject) {}

  /** Requests the window; when looking back half a window more on either side, so that panning shows data at once. */
  wanted({low, high}: Range, isFollowing: boolean, pixels: number): Omit<Wanted, "columns"> {
    const width = high - low;
    if (isFollowing) return {follow: width, pixels};
    return {from: low - width / 2, to: high + width / 2, pixels: 2 * pixels};
  }

  axes(window: Range, at: number): Axes {
    const {subject} = this, {pins, fan} = subject.shared;
    subject.groups = grouped(subject.traces, subject.groups);
    const ys = subject.groups.map((group) => axisOf(group, visible(group, (trace) => samplesOf(subject, trace), pins.all, fan, window), at));
    return {x: window, unitOfX: "s", ys};
  }

  paint(plot: Plot, window: Range): void {
    for (const group of this.subject.groups) {
      const plane = {...plot.box, x: window, y: group.range.now};
      for (const trace of group.traces) this.paintBehind(plot, plane, trace);
    }
    for (const group of this.subject.groups) {
      const plane = {...plot.box, x: window, y: group.range.now};
      for (const trace of group.traces) this.paintTrace(plot, plane, trace);
    }
  }

  curves(window: Range): Curve[] {
    return this.subject.groups.flatMap(({traces, unit}, axis) => traces.flatMap((trace) => {
      const samples = samplesOf(this.subject, trace);
      return samples ? [curveOver(trace, axis, unit, samples, window)] : [];
    }));
  }

  note(): string {
    const {fan} = this.subject.shared;
    if (!fan) return "";
    const shown = (value = NaN) => shownOf(value, fan.unit), from = numberText(shown(fan.points[0]?.value)), to = quantityText(shown(fan.points.at(-1)?.value), fan.unit.text);
    return `background: ${fan.points.length} runs with ${fan.name} from ${from} to ${to}`;
  }

  private paintBehind(plot: Plot, plane: Plane, trace: Trace): void {
    const {fan, pins} = this.subject.shared, {context, ratio} = plot;
    const curves = fan ? fanSamples(fan, trace.column) : [];
    curves.forEach((samples, i) => paintOverTime(context, samples, plane, strokeOf(this.subject, trace, ratio, 0.2 + (0.3 * i) / curves.length)));
    for (const pin of pins.all) {
      const samples = pin.samples.get(trace.source), stroke = strokeOf(this.subject, trace, ratio, 0.5);
      if (samples) paintOverTime(context, samples, plane, {...stroke, dash: [2, 2]});
    }
  }

  private paintTrace(plot: Plot, plane: Plane, trace: Trace): void {
    const samples = samplesOf(this.subject, trace);
    if (samples) paintOverTime(plot.context, samples, plane, strokeOf(this.subject, trace, plot.ratio));
  }
}
