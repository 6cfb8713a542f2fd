import {listen} from "../shell/dom";
import type {Hand} from "./hand";
import type {Place} from "./scene_info";

const arrows: Record<string, Place> = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
/** Speeds as shares of the view per second: usual, and with Shift. */
const speeds = {usual: 0.4, slow: 0.08};
const deadZone = 0.15, longestStep = 0.05; // s

export interface Steered {
  hand(): Hand | undefined;
  /** Start position of the hand. */
  start(): Place;
  /** Longer side of the view [m]. */
  span(): number;
  flush(): void;
}

/** Control of the hand's velocity by arrow keys and the stick of a gamepad; Esc or the second button releases. */
export class Steering {
  private readonly pressed = new Set<string>();
  private isSlow = false;
  private frame: number | undefined;
  private last = 0;
  private readonly ends: (() => void)[];

  constructor(canvas: HTMLElement, private readonly steered: Steered) {
    this.ends = [
      listen(canvas, "keydown", (event: KeyboardEvent) => this.press(event)), listen(canvas, "keyup", (event: KeyboardEvent) => this.lift(event)),
      listen(canvas, "blur", () => this.pressed.clear()), listen(window, "gamepadconnected", () => this.run()),
    ];
    if (this.pads().length > 0) this.run();
  }

  dispose(): void {
    for (const end of this.ends) end();
    if (this.frame !== undefined) cancelAnimationFrame(this.frame);
  }

  private pads(): Gamepad[] {
    return (navigator.getGamepads?.() ?? []).filter((pad): pad is Gamepad => pad !== null && pad.connected);
  }

  private press(event: KeyboardEvent): void {
    if (event.ctrlKey || event.altKey || event.metaKey || !this.steered.hand()) return;
    this.isSlow = event.shiftKey;
    if (event.key === "Escape" && this.steered.hand()?.held) this.release();
    else if (event.key in arrows) {
      this.pressed.add(event.key);
      this.run();
    } else return;
    event.preventDefault();
  }

  private lift(event: KeyboardEvent): void {
    this.isSlow = event.shiftKey;
    this.pressed.delete(event.key);
  }

  private release(): void {
    this.pressed.clear();
    this.steered.hand()?.release(performance.now() / 1000);
    this.steered.flush();
  }

  private run(): void {
    if (this.frame !== undefined) return;
    this.last = performance.now();
    this.frame = requestAnimationFrame((now) => this.step(now));
  }

  /** Returns the direction of keys and stick, each component from -1 to 1. */
  private direction(): Place {
    const sum: Place = [0, 0];
    for (const key of this.pressed) [sum[0], sum[1]] = [sum[0] + arrows[key][0], sum[1] + arrows[key][1]];
    for (const {axes, buttons} of document.hasFocus() ? this.pads() : []) {
      const [x = 0, y = 0] = axes;
      if (Math.hypot(x, y) > deadZone) [sum[0], sum[1]] = [sum[0] + x, sum[1] - y];
      if (buttons[1]?.pressed && this.steered.hand()?.held) this.release();
    }
    return sum;
  }

  private step(now: number): void {
    this.frame = undefined;
    const passed = Math.min((now - this.last) / 1000, longestStep), [dx, dy] = this.direction(), hand = this.steered.hand();
    this.last = now;
    if (hand && (dx !== 0 || dy !== 0)) {
      const [x, y] = (hand.held ? hand.at : undefined) ?? this.steered.start(), far = passed * this.steered.span() * (this.isSlow ? speeds.slow : speeds.usual);
      hand.take(now / 1000, [x + far * dx, y + far * dy]);
      this.steered.flush();
    }
    if (this.pressed.size > 0 || this.pads().length > 0) this.frame = requestAnimationFrame((at) => this.step(at));
  }
}
