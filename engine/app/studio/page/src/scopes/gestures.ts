import {listen} from "../shell/dom";

/** Receiver of gestures over a plot; positions and distances in px from its left, `share` of its height from below. */
export interface Gestured {
  zoom(factor: number, x: number): void;
  zoomUp(factor: number, share: number): void;
  pan(distance: number): void;
  hover(x: number | undefined): void;
  click(x: number, isSecond: boolean): void;
  choosing(from?: number, to?: number): void;
  chose(from: number, to: number): void;
  grab(x: number): "a" | "b" | undefined;
  drag(mark: "a" | "b", x: number): void;
  reset(): void;
}

interface Finger {
  x: number;
  y: number;
}

/** Movement below which a press is a click [px]. */
const still = 4, perWheel = 0.0015;

type Drag = {kind: "mark"; mark: "a" | "b"} | {kind: "choose"; from: number} | {kind: "pan"; last: number};

/**
 * Gesture recogniser of one layer. The wheel zooms time, Alt+wheel the values, Shift+wheel pans. Dragging selects; Alt+drag and the middle
 * button pan; two fingers zoom and pan.
 */
export class Gestures {
  private readonly fingers = new Map<number, Finger>();
  private drag: Drag | undefined;
  private tapped: Finger | undefined;

  constructor(private readonly over: HTMLElement, private readonly target: Gestured) {
    const on = (name: string, action: (event: any) => void) => listen(over, name, action, {passive: false});
    on("wheel", (event) => this.wheel(event));
    on("pointerdown", (event) => this.down(event));
    on("pointermove", (event) => this.move(event));
    on("pointerup", (event) => this.up(event));
    on("pointercancel", (event) => this.cancel(event));
    on("pointerleave", (event: PointerEvent) => { if (event.pointerType === "mouse") target.hover(undefined); });
    on("dblclick", () => target.reset());
  }

  private at(event: MouseEvent): Finger {
    const box = this.over.getBoundingClientRect();
    return {x: event.clientX - box.left, y: event.clientY - box.top};
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const {x, y} = this.at(event), lines = event.deltaMode === 1 ? 33 : 1;
    if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) this.target.pan((event.deltaX || event.deltaY) * lines);
    else if (event.altKey) this.target.zoomUp(Math.exp(event.deltaY * lines * perWheel), 1 - y / (this.over.clientHeight || 1));
    else this.target.zoom(Math.exp(event.deltaY * lines * perWheel), x);
  }

  private down(event: PointerEvent): void {
    const at = this.at(event);
    this.over.setPointerCapture(event.pointerId);
    if (event.pointerType === "touch") return this.touch(event.pointerId, at);
    const mark = this.target.grab(at.x);
    if (event.button === 1 || event.altKey) this.drag = {kind: "pan", last: at.x};
    else if (event.button === 0) this.drag = mark ? {kind: "mark", mark} : {kind: "choose", from: at.x};
    if (event.button === 1) event.preventDefault();
  }

  private move(event: PointerEvent): void {
    const at = this.at(event);
    if (this.fingers.has(event.pointerId)) return this.slide(event.pointerId, at);
    this.target.hover(at.x);
    if (this.drag?.kind === "mark") this.target.drag(this.drag.mark, at.x);
    if (this.drag?.kind === "choose" && Math.abs(at.x - this.drag.from) > still) this.target.choosing(this.drag.from, at.x);
    if (this.drag?.kind !== "pan") return;
    this.target.pan(this.drag.last - at.x);
    this.drag.last = at.x;
  }

  private up(event: PointerEvent): void {
    const at = this.at(event), drag = this.drag;
    if (this.fingers.has(event.pointerId)) return this.lift(event.pointerId);
    this.drag = undefined;
    this.target.choosing();
    if (drag?.kind !== "choose") return;
    if (Math.abs(at.x - drag.from) > still) this.target.chose(drag.from, at.x);
    else this.target.click(at.x, event.shiftKey);
  }

  private cancel(event: PointerEvent): void {
    this.fingers.delete(event.pointerId);
    this.tapped = this.drag = undefined;
    this.target.choosing();
  }

  private touch(id: number, at: Finger): void {
    this.fingers.set(id, at);
    this.tapped = this.fingers.size === 1 ? at : undefined;
  }

  /** Handles a finger movement: one finger moves the cursor; two pan and zoom time. */
  private slide(id: number, at: Finger): void {
    const before = [...this.fingers.values()], old = this.fingers.get(id)!;
    this.fingers.set(id, at);
    if (before.length === 1) {
      if (this.tapped && Math.hypot(at.x - this.tapped.x, at.y - this.tapped.y) > still) this.tapped = undefined;
      if (!this.tapped) this.target.drag("a", at.x);
      return;
    }
    const other = before.find((finger) => finger !== old)!;
    this.target.pan((old.x - at.x) / 2);
    const far = Math.abs(at.x - other.x), was = Math.abs(old.x - other.x);
    if (far > 10 && was > 10) this.target.zoom(was / far, (at.x + other.x) / 2);
  }

  private lift(id: number): void {
    const at = this.fingers.get(id)!;
    this.fingers.delete(id);
    if (this.tapped) this.target.click(at.x, false);
    this.tapped = undefined;
  }
}
