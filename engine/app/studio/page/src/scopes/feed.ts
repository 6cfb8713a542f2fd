import type {Connection, Frame, Wanted} from "../connection/connection";
import {type Samples, samplesOf} from "./samples";

/** Number of view ids of scopes; an id is reused only after all others. */
const views = 9999;
let lastView = 0;

/** Minimum time between two requests [ms]; zooming would otherwise cause one per event. */
const between = 30;

/** Data of one scope from the server: the newest frame of its columns. */
export class Feed {
  private view = 0;
  private columns: number[] = [];
  private endListening = () => {};
  private wish = "";
  private due: Wanted | null = null;
  private pause = 0;
  private timer: number | undefined;
  private sentAt = -Infinity;
  /** Samples by column, SI. They remain until a frame with other columns arrives. */
  samples = new Map<number, Samples>();
  frame: Frame | undefined;
  /** True if the present data were requested before `renew`. */
  isOld = false;

  constructor(private readonly connection: Connection, private readonly arrived: () => void) {}

  /** Requests data of columns, with a pause between frames [ms]; null stops them. */
  want(wanted: Wanted | null, framePause = 0): void {
    const wish = wanted ? `${wanted.columns} ${wanted.from} ${wanted.to} ${wanted.follow} ${wanted.pixels} ${framePause}` : "";
    if (wish === this.wish) return;
    this.wish = wish;
    this.due = wanted;
    this.pause = framePause;
    const pause = between - (performance.now() - this.sentAt);
    if (!wanted || pause <= 0 || wanted.columns.join() !== this.columns.join()) this.send();
    else this.timer ??= window.setTimeout(() => this.send(), pause);
  }

  /** Ignores frames that are still on their way, before a different kind of request. */
  renew(): void {
    this.leave();
    this.wish = "";
    this.isOld = true;
  }

  stop(): void {
    this.want(null);
  }

  private send(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.sentAt = performance.now();
    if (!this.due) return this.leave();
    if (this.due.columns.join() !== this.columns.join()) this.enter(this.due.columns);
    this.connection.want(this.view, this.due, this.pause);
  }

  /** Uses a new view id for other columns, so that frames on their way are not mistaken for them. */
  private enter(columns: number[]): void {
    this.leave();
    this.columns = columns;
    this.view = (lastView = (lastView % views) + 1);
    this.endListening = this.connection.frames(this.view, (frame) => this.take(frame));
  }

  private leave(): void {
    if (this.view !== 0) this.connection.want(this.view, null);
    this.endListening();
    this.view = 0;
    this.columns = [];
  }

  private take(frame: Frame): void {
    this.frame = frame;
    this.isOld = false;
    const all = samplesOf(frame);
    this.samples = new Map(this.columns.map((column, i) => [column, all[i]]));
    this.arrived();
  }
}
