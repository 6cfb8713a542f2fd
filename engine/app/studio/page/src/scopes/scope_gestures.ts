import {zoomAxis} from "./axis_group";
import type {Gestured} from "./gestures";
import type {MarksLayer} from "./marks_layer";
import type {Scope} from "./scope";

/** Gestures on a scope. A scope without a time axis supports only zooming of its values. */
export class ScopeGestures implements Gestured {
  constructor(private readonly scope: Scope, private readonly marks: MarksLayer) {}

  zoom(factor: number, x: number): void {
    if (this.hasTime) this.scope.window.zoom(factor, this.marks.timeAt(x), this.scope.shared.now);
  }

  zoomUp(factor: number, share: number): void {
    for (const group of this.scope.groups) zoomAxis(group, factor, share);
    this.scope.shared.redraw();
  }

  pan(distance: number): void {
    if (this.hasTime) this.scope.window.pan(distance / this.marks.width, this.scope.shared.now);
  }

  hover(x: number | undefined): void {
    this.scope.shared.hover = x === undefined || !this.hasTime ? undefined : this.marks.timeAt(x);
    this.scope.shared.tick();
  }

  click(x: number, isSecond: boolean): void {
    this.scope.element.focus({preventScroll: true});
    this.drag(isSecond ? "b" : "a", x);
  }

  choosing(from?: number, to?: number): void {
    if (this.hasTime) this.marks.choose(from, to);
  }

  chose(from: number, to: number): void {
    const low = this.marks.timeAt(Math.min(from, to)), high = this.marks.timeAt(Math.max(from, to));
    if (this.hasTime) this.scope.window.look({low, high});
  }

  grab(x: number): "a" | "b" | undefined {
    return this.marks.markAt(x, this.scope.shared.cursors);
  }

  drag(mark: "a" | "b", x: number): void {
    const {cursors, context} = this.scope.shared;
    if (this.hasTime) cursors.put(mark, this.marks.timeAt(x), context.run.loaded?.step ?? 0);
  }

  reset(): void {
    for (const {range} of this.scope.groups) range.fit();
    this.scope.window.follow();
  }

  private get hasTime(): boolean {
    return !this.scope.isAgainst;
  }
}
