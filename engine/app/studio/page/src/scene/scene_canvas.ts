import {paint} from "../figures/canvas_painter";
import {groundPiece, sceneHeight, shapePieces} from "../figures/scene_panel";
import type {Piece} from "../figures/pieces";
import type {Shape} from "../figures/spec";
import {h} from "../shell/dom";
import type {Place, SceneInfo} from "./scene_info";

const ring = {radius: 9, color: "#ffffff", edge: "#000000"}; // of the hand [px]

/** Canvas of a scene: as large as its host allows, with equal scales, and in the resolution of the screen. */
export class SceneCanvas {
  readonly element = h("canvas", {class: "scene-canvas", tabindex: 0, role: "application", "data-focus": true, "data-own-keys": "Left Right Up Down"});
  private width = 0; // px of the page
  private height = 0;
  private density = 1;

  constructor(private readonly host: HTMLElement, private info: SceneInfo) {}

  change(info: SceneInfo): void {
    this.info = info;
    this.fit();
  }

  /** Fits the canvas into its host. Returns true if its size has changed. */
  fit(): boolean {
    const room = {width: this.host.clientWidth, height: this.host.clientHeight}, ratio = sceneHeight(this.info, 1);
    const width = Math.max(1, Math.floor(Math.min(room.width, room.height / ratio))), density = window.devicePixelRatio || 1;
    if (width === this.width && density === this.density) return false;
    [this.width, this.height, this.density] = [width, Math.max(1, Math.round(width * ratio)), density];
    this.element.style.setProperty("width", `${this.width}px`);
    this.element.style.setProperty("height", `${this.height}px`);
    [this.element.width, this.element.height] = [Math.round(this.width * density), Math.round(this.height * density)];
    return true;
  }

  /** Converts a point of the page to a position in the scene [m]. */
  placeOf(x: number, y: number): Place {
    const {left, top, width, height} = this.element.getBoundingClientRect();
    return [this.info.x[0] + ((x - left) / width) * (this.info.x[1] - this.info.x[0]), this.info.y[1] - ((y - top) / height) * (this.info.y[1] - this.info.y[0])];
  }

  /** Draws the scene; `hand` is the position of the hand and that of the gripped object. */
  draw(shapes: readonly Shape[], hand: {at: Place; pulled: Place} | undefined): void {
    const pen = this.element.getContext("2d"), place = {left: 0, top: 0, scale: this.width / (this.info.x[1] - this.info.x[0])};
    if (!pen || this.width < 2) return;
    pen.setTransform(this.density, 0, 0, this.density, 0, 0);
    pen.clearRect(0, 0, this.width, this.height);
    paint(pen, [groundPiece(this.info, place), ...shapes.flatMap((shape) => shapePieces(shape, this.info, place)), ...this.handPieces(hand, place.scale)]);
  }

  /** Returns a ring at the hand and a band to the gripped object, visible on any background. A long band shows resistance. */
  private handPieces(hand: {at: Place; pulled: Place} | undefined, scale: number): Piece[] {
    if (!hand) return [];
    const [at, end] = [hand.at, hand.pulled].map(([x, y]) => [scale * (x - this.info.x[0]), scale * (this.info.y[1] - y)]), far = Math.hypot(at[0] - end[0], at[1] - end[1]);
    const start = [0, 1].map((i) => at[i] + ((end[i] - at[i]) * ring.radius) / Math.max(far, 1e-9)), band: Piece[] = far > 2 * ring.radius
      ? [{piece: "path", lines: [[...start, ...end]], stroke: {color: ring.color, width: 1.5, dash: [1, 5]}}] : [];
    return [...band, ...[3.5, 1.5].map((width, i): Piece => ({piece: "dots", at, radius: ring.radius, stroke: {color: i === 0 ? ring.edge : ring.color, width}}))];
  }
}
