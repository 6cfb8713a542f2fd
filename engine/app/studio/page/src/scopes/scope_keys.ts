import {zoomAxis} from "./axis_group";
import type {Scope} from "./scope";

/**
 * Handles a key while a scope has the focus. Left and right move cursor A, with Shift cursor B, with Alt by one tick; up and down zoom
 * time, with Alt the values.
 */
export function pressed(event: KeyboardEvent, scope: Scope): void {
  if (event.ctrlKey || event.metaKey) return;
  const action = actionOf(event, scope);
  if (!action) return;
  event.preventDefault();
  action();
}

/** Factor of the range per key press. */
const nearer = 0.7;

function actionOf(event: KeyboardEvent, scope: Scope): (() => void) | undefined {
  const {window, shared} = scope, newest = shared.now;
  switch (event.key) {
    case "ArrowLeft": return () => move(scope, event, -1);
    case "ArrowRight": return () => move(scope, event, 1);
    case "ArrowUp": case "+": return () => (event.altKey ? zoomValues(scope, nearer) : window.zoom(nearer, center(scope), newest));
    case "ArrowDown": case "-": return () => (event.altKey ? zoomValues(scope, 1 / nearer) : window.zoom(1 / nearer, center(scope), newest));
    case "PageUp": return () => window.pan(-0.5, newest);
    case "PageDown": return () => window.pan(0.5, newest);
    case "Home": return () => shared.cursors.put(markOf(event), window.at(newest).low, stepOf(scope));
    case "End": return () => shared.cursors.put(markOf(event), Math.min(newest, window.at(newest).high), stepOf(scope));
    case "Escape": return () => shared.cursors.clear();
    default: return undefined;
  }
}

const stepOf = ({shared}: Scope) => shared.context.run.loaded?.step ?? 0;
const markOf = ({shiftKey}: KeyboardEvent) => (shiftKey ? "b" : "a");

/** Zooms the values about the middle. */
function zoomValues({groups, shared}: Scope, factor: number): void {
  for (const group of groups) zoomAxis(group, factor, 0.5);
  shared.redraw();
}

/** Returns the fixed point of a zoom: cursor A if it is visible, else the middle. */
function center({window, shared}: Scope): number {
  const {low, high} = window.at(shared.now), {a} = shared.cursors;
  return a !== undefined && a >= low && a <= high ? a : (low + high) / 2;
}

/** Moves a cursor by a hundredth of the window, or by a tick. */
function move(scope: Scope, event: KeyboardEvent, sign: number): void {
  const {window, shared} = scope, {low, high} = window.at(shared.now), step = stepOf(scope);
  const by = event.altKey ? step : Math.max(step, (high - low) / 100);
  shared.cursors.move(markOf(event), sign * by, step, Math.min(shared.now, (low + high) / 2));
}
