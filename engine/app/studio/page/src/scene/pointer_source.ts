import {listen} from "../shell/dom";
import type {Hand} from "./hand";
import type {Place} from "./scene_info";

const seconds = (milliseconds: number) => milliseconds / 1000;

/** Input of a mouse, a pen or the first finger over the scene: it grips while a button is down, or if `stays` until the next click. */
export class PointerSource {
  private pointer: number | undefined;
  private readonly ends: (() => void)[];
  /** True if the hand grips without a button until a click releases it. */
  stays = false;

  constructor(private readonly canvas: HTMLElement, private readonly hand: () => Hand | undefined, private readonly placeOf: (x: number, y: number) => Place, private readonly flush: () => void) {
    // Browsers merge moves between pictures; raw updates arrive at the rate of the device.
    const raw = "onpointerrawupdate" in window ? "pointerrawupdate" : "pointermove";
    this.ends = [
      listen(canvas, "pointerdown", (event: PointerEvent) => this.press(event)), listen(canvas, raw, (event: PointerEvent) => this.move(event)),
      listen(canvas, "pointerup", (event: PointerEvent) => this.lift(event)), listen(canvas, "pointercancel", (event: PointerEvent) => this.lift(event, true)),
      listen(canvas, "lostpointercapture", (event: PointerEvent) => this.lift(event)), listen(canvas, "contextmenu", (event) => event.preventDefault()),
    ];
  }

  dispose(): void {
    for (const end of this.ends) end();
  }

  private press(event: PointerEvent): void {
    const hand = this.hand();
    if (!hand || event.button !== 0 || (this.pointer !== undefined && this.pointer !== event.pointerId)) return;
    if (this.stays && hand.held) hand.release(seconds(event.timeStamp));
    else {
      this.pointer = event.pointerId;
      this.canvas.setPointerCapture(event.pointerId);
      hand.take(seconds(event.timeStamp), this.placeOf(event.clientX, event.clientY));
    }
    this.flush();
  }

  private move(event: PointerEvent): void {
    const hand = this.hand();
    if (!hand?.held || (this.pointer !== undefined && event.pointerId !== this.pointer) || (this.pointer === undefined && !this.stays)) return;
    const gathered = event.getCoalescedEvents?.() ?? [];
    for (const {timeStamp, clientX, clientY} of gathered.length > 0 ? gathered : [event]) hand.move(seconds(timeStamp), this.placeOf(clientX, clientY));
    this.flush();
  }

  private lift(event: PointerEvent, isLost = false): void {
    if (event.pointerId !== this.pointer) return;
    this.pointer = undefined;
    if (!this.stays || isLost) this.hand()?.release(seconds(event.timeStamp));
    this.flush();
  }
}
