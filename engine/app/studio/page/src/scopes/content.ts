import type {Wanted} from "../connection/connection";
import type {AxisGroup} from "./axis_group";
import type {Feed} from "./feed";
import type {Stroke} from "./paint";
import {traceStyle} from "./palette";
import type {Plot, YAxis} from "./plot";
import type {Samples} from "./samples";
import type {Shared} from "./shared";
import type {Trace} from "./trace";
import type {Range} from "./y_range";

/** What one scope draws, seen by what fills it. */
export interface Subject {
  traces: Trace[];
  feed: Feed;
  shared: Shared;
  groups: AxisGroup[];
}

export interface Axes {
  x: Range;
  unitOfX: string;
  ys: YAxis[];
}

/** What fills a scope: curves over time, one signal against another, or the difference to a pinned run. */
export interface Content {
  wanted(window: Range, isFollowing: boolean, pixels: number): Omit<Wanted, "columns">;
  /** Axes for what is visible at `at` [s of the page's clock]. */
  axes(window: Range, at: number): Axes;
  paint(plot: Plot, window: Range): void;
  /** A line below the plot. */
  note(): string;
}

export const strokeOf = (subject: Subject, trace: Trace, ratio: number, alpha = 1): Stroke =>
  ({...traceStyle(trace.style, subject.shared.colors), alpha, ratio});

export const samplesOf = (subject: Subject, trace: Trace): Samples | undefined => subject.feed.samples.get(trace.column);
