import type {Answer, Graph, Order, Picture} from "./types";

/** How long an older sketch may go on beside a newer order before its worker is ended: it can loop for ever [ms]. */
const patience = 3000;

type Wish = {graph: Graph} & ({want: "sketch"; like: number} | {want: "best"} | {want: "text"});

/** Orders layouts of a worker, one after the other: a newer order ends an older one, whose promise gives null. */
export class Layouter {
  private worker: Worker | undefined;
  private nextId = 1;
  private readonly waiting = new Map<number, {order: Order; resolve: (answer: Answer | null) => void}>();
  private timer: number | undefined;

  constructor() {
    this.started();  // it loads and warms up before the first graph comes
  }

  /** A picture soon, close to an earlier one by its id (0 for none); null where a newer order came. Throws where there is none. */
  async sketch(graph: Graph, like: number): Promise<Picture | null> {
    return (await this.order({graph, want: "sketch", like}))?.picture ?? null;
  }

  /** The best picture that is found, which may take seconds. */
  async search(graph: Graph): Promise<Picture | null> {
    return (await this.order({graph, want: "best"}))?.picture ?? null;
  }

  /** The text of an SVG file. */
  async text(graph: Graph): Promise<string> {
    return (await this.order({graph, want: "text"}))?.text ?? "";
  }

  get isBusy(): boolean {
    return this.waiting.size > 0;
  }

  dispose(): void {
    clearTimeout(this.timer);
    this.worker?.terminate();
    for (const {resolve} of this.waiting.values()) resolve(null);
    this.waiting.clear();
  }

  private async order(wish: Wish): Promise<Answer | null> {
    this.stopSearch();
    const order = {id: this.nextId++, ...wish} as Order, hasOlder = this.waiting.size > 0;
    const answer = await new Promise<Answer | null>((resolve) => {
      this.waiting.set(order.id, {order, resolve});
      this.started().postMessage(order);
      if (hasOlder) this.watch();
    });
    if (answer?.fault) throw new Error(answer.fault);
    return answer?.stopped ? null : answer;
  }

  /** A search is of no use beside a newer order; the worker ends it before its next layout. */
  private stopSearch(): void {
    for (const [id, {order, resolve}] of this.waiting) {
      if (order.want !== "best") continue;
      this.waiting.delete(id);
      resolve(null);
    }
  }

  private started(): Worker {
    if (this.worker) return this.worker;
    this.worker = new Worker(new URL("./layout_worker.ts", import.meta.url), {type: "module", name: "layout"});
    this.worker.onmessage = ({data}: MessageEvent<Answer>) => this.take(data);
    return this.worker;
  }

  private take(answer: Answer): void {
    const waiting = this.waiting.get(answer.id);
    this.waiting.delete(answer.id);
    waiting?.resolve(answer);
    if (this.waiting.size < 2) {
      clearTimeout(this.timer);
      this.timer = undefined;
    }
  }

  private watch(): void {
    this.timer ??= window.setTimeout(() => this.restart(), patience);
  }

  /** Ends the worker with all that it does, and gives the newest order to another one. */
  private restart(): void {
    this.timer = undefined;
    this.worker?.terminate();
    this.worker = undefined;
    const all = [...this.waiting.entries()], newest = all.pop();
    for (const [id, {resolve}] of all) {
      this.waiting.delete(id);
      resolve(null);
    }
    if (newest) this.started().postMessage(newest[1].order);
  }
}

/** The drawing of a graph as the text of an SVG file, by a worker of its own that ends with it. */
export async function drawGraph(graph: unknown): Promise<string> {
  const layouter = new Layouter();
  try {
    return await layouter.text(graph as Graph);
  } finally {
    layouter.dispose();
  }
}
