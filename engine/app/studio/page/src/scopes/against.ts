import type {Wanted} from "../connection/connection";
import {axisOf, grouped, visible} from "./axis_group";
import {type Axes, type Content, samplesOf, strokeOf, type Subject} from "./content";
import {paintAgainst} from "./paint";
import type {Plot} from "./plot";
import {extent} from "./samples";
import {padded, type Range} from "./y_range";

/** All traces against the first one. */
export class Against implements Content {
  private x: Range = {low: 0, high: 1};

  constructor(private readonly subject: Subject) {}

  /** Four times as fine, so that short stretches come with every sample: extremes know no pairs. */
  wanted({low, high}: Range, isFollowing: boolean, pixels: number): Omit<Wanted, "columns"> {
    return isFollowing ? {follow: high - low, pixels: 4 * pixels} : {from: low, to: high, pixels: 4 * pixels};
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
