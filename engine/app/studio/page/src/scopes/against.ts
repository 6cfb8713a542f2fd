import type {Wanted} from "../connection/connection";
import {axisOf, grouped, visible} from "./axis_group";
import {type Axes, type Content, type Curve, curveOver, samplesOf, strokeOf, type Subject} from "./content";
import {type DisplayUnit, shownOf} from "./display_unit";
import {dot, paintAgainst, type Plane, type Stroke, xOf, yOf} from "./paint";
import type {Plot} from "./plot";
import {extent, rowsWithin, type Samples} from "./samples";
import {padded, type Range} from "./y_range";

/** Requested pixels, each with two samples at most. */
const fine = 6000;

/** Scope content: all traces against the first one. */
export class Against implements Content {
  private x: Range = {low: 0, high: 1};
  private unit: DisplayUnit = {text: "", scale: 1, offset: 0};

  constructor(private readonly subject: Subject) {}

  /** Requests enough pixels for every sample of 10 s at 1 kHz, since pairs of values cannot be restored from extremes. */
  wanted({low, high}: Range, isFollowing: boolean): Omit<Wanted, "columns"> {
    return isFollowing ? {follow: high - low, pixels: fine} : {from: low, to: high, pixels: fine};
  }

  axes(window: Range, at: number): Axes {
    const {subject} = this, [first, ...others] = subject.traces;
    subject.groups = grouped(others, subject.groups);
    const ys = subject.groups.map((group) => axisOf(group, visible(group, (trace) => samplesOf(subject, trace), [], undefined, window), at));
    const samples = first && samplesOf(subject, first), [x] = grouped(first ? [first] : [], []);
    this.x = padded((samples && extent(samples, window)) ?? {low: 0, high: 1});
    if (!x) return {x: this.x, unitOfX: "", ys};
    x.range.choose(this.x);
    const axis = axisOf(x, undefined, at);
    this.unit = x.unit;
    return {x: axis.range, unitOfX: `${first.label} ${axis.unit}`, ys};
  }

  paint(plot: Plot, window: Range): void {
    const xs = this.subject.traces[0] && samplesOf(this.subject, this.subject.traces[0]);
    for (const group of xs ? this.subject.groups : []) {
      const plane = {...plot.box, x: this.x, y: group.range.now};
      for (const trace of group.traces) {
        const ys = samplesOf(this.subject, trace);
        if (ys && ys.time === xs!.time) this.paintTrace(plot, plane, xs!, ys, strokeOf(this.subject, trace, plot.ratio), window);
      }
    }
  }

  curves(window: Range): Curve[] {
    const xs = this.subject.traces[0] && samplesOf(this.subject, this.subject.traces[0]);
    if (!xs) return [];
    const {from, to} = rowsWithin(xs.time, window), x = xs.high.slice(from, to).map((value) => shownOf(value, this.unit));
    return this.subject.groups.flatMap(({traces, unit}, axis) => traces.flatMap((trace) => {
      const samples = samplesOf(this.subject, trace);
      return samples ? [{...curveOver(trace, axis, unit, samples, window), x}] : [];
    }));
  }

  /** Paints the curve, with a dot at its present end. */
  private paintTrace(plot: Plot, plane: Plane, xs: Samples, ys: Samples, stroke: Stroke, window: Range): void {
    const last = rowsWithin(xs.time, window).to - 1;
    paintAgainst(plot.context, xs, ys, plane, stroke, window);
    if (last >= 0) dot(plot.context, xOf(plane, xs.high[last]), yOf(plane, ys.high[last]), 3.5 * plot.ratio, stroke.color);
  }

  note(): string {
    return this.subject.traces.length < 2 ? "add a second signal for the other axis" : "";
  }
}
