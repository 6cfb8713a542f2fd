import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import {decimalsOf, fixedText, numberText} from "./numbers";
import type {Plane} from "./paint";
import type {Range} from "./y_range";

/** A vertical axis: `range` in the unit that is shown. */
export interface YAxis {
  key: string;
  unit: string;
  range: Range;
}

export interface Look {
  ink: string;
  line: string;
  font: string;
}

/** Labels have this width, whatever the numbers, so that nothing jumps [px]. */
const axisWidth = 52, axisHeight = 22, widestLabel = 7;
/** Above the axes stand their units, clear of the half label of a tick at the upper end. */
const unitHeight = 21, unitLift = 7;

/** Steps between ticks: 1, 2 and 5 of every power of ten. */
const steps = Array.from({length: 31}, (_, i) => i - 15).flatMap((power) => [1, 2, 5].map((digit) => Number(`${digit}e${power}`)));

const labels = (_: uPlot, splits: number[], __: number, ___: number, step: number) => splits.map((value) => labelText(value, step));

/** As many decimals as tell two ticks apart. */
export function labelText(value: number, step: number): string {
  const text = fixedText(value, decimalsOf(step));
  return text.length > widestLabel ? numberText(value, 4) : text;
}

/** Axes, grid and canvas of one scope; what is drawn inside comes by `paint`. */
export class Plot {
  private drawn: uPlot | undefined;
  private keys = "";
  private units: string[] = [];
  private size = {width: 320, height: 160};

  /** `paint` draws curves, with the axes in place. `ready` gets each new layer over them, for marks and pointers. */
  constructor(private readonly host: HTMLElement, private look: Look, private readonly paint: (plot: Plot) => void,
    private readonly ready: (over: HTMLElement) => void) {}

  get context(): CanvasRenderingContext2D {
    return this.drawn!.ctx;
  }

  /** Pixels of the canvas in one of the page. */
  get ratio(): number {
    return this.drawn ? this.drawn.ctx.canvas.width / this.drawn.width : 1;
  }

  /** The rectangle inside of the axes, in pixels of the canvas. */
  get box(): Omit<Plane, "x" | "y"> {
    return this.drawn?.bbox ?? {left: 0, top: 0, ...this.size};
  }

  resize(width: number, height: number): void {
    if (width === this.size.width && height === this.size.height) return;
    this.size = {width, height};
    this.drawn?.setSize(this.size);
  }

  /** Draws all anew. Room for axes on `sides` sides is left even where this plot has fewer, so that plots below each other are in line. */
  draw(x: Range, axes: YAxis[], unitOfX: string, sides: number): void {
    const keys = JSON.stringify([sides, axes.map(({key}) => key)]);
    this.units = [unitOfX, ...axes.map(({unit}) => unit)];
    if (!this.drawn || keys !== this.keys) this.make(axes, sides);
    this.keys = keys;
    this.drawn!.batch(() => {
      this.drawn!.setScale("x", {min: x.low, max: x.high});
      for (const {key, range} of axes) this.drawn!.setScale(key, {min: range.low, max: range.high});
    });
  }

  relook(look: Look): void {
    this.look = look;
    this.keys = "";
  }

  dispose(): void {
    this.drawn?.destroy();
    this.drawn = undefined;
  }

  private make(axes: YAxis[], sides: number): void {
    this.dispose();
    const unranged = (_: uPlot, low: number | null, high: number | null): uPlot.Range.MinMax => [low ?? 0, high ?? 1];
    const scales = Object.fromEntries(axes.map(({key}) => [key, {auto: false, range: unranged}]));
    const pad = (side: number) => (axes.length > side ? 0 : sides > side ? axisWidth : 14);
    this.drawn = new uPlot({
      ...this.size, legend: {show: false}, cursor: {show: false}, select: {show: false, left: 0, top: 0, width: 0, height: 0},
      padding: [unitHeight, pad(1), 0, pad(0)], scales: {x: {time: false, auto: false, range: unranged}, ...scales}, series: [{}],
      axes: [this.axis("x", 0), ...axes.map(({key}, i) => this.axis(key, i + 1))], hooks: {drawClear: [({ctx}) => { ctx.direction = "ltr"; }], draw: [() => this.finish()]},  // a direction of its own spares each text a look at the page's styles
    }, [[0, 1]]);
    this.host.replaceChildren(this.drawn.root);
    this.ready(this.drawn.over);
  }

  private axis(scale: string, place: number): uPlot.Axis {
    const line = {show: place < 2, stroke: this.look.line, width: 1};
    return {
      scale, side: place === 0 ? 2 : place % 2 === 1 ? 3 : 1, size: place === 0 ? axisHeight : axisWidth, space: place === 0 ? 64 : 26, gap: 4,
      stroke: this.look.ink, font: this.look.font, values: labels, incrs: steps, grid: line, ticks: {...line, show: true, size: 4}, border: {show: place === 0, stroke: this.look.line, width: 1},
    };
  }

  /** Curves, inside of the axes only, and the units at the ends of the axes. */
  private finish(): void {
    const {ctx, bbox} = this.drawn!;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    this.paint(this);
    ctx.restore();
    this.paintUnits();
  }

  private paintUnits(): void {
    const {ctx, bbox} = this.drawn!, [x, ...ys] = this.units, {ratio} = this;
    ctx.save();
    ctx.fillStyle = this.look.ink;
    ctx.font = this.look.font.replace(/[\d.]+px/, (size) => `${parseFloat(size) * ratio}px`);
    ctx.textBaseline = "bottom";
    ys.slice(0, 2).forEach((unit, i) => {
      ctx.textAlign = i === 0 ? "right" : "left";
      ctx.fillText(unit, i === 0 ? bbox.left - 4 * ratio : bbox.left + bbox.width + 4 * ratio, bbox.top - unitLift * ratio);
    });
    ctx.textAlign = "right";
    ctx.fillText(x, bbox.left + bbox.width - 3 * ratio, bbox.top + bbox.height - 2 * ratio);
    ctx.restore();
  }
}
