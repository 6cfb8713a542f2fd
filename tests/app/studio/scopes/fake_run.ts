// Simulated server without an engine: many signals at a fixed step, one of which has a peak of a single sample.

import type {Frame} from "../../../../engine/app/studio/page/src/connection/frame";
import type {Loaded, RunNews} from "../../../../engine/app/studio/page/src/run/run_types";

/** Factor between levels of the pyramid, and number of levels. */
const factor = 4, levels = 7;

export interface Shape {
  signals: number;
  scopes: number;
  perScope: number;
  step: number;
  seconds: number;
}

export const spikeAt = 1.2345;

/** Returns signal `column` at a tick: a sine, noise from a hash, and in column 0 a spike of one sample. */
export function signal(column: number, tick: number, step: number, gain: number): number {
  const time = tick * step, noise = (((tick + 31 * column) * 2654435761) % 4294967296) / 4294967296 - 0.5;
  const spike = column === 0 && tick === Math.round(spikeAt / step) ? 0.05 : 0;
  return gain * (0.02 * Math.sin(2 * Math.PI * (0.2 + 0.13 * column) * time) + 0.002 * noise) + spike;
}

class Column {
  readonly low: Float64Array[];
  readonly high: Float64Array[];

  constructor(rows: number) {
    this.low = Array.from({length: levels}, (_, level) => new Float64Array(Math.ceil(rows / factor ** level) + 1).fill(Infinity));
    this.high = Array.from({length: levels}, (_, level) => new Float64Array(Math.ceil(rows / factor ** level) + 1).fill(-Infinity));
  }

  put(tick: number, value: number): void {
    for (let level = 0, row = tick; level < levels; ++level, row = Math.floor(row / factor)) {
      this.low[level][row] = level === 0 ? value : Math.min(this.low[level][row], value);
      this.high[level][row] = level === 0 ? value : Math.max(this.high[level][row], value);
    }
  }

  /** Removes all rows after a tick. */
  cut(tick: number): void {
    for (let level = 0; level < levels; ++level) {
      this.low[level].fill(Infinity, Math.ceil((tick + 1) / factor ** level));
      this.high[level].fill(-Infinity, Math.ceil((tick + 1) / factor ** level));
    }
  }
}

interface Wish {
  columns: number[];
  from?: number;
  to?: number;
  follow?: number | null;
  pixels: number;
}

export class FakeRun {
  readonly loaded: Loaded;
  private readonly columns: Column[];
  private tick = 0;
  private debt = 0;
  gain = 1;
  news: RunNews = {run: 1, state: "paused", time: 0, tick: 0, rate: 0, wanted: 1, missed: 0, compiled: false, fault: null};

  constructor(private readonly shape: Shape) {
    const {signals, scopes, perScope, step, seconds} = shape;
    this.columns = Array.from({length: signals}, () => new Column(Math.ceil(seconds / step) + 1));
    const name = (column: number) => (column === 0 ? "cart.position" : `rig.sensor[${column}]`);
    this.loaded = {
      run: 1, step, stop: seconds, scene: false, figures: 0, inputs: [], claims: [{that: "the cart stays within 60 mm"}, {that: "it comes to rest"}],
      columns: Array.from({length: signals}, (_, column) => ({column, name: name(column), unit: column % 5 === 4 ? "N" : "m", recorded: true})),
      parameters: [
        {name: "gain", text: "1", value: 1, unit: "1", shown: {text: "", scale: 1, offset: 0}, low: 0, high: 3, doc: "of all signals", block: false},
        {name: "mass", text: "2 kg", value: 2, unit: "kg", shown: {text: "kg", scale: 1, offset: 0}, low: null, high: null, doc: "of the cart", block: false},
        {name: "rig.offset", text: "10 mm", value: 0.01, unit: "m", shown: {text: "mm", scale: 1000, offset: 0}, low: -0.05, high: 0.05, doc: "of the pin from the middle", block: false},
        {name: "spring.gain", text: "200 N/m", value: 200, unit: "N/m", shown: {text: "N/m", scale: 1, offset: 0}, low: null, high: null, doc: "", block: true},
      ],
      scopes: Array.from({length: scopes}, (_, scope) => ({title: scope === 0 ? "Cart" : `Sensors ${scope}`, traces: Array.from({length: perScope}, (_, i) => {
        const column = scope * perScope + i, isForce = column % 5 === 4;
        return {column, label: name(column), unit: isForce ? "N" : "mm", scale: isForce ? 1 : 1000};
      })})),
    };
    this.put(0);
  }

  /** Advances the clock by some seconds. */
  advance(seconds: number): void {
    if (this.news.state !== "playing") return;
    this.debt += seconds * (this.news.wanted || 20);
    const ticks = Math.floor(this.debt / this.shape.step), last = Math.round(this.shape.seconds / this.shape.step);
    this.debt -= ticks * this.shape.step;
    const end = Math.min(last, this.tick + ticks);
    while (this.tick < end) this.put(++this.tick);
    this.stand({rate: this.news.wanted || 20, state: this.tick === last ? "ended" : "playing"});
  }

  call(name: string, args: any): unknown {
    switch (name) {
      case "run.load": this.restart(); return this.loaded;
      case "run.play": this.stand({state: "playing", wanted: args.rate}); return {};
      case "run.pause": this.stand({state: "paused", rate: 0}); return this.news;
      case "run.tick": this.put(++this.tick); this.stand({state: "paused"}); return this.news;
      case "run.restart": this.restart(); return this.news;
      case "run.seek": this.seek(args.time); return this.news;
      case "run.set": return this.set(args);
      case "scope.signal": return this.derived(args.expression);
      case "data.statistics": return {statistics: args.columns.map((column: number) => this.statistics(column, args.from, args.to))};
      case "data.export": return {csv: "time [s]\r\n0\r\n"};
      case "fan": return this.fan(args);
      default: throw {text: `there is no call '${name}'`};
    }
  }

  frame({columns, from = 0, to = 0, follow, pixels}: Wish, view: number, sequence: number): Frame {
    const {step} = this.shape, newest = this.tick * step, start = follow != null ? newest - follow : from, end = follow != null ? newest : to;
    const first = Math.max(0, Math.floor(start / step)), last = Math.min(this.tick, Math.ceil(end / step));
    let level = 0;
    while (level < levels - 1 && (last - first) / factor ** level > 2 * pixels) ++level;
    const size = factor ** level, rows = Math.max(0, Math.floor(last / size) - Math.floor(first / size) + 1), begin = Math.floor(first / size);
    const time = Float64Array.from({length: rows}, (_, i) => (level === 0 ? begin + i : (begin + i + 0.5) * size) * step);
    const values = columns.flatMap((column) => {
      const {low, high} = this.columns[column], own = low[level].slice(begin, begin + rows);
      return level === 0 ? [own] : [own, high[level].slice(begin, begin + rows)];
    });
    return {view, sequence, kind: level === 0 ? "samples" : "extremes", run: this.news.run, newest, time, columns: values};
  }

  private put(tick: number): void {
    for (let column = 0; column < this.columns.length; ++column) this.columns[column].put(tick, signal(column, tick, this.shape.step, this.gain));
  }

  private stand(news: Partial<RunNews>): void {
    this.news = {...this.news, tick: this.tick, time: this.tick * this.shape.step, ...news};
  }

  private restart(): void {
    this.tick = 0;
    for (const column of this.columns) column.cut(0);
    this.stand({run: this.news.run + 1, state: "paused", rate: 0});
  }

  private seek(time: number): void {
    const tick = Math.min(Math.round(time / this.shape.step), Math.round(this.shape.seconds / this.shape.step));
    for (const column of this.columns) column.cut(tick);
    while (this.tick < tick) this.put(++this.tick);
    this.tick = tick;
    this.stand({run: this.news.run + 1});
  }

  private set({name, value}: {name: string; value: string | number}): unknown {
    const parameter = this.loaded.parameters.find((one) => one.name === name)!, number = typeof value === "number" ? value : parseFloat(value);
    if (!Number.isFinite(number)) throw {text: `${name}: '${value}' is no quantity`, cure: `write a number with a unit, as ${parameter.text}`};
    if (parameter.high !== null && number > parameter.high) throw {text: `${name}: ${number} is above ${parameter.high}`};
    if (name === "gain") this.gain = number;
    return {name, value: number, text: String(value), tick: this.tick};
  }

  private derived(expression: string): unknown {
    const [, name, unit] = /^(\S+)(?: in (\S+))?$/.exec(expression) ?? [], known = this.loaded.columns.find((one) => one.name === name);
    if (!known) throw {text: `there is no signal '${expression}'`, cure: "the list has all"};
    return {column: known.column, name: expression, unit: unit ?? known.unit, scale: unit === "mm" ? 1000 : 1};
  }

  private statistics(column: number, from: number, to: number): unknown {
    const {step} = this.shape, a = Math.max(0, Math.round(from / step)), b = Math.min(this.tick, Math.round(to / step));
    const values = this.columns[column].low[0].subarray(a, b + 1), sum = (f: (value: number) => number) => values.reduce((all, value) => all + f(value), 0);
    const mean = sum((value) => value) / values.length;
    return {column, min: Math.min(...values), max: Math.max(...values), mean, rms: Math.sqrt(sum((value) => value * value) / values.length), slope: (values[values.length - 1] - values[0]) / (to - from || 1), first: values[0], last: values[values.length - 1]};
  }

  private fan({low, high, count, columns}: {low: number; high: number; count: number; columns: number[]}): unknown {
    const time = Array.from({length: 400}, (_, i) => (i / 400) * 10), {step} = this.shape;
    return {points: Array.from({length: count}, (_, k) => {
      const value = low + ((high - low) * k) / (count - 1);
      return {value, time, columns: columns.map((column) => time.map((at) => signal(column, Math.round(at / step), step, value)))};
    })};
  }
}
