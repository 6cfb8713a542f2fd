import {type KeptLayout, type KeptWindow, keptTraces, tracesOf} from "./kept_layout";
import type {ScopeBoard} from "./scope_board";
import type {TimeWindow} from "./time_window";

/** Returns the layout of a board that is stored between visits. */
export function layoutOf({shared, scopes}: ScopeBoard): KeptLayout {
  const kept = scopes.map((scope) => ({title: scope.name, traces: keptTraces(scope.traces), against: scope.isAgainst || undefined, own: scope.own?.kept}));
  return {version: 1, scopes: kept, window: shared.window.kept, cursors: {a: shared.cursors.a, b: shared.cursors.b}};
}

/** Opens the scopes of a layout; their traces have no columns yet. */
export function restore(board: ScopeBoard, {scopes, window, cursors}: KeptLayout): void {
  put(window, board.shared.window);
  for (const kept of scopes) {
    const scope = board.open(kept.title);
    scope.replaceTraces(tracesOf(kept));
    if (kept.against) scope.fill("against");
    if (kept.own) put(kept.own, scope.takeOwnTime());
  }
  Object.assign(board.shared.cursors, cursors);
}

function put({width, from, to}: KeptWindow, window: TimeWindow): void {
  if (from === null || to === null) window.follow(width);
  else window.look({low: from, high: to});
}
