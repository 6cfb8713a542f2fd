// WebSocket between page and server: calls with ids, news, data frames.

import {Fault} from "./fault";
import {Acknowledgements} from "./acknowledgements";
import {type Frame, readFrame} from "./frame";

export {Fault} from "./fault";
export type {DiagramFault} from "./fault";
export type {Frame} from "./frame";

/** Data request of a view: the newest `follow` seconds, or the range `from` to `to` [s]. */
export interface Wanted {
  columns: number[];
  from?: number;
  to?: number;
  follow?: number | null;
  pixels: number;
}

export type State = "open" | "lost";

export interface Connection {
  /** Makes a call; rejects with a Fault. */
  call<T>(name: string, args?: object): Promise<T>;
  /** Makes a call without an answer; does nothing while the connection is lost. */
  tell(name: string, args?: object): void;
  /** Adds a listener for news of the server; "connection" {state} is news of the connection itself. Returns a function that removes it. */
  on(news: string, listener: (message: any) => void): () => void;
  frames(view: number, listener: (frame: Frame) => void): () => void;
  /** Requests frames for a view, at least `pause` [ms] apart, or none for null. */
  want(view: number, wanted: Wanted | null, pause?: number): void;
  readonly state: State;
}

const protocol = 1;
/** Pauses between attempts to connect [ms]. */
const pauses = [250, 500, 1000, 2000];

interface Pending {
  resolve: (result: any) => void;
  reject: (fault: Fault) => void;
}

/** Listeners by the name of the news or the number of the view. */
class Listeners<Key, Message> {
  private readonly all = new Map<Key, Set<(message: Message) => void>>();

  add(key: Key, listener: (message: Message) => void): () => void {
    const own = this.all.get(key) ?? new Set();
    this.all.set(key, own.add(listener));
    return () => own.delete(listener);
  }

  notify(key: Key, message: Message): void {
    for (const listener of [...(this.all.get(key) ?? [])]) listener(message);
  }
}

export class SocketConnection implements Connection {
  private socket: WebSocket | undefined;
  private nextId = 1;
  private attempts = 0;
  private readonly pending = new Map<number, Pending>();
  private readonly news = new Listeners<string, any>();
  private readonly views = new Listeners<number, Frame>();
  private readonly wanted = new Map<number, Wanted>();
  private readonly arrived = new Map<number, Frame>();
  private readonly acknowledgements = new Acknowledgements((sequence) => this.send({ack: sequence}));
  private wantIsDue = false;
  state: State = "lost";

  constructor(private readonly address: string) {
    this.connect();
  }

  call<T>(name: string, args: object = {}): Promise<T> {
    if (this.state !== "open") return Promise.reject(new Fault("no connection to the studio", "reconnecting"));
    return this.request<T>(name, args);
  }

  tell(name: string, args: object = {}): void {
    if (this.state === "open") this.send({call: name, ...args});
  }

  on(news: string, listener: (message: any) => void): () => void {
    return this.news.add(news, listener);
  }

  frames(view: number, listener: (frame: Frame) => void): () => void {
    return this.views.add(view, listener);
  }

  want(view: number, wanted: Wanted | null, pause = 0): void {
    this.acknowledgements.pace(view, wanted ? pause : 0);
    if (wanted) this.wanted.set(view, wanted);
    else this.wanted.delete(view);
    if (this.wantIsDue) return;
    this.wantIsDue = true;
    queueMicrotask(() => this.sendWanted());
  }

  private connect(): void {
    const socket = new WebSocket(this.address);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => this.greet(socket);
    socket.onmessage = ({data}) => (typeof data === "string" ? this.receive(data) : this.receiveFrame(data));
    socket.onclose = () => this.lost();
    this.socket = socket;
  }

  private async greet(socket: WebSocket): Promise<void> {
    try {
      const hello = await this.request("hello", {protocol});
      this.attempts = 0;
      this.setState("open", hello);
      this.sendWanted();
    } catch (thrown) {
      this.news.notify("connection", {state: "lost", fault: Fault.from(thrown)});
      socket.close();
    }
  }

  private lost(): void {
    const fault = new Fault("connection to the studio lost", "reconnecting");
    for (const {reject} of this.pending.values()) reject(fault);
    this.pending.clear();
    this.arrived.clear();
    this.acknowledgements.forget();
    this.setState("lost");
    setTimeout(() => this.connect(), pauses[Math.min(this.attempts++, pauses.length - 1)]);
  }

  private setState(state: State, hello?: unknown): void {
    this.state = state;
    this.news.notify("connection", {state, hello});
  }

  private request<T>(name: string, args: object): Promise<T> {
    const id = this.nextId++;
    return new Promise<T>((resolve, reject) => {
      this.pending.set(id, {resolve, reject});
      this.send({id, call: name, ...args});
    });
  }

  private send(message: object): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message));
  }

  private receive(text: string): void {
    const message = JSON.parse(text);
    if (message.news !== undefined) return this.news.notify(message.news, message);
    const waiting = this.pending.get(message.id);
    this.pending.delete(message.id);
    if (message.fault) waiting?.reject(Fault.from(message.fault));
    else waiting?.resolve(message.result);
  }

  /** Passes on the newest frame of each view once per screen refresh, and acknowledges it only then. */
  private receiveFrame(message: ArrayBuffer): void {
    const frame = readFrame(message);
    if (this.arrived.size === 0) requestAnimationFrame(() => this.handOn());
    const older = this.arrived.get(frame.view);
    this.arrived.set(frame.view, frame);
    if (older) this.acknowledgements.add(older);
  }

  private handOn(): void {
    const frames = [...this.arrived.values()];
    this.arrived.clear();
    for (const frame of frames) {
      try {
        this.views.notify(frame.view, frame);
      } finally {
        this.acknowledgements.add(frame);
      }
    }
  }

  private sendWanted(): void {
    this.wantIsDue = false;
    if (this.state !== "open") return;
    const views = [...this.wanted].map(([view, wanted]) => ({view, ...wanted}));
    this.request("data.want", {views}).catch((fault) => this.news.notify("fault", fault));
  }
}

/** Connects to the server of this page. */
export function connect(): SocketConnection {
  return new SocketConnection(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/socket`);
}
