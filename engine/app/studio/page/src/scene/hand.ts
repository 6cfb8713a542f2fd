// Virtual hand: the position that the user demands, from any device, as samples of the run's inputs. Instants are seconds of the page's
// clock.

import type {Place, PointerInfo} from "./scene_info";

export interface Sample {
  time: number;
  name: string;
  values: number[];
}

export interface Bounds {
  x: readonly [number, number];
  y: readonly [number, number];
}

const within = (value: number, [low, high]: readonly [number, number]) => Math.min(Math.max(value, Math.min(low, high)), Math.max(low, high));
/** Limit of unsent samples; beyond it the oldest are dropped. */
const mostWaiting = 2000;

export class Hand {
  private waiting: Sample[] = [];
  private lastTime = -Infinity;
  private isHeld = false;
  at: Place | undefined;

  constructor(private readonly pointer: PointerInfo, private readonly bounds: Bounds) {}

  get held(): boolean {
    return this.isHeld;
  }

  /** Grips at a position. */
  take(time: number, at: Place): void {
    this.place(time, at);
    if (this.isHeld) return;
    this.isHeld = true;
    this.add(time, this.pointer.held, [1]);
  }

  /** Moves a gripping hand; otherwise the position has no effect on the run and is not sent. */
  move(time: number, at: Place): void {
    if (this.isHeld) this.place(time, at);
  }

  release(time: number): void {
    if (!this.isHeld) return;
    this.isHeld = false;
    this.add(time, this.pointer.held, [0]);
  }

  /** Returns the samples since the last call, in the order of time. */
  collect(): Sample[] {
    const samples = this.waiting;
    this.waiting = [];
    return samples;
  }

  private place(time: number, [x, y]: Place): void {
    this.at = [within(x, this.bounds.x), within(y, this.bounds.y)];
    this.add(time, this.pointer.name, [...this.at]);
  }

  /** Adds a sample. Times never decrease, whatever clock a device has. */
  private add(time: number, name: string, values: number[]): void {
    this.lastTime = Math.max(time, this.lastTime);
    this.waiting.push({time: this.lastTime, name, values});
    if (this.waiting.length > mostWaiting) this.waiting.splice(0, this.waiting.length - mostWaiting);
  }
}
