// Asks the server for the graph of what is drawn, one at a time, and the worker for its picture.

import {type Connection, Fault} from "../connection/connection";
import {Layouter} from "./layouter";
import type {Graph, Picture, TextRange} from "./types";

export interface Drawn {
  graph: Graph;
  ranges: Record<string, TextRange>;
}

export interface Shown {
  file: number;
  scope: string;
  open: string[];
  units: boolean;
}

/** A picture that was searched for replaces a quick one where it costs a reader so much less. */
const worthwhile = 0.85;
const idle = 1500;  // ms without another graph before the search begins, which takes a processor

export class GraphSource {
  private readonly layouter = new Layouter();
  private isAsking = false;
  private isDue = false;
  private latest = 0;
  private graph = "";
  private timer: number | undefined;
  /** The picture that is shown, to which the next one keeps. */
  private like = 0;
  /** Is it known that the search finds nothing much better for what is shown? */
  private isSettled = false;
  shown: Shown | undefined;

  constructor(private readonly connection: Connection, private readonly listener: {
    drawn: (drawn: Drawn) => void; picture: (picture: Picture) => void; fault: (fault: Fault) => void; busy: (isBusy: boolean) => void;
  }) {}

  dispose(): void {
    clearTimeout(this.timer);
    this.layouter.dispose();
  }

  /** Draws something else: nothing of the way of the last picture is kept. */
  show(shown: Shown): void {
    this.shown = shown;
    this.like = 0;
    this.graph = "";
    void this.refresh();
  }

  /** The texts may have changed. */
  async refresh(): Promise<void> {
    if (this.isAsking || !this.shown) return void (this.isDue = true);
    const {shown} = this;
    this.isAsking = true;
    this.isDue = false;
    try {
      const drawn = await this.connection.call<Drawn>("graph", {...shown});
      if (shown === this.shown) this.draw(drawn);
    } catch (thrown) {
      if (shown === this.shown) this.listener.fault(Fault.from(thrown));
    }
    this.isAsking = false;
    if (this.isDue) void this.refresh();
  }

  private draw(drawn: Drawn): void {
    const text = JSON.stringify(drawn.graph);
    this.listener.drawn(drawn);
    if (text === this.graph) return;
    this.graph = text;
    void this.layOut(drawn.graph);
  }

  private async layOut(graph: Graph): Promise<void> {
    const number = ++this.latest;
    clearTimeout(this.timer);
    this.listener.busy(true);
    try {
      const picture = await this.layouter.sketch(graph, this.like);
      if (!picture || number !== this.latest) return;
      this.isSettled &&= picture.isRelabeled;
      this.take(picture);
      if (!this.isSettled) this.timer = window.setTimeout(() => void this.search(graph, picture, number), idle);
    } catch (thrown) {
      this.listener.fault(new Fault(`the drawing cannot be laid out: ${Fault.from(thrown).message}`));
    } finally {
      if (number === this.latest) this.listener.busy(false);
    }
  }

  /** Looks for a better picture while nothing else is to do. */
  private async search(graph: Graph, quick: Picture, number: number): Promise<void> {
    const picture = await this.layouter.search(graph).catch(() => null);
    if (!picture || number !== this.latest) return;
    this.isSettled = true;
    if (picture.cost <= worthwhile * quick.cost) this.take(picture);
  }

  private take(picture: Picture): void {
    this.like = picture.id;
    this.listener.picture(picture);
  }
}
