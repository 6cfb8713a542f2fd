import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import {decimalsOf, fixedText, numberText} from "./numbers";
import type {Plane} from "./paint";
import type {Range} from "./y_range";

/** Vertical axis; `range` is in the display unit. */
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

/** Fixed width of labels, so that changing numbers move nothing [px]. */
const axisWidth = 52, axisHeight = 22, widestLabel = 7;
/** Height of the units above the axes, and their distance from the topmost tick label. */
const unitHeight = 21, unitLift = 7;

/** Steps between ticks: 1, 2 and 5 times every power of ten. */
const steps = Array.from({length: 31}, (_, i) => i - 15).flatMap((power) => [1, 2, 5].map((digit) => Number(`${digit}e${power}`)));

const labels = (_: uPlot, splits: number[], __: number, ___: number, step: number) => splits.map((value) => labelText(value, step));

/** Formats with as many decimals as distinguish two ticks. */
export function labelText(value: number, step: number): string {
  const text = fixedText(value, decimalsOf(step));
  return text.length > widestLabel ? numberText(value, 4) : text;
}

/** Axes, grid and canvas of one scope; `paint` draws the content. */
export class Plot {
  private drawn: uPlot | undefined;
  private keys = "";
  private units: string[] = [];
  private size = {width: 320, height: 160};

  /** `paint` draws curves after the axes. `ready` receives each new layer over them, for marks and pointers. */
  constructor(private readonly host: HTMLElement, private look: Look, private readonly paint: (plot: Plot) => void,
    private readonly ready: (over: HTMLElement) => void) {}

  get context(): CanvasRenderingContext2D {
    return this.drawn!.ctx;
  }

  /** Canvas pixels per page pixel. */
  get ratio(): number {
    return this.drawn ? this.drawn.ctx.canvas.width / this.drawn.width : 1;
  }

  /** Rectangle within the axes, in canvas pixels. */
  get box(): Omit<Plane, "x" | "y"> {
    return this.drawn?.bbox ?? {left: 0, top: 0, ...this.size};
  }

  resize(width: number, height: number): void {
    if (width === this.size.width && height === this.size.height) return;
    this.size = {width, height};
    this.drawn?.setSize(this.size);
  }

  /** Redraws everything. It reserves space for axes on `sides` sides even without axes there, so that stacked plots are aligned. */
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
      axes: [this.axis("x", 0), ...axes.map(({key}, i) => this.axis(key, i + 1))], hooks: {drawClear: [({ctx}) => { ctx.direction = "ltr"; }], draw: [() => this.finish()]},  // an explicit direction avoids a style lookup per text
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

  /** Paints the curves, clipped to the axes, and the units at the ends of the axes. */
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
