import type {Wanted} from "../connection/connection";
import {axisOf, type AxisGroup, fanSamples, grouped, visible} from "./axis_group";
import {type Difference, difference, differenceText, readTolerance} from "./difference";
import type {Feed} from "./feed";
import {paintAgainst, paintOverTime, type Plane, type Stroke, xOf, yOf} from "./paint";
import {traceStyle} from "./palette";
import type {Pin} from "./pins";
import type {Plot, YAxis} from "./plot";
import {extent, type Samples} from "./samples";
import type {Shared} from "./shared";
import type {Trace} from "./trace";
import {joined, padded, type Range} from "./y_range";

/** What one scope draws, seen by what fills it. */
export interface Subject {
  traces: Trace[];
  feed: Feed;
  shared: Shared;
  groups: AxisGroup[];
}

/** What fills a scope: curves over time, one signal against another, or the difference to a pinned run. */
export interface Content {
  wanted(window: Range, isFollowing: boolean, pixels: number): Omit<Wanted, "columns">;
  /** Axes for what is visible at `at` [s of the page's clock]. */
  axes(window: Range, at: number): {x: Range; unitOfX: string; ys: YAxis[]};
  paint(plot: Plot, window: Range): void;
  /** A line below the plot. */
  note(): string;
}

const strokeOf = (subject: Subject, trace: Trace, ratio: number, alpha = 1): Stroke => ({...traceStyle(trace.style, subject.shared.colors), alpha, ratio});
const samplesOf = (subject: Subject, trace: Trace): Samples | undefined => subject.feed.samples.get(trace.column);

export class OverTime implements Content {
  constructor(private readonly subject: Subject) {}

  /** Looking back, half a window more on either side, so that there is something to see while it is moved. */
  wanted({low, high}: Range, isFollowing: boolean, pixels: number): Omit<Wanted, "columns"> {
    const width = high - low;
    if (isFollowing) return {follow: width, pixels};
    return {from: low - width / 2, to: high + width / 2, pixels: 2 * pixels};
  }

  axes(window: Range, at: number): {x: Range; unitOfX: string; ys: YAxis[]} {
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

  note(): string {
    const {fan} = this.subject.shared;
    return fan ? `behind: ${fan.points.length} runs with ${fan.name} from ${fan.points[0]?.value} to ${fan.points.at(-1)?.value} ${fan.unit}` : "";
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

/** All traces against the first one. */
export class Against implements Content {
  private x: Range = {low: 0, high: 1};

  constructor(private readonly subject: Subject) {}

  /** Four times as fine, so that short stretches come with every sample: extremes know no pairs. */
  wanted({low, high}: Range, isFollowing: boolean, pixels: number): Omit<Wanted, "columns"> {
    return isFollowing ? {follow: high - low, pixels: 4 * pixels} : {from: low, to: high, pixels: 4 * pixels};
  }

  axes(window: Range, at: number): {x: Range; unitOfX: string; ys: YAxis[]} {
    const {subject} = this, [first, ...others] = subject.traces;
    subject.groups = grouped(others, subject.groups);
    const ys = subject.groups.map((group) => axisOf(group, visible(group, (trace) => samplesOf(subject, trace), [], undefined, window), at));
    const samples = first && samplesOf(subject, first), [x] = grouped(first ? [first] : [], []);
    this.x = padded((samples && extent(samples, window)) ?? {low: 0, high: 1});
    if (!x) return {x: this.x, unitOfX: "", ys};
    x.range.choose(this.x);
    const axis = axisOf(x, undefined, at);
    return {x: axis.range, unitOfX: `${first.label} ${axis.unit}`, ys};
  }

  paint(plot: Plot, window: Range): void {
    const xs = this.subject.traces[0] && samplesOf(this.subject, this.subject.traces[0]);
    for (const group of xs ? this.subject.groups : []) {
      const plane = {...plot.box, x: this.x, y: group.range.now};
      for (const trace of group.traces) {
        const ys = samplesOf(this.subject, trace);
        if (ys && ys.time === xs!.time) paintAgainst(plot.context, xs!, ys, plane, strokeOf(this.subject, trace, plot.ratio), window);
      }
    }
  }

  note(): string {
    return this.subject.traces.length < 2 ? "against what? add a second signal" : "";
  }
}

/** Each trace minus itself in a pinned run. */
export class DifferenceTo implements Content {
  private readonly results = new Map<Trace, {difference: Difference; tolerance: number; of: Samples; text: string}>();

  constructor(private readonly subject: Subject, readonly pin: Pin, private readonly tolerance: () => string) {}

  /** Always the whole length of the pinned run, so that both have the same rows. */
  wanted(): Omit<Wanted, "columns"> {
    return {from: 0, to: this.pin.to, pixels: this.pin.pixels};
  }

  axes(window: Range, at: number): {x: Range; unitOfX: string; ys: YAxis[]} {
    const {subject} = this;
    subject.groups = grouped(subject.traces, subject.groups);
    for (const group of subject.groups) for (const trace of group.traces) this.compare(trace, group);
    return {x: window, unitOfX: "s", ys: subject.groups.map((group) => axisOf(group, this.extent(group, window), at))};
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

  note(): string {
    return this.subject.groups.flatMap((group) => group.traces.map((trace) => this.noteOf(trace, group))).join("; ");
  }

  private noteOf(trace: Trace, group: AxisGroup): string {
    const result = this.results.get(trace);
    return `${trace.label}: ${result ? differenceText(result.difference, result.tolerance, group.unit) : `is not in ${this.pin.label}`}`;
  }

  private compare(trace: Trace, group: AxisGroup): void {
    const now = samplesOf(this.subject, trace), before = this.pin.samples.get(trace.source), text = this.tolerance(), known = this.results.get(trace);
    if (!now || !before || (known?.of === now && known.text === text)) return;
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
