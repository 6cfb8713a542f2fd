import {type Connection, Fault, type Frame, type Wanted} from "../../../../engine/app/studio/page/src/connection/connection";
import type {Shape} from "./fake_run";

/** Connection to a FakeRun in a worker. As from a socket, frames have memory of another thread and arrive at the pace of its clock. */
export class FakeConnection implements Connection {
  private readonly worker = new Worker("fake_worker.js", {type: "module"});
  private readonly pending = new Map<number, {resolve: (value: any) => void; reject: (fault: Fault) => void}>();
  private readonly news = new Map<string, Set<(message: any) => void>>();
  private readonly views = new Map<number, (frame: Frame) => void>();
  private readonly wanted = new Map<number, Wanted>();
  private readonly arrived = new Map<number, Frame>();
  private isDue = false;
  private id = 0;
  readonly state = "open";

  constructor(shape: Shape) {
    this.worker.postMessage({shape});
    this.worker.onmessage = ({data}) => this.receive(data);
  }

  call<T>(name: string, args: object = {}): Promise<T> {
    if (name === "state.get") return Promise.resolve({state: JSON.parse(localStorage.getItem("state") ?? "null")} as T);
    if (name === "state.put") localStorage.setItem("state", JSON.stringify((args as any).state));
    if (name === "state.put") return Promise.resolve({} as T);
    const id = ++this.id;
    return new Promise((resolve, reject) => {
      this.pending.set(id, {resolve, reject});
      this.worker.postMessage({id, name, args});
    });
  }

  tell(): void {}

  on(news: string, listener: (message: any) => void): () => void {
    const own = this.news.get(news) ?? new Set();
    this.news.set(news, own.add(listener));
    return () => void own.delete(listener);
  }

  frames(view: number, listener: (frame: Frame) => void): () => void {
    this.views.set(view, listener);
    return () => void this.views.delete(view);
  }

  want(view: number, wanted: Wanted | null): void {
    if (wanted) this.wanted.set(view, wanted);
    else this.wanted.delete(view);
    if (this.isDue) return;
    this.isDue = true;
    queueMicrotask(() => {
      this.isDue = false;
      this.worker.postMessage({views: [...this.wanted].map(([number, one]) => ({view: number, ...one}))});
    });
  }

  private receive(data: any): void {
    if (data.frame) return this.receiveFrame(data.frame);
    if (data.news) return this.news.get(data.news)?.forEach((listener) => listener(data));
    const waiting = this.pending.get(data.id);
    this.pending.delete(data.id);
    if (data.fault) waiting?.reject(Fault.from(data.fault));
    else waiting?.resolve(data.result);
  }

  private receiveFrame(frame: Frame): void {
    if (this.arrived.size === 0) requestAnimationFrame(() => this.handOn());
    this.arrived.set(frame.view, frame);
  }

  private handOn(): void {
    const frames = [...this.arrived.values()];
    this.arrived.clear();
    for (const frame of frames) {
      this.views.get(frame.view)?.(frame);
      this.worker.postMessage({ack: frame.view});
    }
  }
}
