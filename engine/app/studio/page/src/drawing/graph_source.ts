// Source of pictures: requests the graph from the server, one at a time, and its layout from the worker.

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

/** Limit for the cost of a searched picture, as a share of that of the quick one. Above it the quick one remains. */
const worthwhile = 0.85;
const idle = 1500;  // ms without a new graph before the search starts, which occupies a processor

export class GraphSource {
  private readonly layouter = new Layouter();
  private isAsking = false;
  private isDue = false;
  private latest = 0;
  private graph = "";
  private timer: number | undefined;
  /** Id of the displayed picture; the next layout stays close to it. */
  private like = 0;
  /** True if the search found no much better picture for the present graph. */
  private isSettled = false;
  shown: Shown | undefined;

  constructor(private readonly connection: Connection, private readonly listener: {
    drawn: (drawn: Drawn) => void; picture: (picture: Picture) => void; fault: (fault: Fault) => void; busy: (isBusy: boolean) => void;
  }) {}

  dispose(): void {
    clearTimeout(this.timer);
    this.layouter.dispose();
  }

  /** Shows another part; the next layout ignores the last picture. */
  show(shown: Shown): void {
    this.shown = shown;
    this.like = 0;
    this.graph = "";
    void this.refresh();
  }

  /** Requests the graph again, as the texts may have changed. */
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

  /** Searches a better picture while the page is idle. */
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
