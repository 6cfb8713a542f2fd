import type {Loaded} from "../run/run_types";
import {layoutOf, restore} from "./board_layout";
import {type KeptLayout, type KeptScope, layoutOfAddress, readLayout} from "./kept_layout";
import {mostTraces} from "./palette";
import {resolveAgain} from "./resolve";
import type {ScopeBoard} from "./scope_board";
import {traceOf} from "./trace";

const usualWidth = 10;

/** What a reader would call the same scopes. */
const signed = (scopes: Pick<KeptScope, "title" | "traces">[]): string => JSON.stringify(scopes.map(({title, traces}) => [title, traces.map(({source}) => source)]));

/** Which scopes a board has after a load: those of the file, until a reader changes them; then those, also at the next visit. */
export class BoardFilling {
  private file: number | null = null;
  private ofFile = "";
  private isBusy = false;

  constructor(private readonly board: ScopeBoard) {}

  /** Notes for the next visit what a reader changed. */
  keep(): void {
    if (this.isBusy || this.file === null) return;
    const layout = layoutOf(this.board), isOwn = signed(layout.scopes) !== this.ofFile || layout.scopes.some(({against, own}) => against || own);
    this.board.shared.context.settings.set(this.key, isOwn ? layout : null);
  }

  async load(loaded: Loaded): Promise<void> {
    const {run} = this.board.shared.context, isAnother = run.file !== this.file, before = this.ofFile;
    const isUntouched = signed(layoutOf(this.board).scopes) === before;
    this.file = run.file;
    this.ofFile = signed(scopesOf(loaded));
    const kept = isAnother ? this.kept() : undefined;
    if (kept) this.restore(kept);
    else if (isAnother || (isUntouched && this.ofFile !== before)) return this.takeFile(loaded, isAnother);
    await this.resolveAll(loaded);
  }

  /** The scopes of the file, as if nothing had been changed. */
  reset(loaded: Loaded): void {
    this.takeFile(loaded, true);
    this.keep();
  }

  private get key(): string {
    return `scopes ${this.board.shared.context.workbench.nameOf(this.file ?? 0)}`;
  }

  /** What the address of the page asks for, else what was kept. */
  private kept(): KeptLayout | undefined {
    const ofAddress = layoutOfAddress(location.hash);
    if (ofAddress) history.replaceState(null, "", location.pathname);
    return ofAddress ?? readLayout(this.board.shared.context.settings.get<unknown>(this.key, null));
  }

  private takeFile({scopes, columns, stop}: Loaded, isAnother: boolean): void {
    this.isBusy = true;
    this.board.clear();
    if (isAnother) this.board.shared.window.follow(stop !== null && stop <= 2 * usualWidth ? stop : usualWidth);
    for (const {title, traces} of scopes) {
      const scope = this.board.open(title || traces[0]?.label);
      traces.slice(0, mostTraces).forEach((spec, i) => scope.add(traceOf(spec, columns, i)));
    }
    this.isBusy = false;
  }

  private restore(kept: KeptLayout): void {
    this.isBusy = true;
    this.board.clear();
    restore(this.board, kept);
    this.isBusy = false;
  }

  /** The same traces, with the columns of this load. */
  private async resolveAll({columns}: Loaded): Promise<void> {
    const {connection} = this.board.shared.context;
    await Promise.all(this.board.scopes.map(async (scope) =>
      scope.replaceTraces(await Promise.all(scope.traces.map((trace) => resolveAgain(trace, columns, connection))))));
  }
}

function scopesOf({scopes, columns}: Loaded): Pick<KeptScope, "title" | "traces">[] {
  return scopes.map(({title, traces}) => ({title: title || traces[0]?.label, traces: traces.slice(0, mostTraces).map((spec, i) => traceOf(spec, columns, i))}));
}
