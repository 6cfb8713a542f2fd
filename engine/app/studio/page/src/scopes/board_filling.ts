import type {Loaded} from "../run/run_types";
import {layoutOf, restore} from "./board_layout";
import {type KeptLayout, type KeptScope, layoutOfAddress, readLayout} from "./kept_layout";
import {mostTraces} from "./palette";
import {resolveAgain} from "./resolve";
import type {ScopeBoard} from "./scope_board";
import {traceOf} from "./trace";

const usualWidth = 10;

/** Returns a text that is equal for equivalent scopes. */
const signed = (scopes: Pick<KeptScope, "title" | "traces">[]): string => JSON.stringify(scopes.map(({title, traces}) => [title, traces.map(({source}) => source)]));

/** Choice of the scopes after a load: those of the file, or, once the user has changed them, the user's, also at the next visit. */
export class BoardFilling {
  private file: number | null = null;
  private ofFile = "";
  private isBusy = false;

  constructor(private readonly board: ScopeBoard) {}

  /** Stores the user's changes for the next visit. */
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

  /** Restores the scopes of the file. */
  reset(loaded: Loaded): void {
    this.takeFile(loaded, true);
    this.keep();
  }

  private get key(): string {
    return `scopes ${this.board.shared.context.workbench.nameOf(this.file ?? 0)}`;
  }

  /** Returns the layout in the page's address, else the stored one. */
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

  /** Sets the columns of this load in the same traces. */
  private async resolveAll({columns}: Loaded): Promise<void> {
    const {connection} = this.board.shared.context;
    await Promise.all(this.board.scopes.map(async (scope) =>
      scope.replaceTraces(await Promise.all(scope.traces.map((trace) => resolveAgain(trace, columns, connection))))));
  }
}

function scopesOf({scopes, columns}: Loaded): Pick<KeptScope, "title" | "traces">[] {
  return scopes.map(({title, traces}) => ({title: title || traces[0]?.label, traces: traces.slice(0, mostTraces).map((spec, i) => traceOf(spec, columns, i))}));
}
