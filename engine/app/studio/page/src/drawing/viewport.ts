// Zoom and pan of the drawing: wheel, drag, pinch, keys.

import {listen} from "../shell/dom";
import type {Box} from "./types";

/** Limits of the zoom. At `readable` the letters of blocks, of 13 pixels, are 10 pixels high. */
const least = 0.1, readable = 0.77, most = 4, margin = 12;

/** Returns the start of a view in a picture, along one axis: centred if all of it fits, else around a position within the picture. */
function placed(whole: number, seen: number, room: number, around?: number): number {
  if (around === undefined || whole <= seen - 2 * room) return (whole - seen) / 2;
  return Math.max(-room, Math.min(around - seen / 2, whole + room - seen));
}

export class Viewport {
  /** Screen pixels per pixel of the picture, and the position of the left upper corner in it. */
  private scale = 1;
  private x = 0;
  private y = 0;
  private picture = {width: 1, height: 1};
  /** Size of the host at the last layout; reading it from the page would force a new layout. */
  private size: {width: number; height: number};
  /** True until the user zooms or pans: the picture fills the pane. */
  private isFitted = true;
  private readonly pointers = new Map<number, {x: number; y: number}>();
  private readonly observer: ResizeObserver;

  constructor(private readonly host: HTMLElement, private readonly root: SVGSVGElement) {
    this.size = {width: host.clientWidth, height: host.clientHeight};
    this.observer = new ResizeObserver(([{contentRect}]) => {
      this.size = contentRect;
      if (this.isFitted) this.fit();
      else this.apply();
    });
    this.observer.observe(host);
    listen(host, "wheel", (event: WheelEvent) => this.wheel(event), {passive: false});
    listen(host, "pointerdown", (event: PointerEvent) => this.press(event));
    listen(host, "pointermove", (event: PointerEvent) => this.move(event));
    for (const name of ["pointerup", "pointercancel"]) listen(host, name, (event: PointerEvent) => this.pointers.delete(event.pointerId));
  }

  dispose(): void {
    this.observer.disconnect();
  }

  resize(width: number, height: number): void {
    this.picture = {width, height};
    if (this.isFitted) this.fit();
    else this.apply();
  }

  /** Shows the whole picture, only slightly enlarged at most. */
  fit(): void {
    this.isFitted = true;
    this.put(least);
  }

  /** Shows the whole picture; if its letters would be too small, only the surroundings of the block where signals start. */
  begin(start?: Box): void {
    this.isFitted = true;
    this.put(readable, start);
  }

  private put(smallest: number, start?: Box): void {
    const {width, height} = this.size;
    if (width === 0 || height === 0) return;
    const whole = Math.min((width - 2 * margin) / this.picture.width, (height - 2 * margin) / this.picture.height);
    this.scale = Math.min(1.25, Math.max(smallest, whole));
    if (whole < smallest) this.isFitted = false;
    this.x = placed(this.picture.width, width / this.scale, margin / this.scale, start && start.x);
    this.y = placed(this.picture.height, height / this.scale, margin / this.scale, start && start.y + start.height / 2);
    this.apply();
  }

  zoom(factor: number, clientX?: number, clientY?: number): void {
    const {left, top, width, height} = this.host.getBoundingClientRect();
    const u = clientX === undefined ? width / 2 : clientX - left, v = clientY === undefined ? height / 2 : clientY - top;
    const next = Math.min(most, Math.max(least, this.scale * factor));
    this.x += u / this.scale - u / next;
    this.y += v / this.scale - v / next;
    this.scale = next;
    this.isFitted = false;
    this.apply();
  }

  /** Pans by pixels of the screen. */
  pan(dx: number, dy: number): void {
    this.x += dx / this.scale;
    this.y += dy / this.scale;
    this.isFitted = false;
    this.apply();
  }

  /** Scrolls a box into view. */
  reveal({x, y, width, height}: Box): void {
    const seen = {width: this.size.width / this.scale, height: this.size.height / this.scale}, by = 20 / this.scale;
    const shift = (from: number, size: number, at: number, room: number) =>
      from < at ? from - by - at : from + size > at + room ? Math.min(from - by, from + size + by - room) - at : 0;
    const dx = shift(x, width, this.x, seen.width), dy = shift(y, height, this.y, seen.height);
    if (dx !== 0 || dy !== 0) this.pan(dx * this.scale, dy * this.scale);
  }

  /** Returns the position in the picture of a point of the window. */
  at(event: {clientX: number; clientY: number}): [number, number] {
    const {left, top} = this.host.getBoundingClientRect();
    return [this.x + (event.clientX - left) / this.scale, this.y + (event.clientY - top) / this.scale];
  }

  private apply(): void {
    const {width, height} = this.size;
    if (width > 0 && height > 0) this.root.setAttribute("viewBox", `${this.x} ${this.y} ${width / this.scale} ${height / this.scale}`);
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    if (event.shiftKey) return this.pan(event.deltaY || event.deltaX, 0);
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 20 : 1;
    this.zoom(Math.exp((-event.deltaY * lines) / (event.ctrlKey ? 100 : 400)), event.clientX, event.clientY);
  }

  private press(event: PointerEvent): void {
    if (event.button !== 0 && event.button !== 1) return;
    this.pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
  }

  private move(event: PointerEvent): void {
    const before = this.pointers.get(event.pointerId);
    if (!before || event.buttons === 0) return void this.pointers.delete(event.pointerId);
    const other = [...this.pointers].find(([id]) => id !== event.pointerId)?.[1], now = {x: event.clientX, y: event.clientY};
    this.pointers.set(event.pointerId, now);
    const share = other ? 0.5 : 1;
    this.pan(share * (before.x - now.x), share * (before.y - now.y));
    if (!other) return;
    const far = (one: {x: number; y: number}) => Math.hypot(one.x - other.x, one.y - other.y);
    this.zoom(far(now) / Math.max(1, far(before)), (now.x + other.x) / 2, (now.y + other.y) / 2);
  }
}
