import {type Connection, Fault} from "../connection/connection";
import {Latency} from "./latency";
import {Listeners} from "./listeners";
import {RunClock} from "./run_clock";
import type {Fan, Loaded, RunNews, SetEcho, Verdict} from "./run_types";

export interface RunEvents {
  /** A diagram was loaded; its run is at time 0. */
  loaded: Loaded;
  state: RunNews;
  set: SetEcho;
  claims: Verdict[];
  fan: Fan;
  /** A call of the run failed. */
  fault: Fault;
  /** The text now differs from the loaded one, or no longer differs. */
  stale: boolean;
}

const rest: RunNews = {run: 0, state: "paused", time: 0, tick: 0, rate: 0, wanted: 1, missed: 0, compiled: false, fault: null};
const si = {text: "", scale: 1, offset: 0};
const seconds = () => performance.now() / 1000;

/** Run of the page, shared by all views: the loaded diagram, the state of the run, and its controls. */
export class RunModel {
  private readonly listeners = new Listeners<RunEvents>();
  private readonly ends: (() => void)[];
  readonly clock = new RunClock();
  readonly latency = new Latency();
  /** Columns that a fan records: those of the scopes. */
  fanColumns: () => number[] = () => [];
  /** Resolves when the server has the present texts. */
  textsSent?: () => Promise<unknown>;
  loaded: Loaded | null = null;
  file: number | null = null;
  news: RunNews = rest;
  /** Rate for `play`; 0: as fast as possible. */
  rate = 1;
  stale = false;
  /** True if the user is the hand of a scene, false for the file's own hand. */
  hasHand = true;

  constructor(private readonly connection: Connection) {
    this.ends = [
      connection.on("run", (news: RunNews) => this.take(news)),
      connection.on("set", (echo: SetEcho) => this.takeSet(echo)),
      connection.on("connection", ({state}) => { if (state === "open" && this.loaded) this.markStale(); }),
      connection.on("fault", (news: {news?: string}) => { if (news.news) this.listeners.emit("fault", Fault.from(news)); }),
      connection.on("claims", (news: {claims: Verdict[]}) => this.listeners.emit("claims", news.claims)),
    ];
  }

  on<Name extends keyof RunEvents>(name: Name, listener: (event: RunEvents[Name]) => void): () => void {
    return this.listeners.on(name, listener);
  }

  dispose(): void {
    for (const end of this.ends) end();
  }

  /** Returns the present time of the run [s]. */
  get time(): number {
    return this.clock.read(seconds());
  }

  /** Loads a file; rejects with the faults of its text. */
  async load(file: number): Promise<Loaded> {
    await this.textsSent?.();
    const loaded = await this.connection.call<Loaded>("run.load", {file, hand: this.hasHand});
    this.file = file;
    this.loaded = loaded;
    this.news = {...rest, run: loaded.run, wanted: this.rate};
    this.latency.forget();
    this.clock.observe(0, 0, seconds());
    this.clock.restart(0, seconds());
    this.markStale(false);
    this.listeners.emit("loaded", loaded);
    this.listeners.emit("state", this.news);
    return loaded;
  }

  /** Sets whether the text differs from the loaded one; the next start then loads it again. */
  markStale(stale = true): void {
    if (stale === this.stale) return;
    this.stale = stale;
    this.listeners.emit("stale", stale);
  }

  async play(rate = this.rate): Promise<void> {
    this.rate = rate;
    if ((await this.prepare()) !== "failed") await this.call("run.play", {rate});
  }

  /** Pauses and stores the run in a folder; resolves to its name, or to undefined on failure. */
  async keep(): Promise<string | undefined> {
    try {
      return (await this.connection.call<{folder: string}>("run.keep")).folder;
    } catch (thrown) {
      this.listeners.emit("fault", Fault.from(thrown));
      return undefined;
    }
  }

  async pause(): Promise<void> {
    await this.call("run.pause");
  }

  async toggle(): Promise<void> {
    await (this.news.state === "playing" ? this.pause() : this.play());
  }

  async tick(): Promise<void> {
    if ((await this.prepare()) !== "failed") await this.call("run.tick");
  }

  /** Restarts from time 0 with the present text. */
  async restart(): Promise<void> {
    if ((await this.prepare()) === "as it was") await this.call("run.restart");
  }

  /** Returns to an earlier time [s], from which the run can continue. */
  async seek(time: number): Promise<void> {
    await this.call("run.seek", {time: Math.max(0, time)});
  }

  /** Sets the rate, at once if the run is playing; 0: as fast as possible. */
  async setRate(rate: number): Promise<void> {
    this.rate = rate;
    if (this.news.state === "playing") await this.call("run.play", {rate});
    else this.listeners.emit("state", this.news);
  }

  /** Sets a parameter during the run: a text with its unit, or a number [SI]. Rejects with the reason of a refusal. */
  async set(name: string, value: string | number): Promise<SetEcho> {
    const acts = this.latency.sent(performance.now());
    const echo = await this.connection.call<SetEcho>("run.set", {name, value});
    acts(echo.tick * (this.loaded?.step ?? 0));
    this.takeSet(echo);
    return echo;
  }

  /** Runs the diagram with `count` values between `low` and `high` [SI] in the background. */
  async fan(name: string, low: number, high: number, count: number): Promise<Fan> {
    const columns = this.fanColumns(), unit = this.loaded?.parameters.find((one) => one.name === name)?.shown ?? si;
    const {points} = await this.connection.call<Pick<Fan, "points">>("fan", {name, low, high, count, columns});
    const fan = {name, unit, columns, points};
    this.listeners.emit("fan", fan);
    return fan;
  }

  clearFan(): void {
    this.listeners.emit("fan", {name: "", unit: si, columns: [], points: []});
  }

  /** Loads the text again if it differs from the loaded one. */
  private async prepare(): Promise<"as it was" | "loaded" | "failed"> {
    if (!this.stale || this.file === null) return "as it was";
    try {
      await this.load(this.file);
      return "loaded";
    } catch (thrown) {
      this.listeners.emit("fault", Fault.from(thrown));
      return "failed";
    }
  }

  private async call(name: string, args: object = {}): Promise<void> {
    try {
      await this.connection.call(name, args);
    } catch (thrown) {
      this.listeners.emit("fault", Fault.from(thrown));
    }
  }

  private take(news: RunNews): void {
    const now = seconds(), another = news.run !== this.news.run;
    this.news = news;
    this.clock.observe(news.time, news.state === "playing" ? news.rate : 0, now);
    if (another) {
      this.clock.restart(news.time, now);
      this.latency.forget();
    }
    this.listeners.emit("state", news);
  }

  private takeSet(echo: SetEcho): void {
    const parameter = this.loaded?.parameters.find((one) => one.name === echo.name);
    if (parameter && echo.value !== null) parameter.value = echo.value;
    this.listeners.emit("set", echo);
  }
}
