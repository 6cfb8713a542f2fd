import type {Connection, Frame} from "../connection/connection";
import {expressionsOf, type Mechanism} from "./mechanism_model";

const view = 10_001; // numbers of the scopes are smaller
const window = {follow: 0.05, pixels: 2}; // the newest instant is enough

/** Newest values of all expressions of a mechanism during the run. */
export class MechanismFeed {
  private readonly columns = new Map<string, number>();
  private readonly end: () => void;
  private wanted: number[] = [];
  private isOver = false;

  constructor(private readonly connection: Connection, private readonly take: (values: Map<string, number>, time: number) => void) {
    this.end = connection.frames(view, (frame) => this.receive(frame));
  }

  /** Resolves the expressions to columns. Rejects with the fault of the first unknown one. */
  async follow(mechanism: Mechanism): Promise<void> {
    this.columns.clear();
    const found = await Promise.all(expressionsOf(mechanism).map(async (expression) => {
      const {column} = await this.connection.call<{column: number}>("scope.signal", {expression});
      return [expression, column] as const;
    }));
    for (const [expression, column] of found) this.columns.set(expression, column);
    this.wanted = [...new Set(this.columns.values())];
    this.want(true);
  }

  want(isSeen: boolean): void {
    const {wanted} = this;
    this.connection.want(view, isSeen && wanted.length > 0 && !this.isOver ? {columns: wanted, ...window} : null);
  }

  dispose(): void {
    this.isOver = true;
    this.want(false);
    this.end();
  }

  private receive({kind, time, columns, newest}: Frame): void {
    const last = time.length - 1;
    if (last < 0) return;
    const valueOf = (i: number) => (kind === "samples" ? columns[i][last] : 0.5 * (columns[2 * i][last] + columns[2 * i + 1][last]));
    const values = new Map<string, number>();
    for (const [expression, column] of this.columns) values.set(expression, valueOf(this.wanted.indexOf(column)));
    this.take(values, newest);
  }
}
