import type {Answer, Graph, Order, Picture} from "./types";

/** Time that an older sketch may run beside a newer order before its worker is terminated [ms]; elk may loop for ever. */
const patience = 3000;

type Wish = {graph: Graph} & ({want: "sketch"; like: number} | {want: "best"} | {want: "text"});

/** Queue of layout orders for a worker. A newer order ends an older one, whose promise resolves to null. */
export class Layouter {
  private worker: Worker | undefined;
  private nextId = 1;
  private readonly waiting = new Map<number, {order: Order; resolve: (answer: Answer | null) => void}>();
  private timer: number | undefined;

  constructor() {
    this.started();  // starts loading and warming up before the first graph arrives
  }

  /** Returns a quick picture that is similar to an earlier one (id 0: none); null if a newer order arrived. Throws if the layout fails. */
  async sketch(graph: Graph, like: number): Promise<Picture | null> {
    return (await this.order({graph, want: "sketch", like}))?.picture ?? null;
  }

  /** Returns the best picture of a search, which may take seconds. */
  async search(graph: Graph): Promise<Picture | null> {
    return (await this.order({graph, want: "best"}))?.picture ?? null;
  }

  /** Returns the text of an SVG file. */
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

  /** Ends a search in favour of a newer order; the worker stops before its next layout. */
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

  /** Terminates the worker, and passes the newest order to a new one. */
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

/** Draws a graph as the text of an SVG file, in a worker of its own. */
export async function drawGraph(graph: unknown): Promise<string> {
  const layouter = new Layouter();
  try {
    return await layouter.text(graph as Graph);
  } finally {
    layouter.dispose();
  }
}
