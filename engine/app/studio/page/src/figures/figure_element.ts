import {saveFile} from "../scopes/save_file";
import {h} from "../shell/dom";
import {paint} from "./canvas_painter";
import {light} from "./colors";
import {describe} from "./description";
import {graphElement, graphText} from "./graph_picture";
import {pictureOf, type PiecesPicture} from "./picture";
import {type Piece, pointCount} from "./pieces";
import {reflowed} from "./reflow";
import type {Figure} from "./spec";
import {pageElement, svgFile, SvgPainter} from "./svg_painter";

/** Number of points above which marks are painted on a canvas. */
const mostOfSvg = 20_000;
let count = 0;

/** Figure of the page. It is redrawn when its data, its space or the theme change. */
export class FigureElement {
  readonly element: HTMLElement;
  private readonly sheet = h("div", {class: "figure-sheet"});
  private readonly name: string;
  private readonly enlarge = h("button", {type: "button", class: "plain"}, "Enlarge");
  private readonly save = h("button", {type: "button", class: "plain"}, "Save SVG");
  private figure: Figure = {};
  private drawn = "";
  private painting: number | undefined;

  /** `enlarge` is the action of its button; undefined hides the button. */
  constructor(private readonly number: number, enlarge?: () => void) {
    this.name = `figure-${++count}`;
    this.element = h("figure", {class: "figure"}, this.sheet, h("div", {class: "figure-tools"}, enlarge ? this.enlarge : null, this.save));
    this.save.setAttribute("aria-label", `Save figure ${number} as an SVG file`);
    this.enlarge.setAttribute("aria-label", `Enlarge figure ${number}`);
    this.save.addEventListener("click", () => void this.export());
    if (enlarge) this.enlarge.addEventListener("click", enlarge);
  }

  /** Shows a figure; `room` and `tall` are the available width and height [px]. */
  show(figure: Figure, isDark: boolean, room: number, tall = Infinity): void {
    const key = JSON.stringify([figure, isDark, Math.round(room), Math.round(tall)]);
    if (key === this.drawn) return;
    [this.figure, this.drawn] = [figure, key];
    const picture = pictureOf(reflowed(figure, room, tall), isDark);
    this.sheet.setAttribute("role", "img");
    this.sheet.setAttribute("aria-label", `Figure ${this.number}: ${describe(figure)}`);
    this.sheet.classList.toggle("figure-mirrored", picture.kind === "graph" && isDark);
    if (picture.kind === "graph") void this.showGraph(picture.graph, key);
    else this.showPieces(picture, room);
  }

  dispose(): void {
    if (this.painting !== undefined) cancelAnimationFrame(this.painting);
  }

  private async showGraph(graph: Parameters<typeof graphElement>[0], key: string): Promise<void> {
    const drawn = await graphElement(graph).catch((thrown: unknown) => h("p", {class: "empty"}, String((thrown as Error).message ?? thrown)));
    if (key === this.drawn) this.sheet.replaceChildren(drawn);
  }

  private showPieces({width, height, back, marks, front}: PiecesPicture, room: number): void {
    const dense = marks.filter((pieces) => pointCount(pieces) > mostOfSvg), sparse = marks.filter((pieces) => !dense.includes(pieces));
    this.sheet.style.setProperty("--width", `${width}px`);
    this.sheet.style.setProperty("--ratio", `${width} / ${height}`);
    const layer = (pieces: Piece[], name: string) => this.layer(pieces, name, width, height);
    if (dense.length === 0) return this.sheet.replaceChildren(layer([...back, ...marks.flat(), ...front], "f"));
    const canvas = h("canvas", {"aria-hidden": true});
    this.sheet.replaceChildren(layer(back, "b"), canvas, layer([...sparse.flat(), ...front], "f"));
    this.paint(canvas, dense.flat(), width, height, Math.min(1, room / width));
  }

  private layer(pieces: readonly Piece[], name: string, width: number, height: number): SVGElement {
    return pageElement({
      name: "svg", attributes: {viewBox: `0 0 ${width} ${height}`, "aria-hidden": "true", "font-family": "Helvetica, Arial, sans-serif"},
      children: new SvgPainter(`${this.name}${name}`).paint(pieces),
    });
  }

  private paint(canvas: HTMLCanvasElement, pieces: readonly Piece[], width: number, height: number, shrunk: number): void {
    const scale = window.devicePixelRatio * shrunk, pen = canvas.getContext("2d");
    [canvas.width, canvas.height] = [Math.round(width * scale), Math.round(height * scale)];
    if (!pen) return;
    pen.scale(scale, scale);
    this.painting = requestAnimationFrame(() => paint(pen, pieces));
  }

  private async export(): Promise<void> {
    const picture = pictureOf(this.figure, false), title = this.figure.title || `figure ${this.number}`;
    const text = picture.kind === "graph" ? await graphText(picture.graph)
      : svgFile(picture.width, picture.height, light.paper, [...picture.back, ...picture.marks.flat(), ...picture.front], title);
    saveFile(`figure${this.number === 1 ? "" : `-${this.number}`}.svg`, "image/svg+xml", text);
  }
}
