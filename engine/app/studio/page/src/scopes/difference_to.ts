import type {Wanted} from "../connection/connection";
import {axisOf, type AxisGroup, grouped} from "./axis_group";
import {type Axes, type Content, type Curve, curveOver, samplesOf, strokeOf, type Subject} from "./content";
import {type Difference, difference, differenceText, readTolerance} from "./difference";
import {paintOverTime, type Plane, xOf, yOf} from "./paint";
import type {Pin} from "./pins";
import type {Plot, YAxis} from "./plot";
import {extent, type Samples} from "./samples";
import type {Trace} from "./trace";
import {joined, type Range} from "./y_range";

/** Converts an axis to differences: a difference of degrees Celsius is in kelvins. */
const withoutOffset = (axis: YAxis, offset: number): YAxis => ({...axis, range: {low: axis.range.low - offset, high: axis.range.high - offset}});

/** Scope content: each trace minus the same trace of a pinned run. */
export class DifferenceTo implements Content {
  private readonly results = new Map<Trace, {difference: Difference; tolerance: number; of: Samples; text: string}>();

  constructor(private readonly subject: Subject, readonly pin: Pin, private readonly tolerance: () => string) {}

  /** Requests the whole length of the pinned run, so that both have the same rows. */
  wanted(): Omit<Wanted, "columns"> {
    return {from: 0, to: this.pin.to, pixels: this.pin.pixels};
  }

  axes(window: Range, at: number): Axes {
    const {subject} = this;
    subject.groups = grouped(subject.traces, subject.groups);
    for (const group of subject.groups) for (const trace of group.traces) this.compare(trace, group);
    return {x: window, unitOfX: "s", ys: subject.groups.map((group) => withoutOffset(axisOf(group, this.extent(group, window), at), group.unit.offset))};
  }

  paint(plot: Plot, window: Range): void {
    for (const group of this.subject.groups) {
      const plane = {...plot.box, x: window, y: group.range.now};
      for (const trace of group.traces) {
        const result = this.results.get(trace);
        if (!result) continue;
        const stroke = strokeOf(this.subject, trace, plot.ratio);
        this.paintBounds(plot, plane, result.tolerance, stroke.color);
        paintOverTime(plot.context, result.difference.samples, plane, stroke);
      }
    }
  }

  curves(window: Range): Curve[] {
    return this.subject.groups.flatMap(({traces, unit}, axis) => traces.flatMap((trace) => {
      const result = this.results.get(trace);
      return result ? [curveOver(trace, axis, {...unit, offset: 0}, result.difference.samples, window)] : [];
    }));
  }

  note(): string {
    if (this.subject.feed.isOld) return "comparing …";
    return this.subject.groups.flatMap((group) => group.traces.map((trace) => this.noteOf(trace, group))).join("; ");
  }

  private noteOf(trace: Trace, group: AxisGroup): string {
    const result = this.results.get(trace);
    return `${trace.label}: ${result ? differenceText(result.difference, result.tolerance, group.unit) : `is not in ${this.pin.label}`}`;
  }

  private compare(trace: Trace, group: AxisGroup): void {
    const now = samplesOf(this.subject, trace), before = this.pin.samples.get(trace.source), text = this.tolerance(), known = this.results.get(trace);
    if (this.subject.feed.isOld || !now || !before || (known?.of === now && known.text === text)) return;
    const range = extent(before, {low: 0, high: this.pin.to}), span = range ? range.high - range.low : 0;
    const tolerance = readTolerance(text, group.unit, span) ?? 0;
    this.results.set(trace, {difference: difference(now, before, tolerance), tolerance, of: now, text});
  }

  private extent(group: AxisGroup, window: Range): Range | undefined {
    return group.traces.reduce<Range | undefined>((all, trace) => {
      const result = this.results.get(trace), own = result && extent(result.difference.samples, window);
      return own ? joined(joined(all, own), {low: -result.tolerance, high: result.tolerance}) : all;
    }, undefined);
  }

  private paintBounds(plot: Plot, plane: Plane, tolerance: number, color: string): void {
    const {context} = plot, top = yOf(plane, tolerance), bottom = yOf(plane, -tolerance);
    context.globalAlpha = 0.15;
    context.fillStyle = color;
    context.fillRect(xOf(plane, plane.x.low), top, plane.width, Math.max(1, bottom - top));
  }
}
