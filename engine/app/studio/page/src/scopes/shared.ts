import type {Fan} from "../run/run_types";
import type {Context} from "../shell/context";
import type {Cursors} from "./cursors";
import type {Pins} from "./pins";
import type {Look} from "./plot";
import type {TimeWindow} from "./time_window";

/** Shared state of all scopes of a board. */
export interface Shared {
  context: Context;
  cursors: Cursors;
  window: TimeWindow;
  pins: Pins;
  fan: Fan | undefined;
  colors: string[];
  look: Look;
  /** Sides on which any of the scopes has an axis: 1 or 2. */
  sides: number;
  /** Time of the run that is drawn now [s]. */
  now: number;
  /** Time under the pointer [s]. */
  hover: number | undefined;
  /** Redraws all scopes at the next screen refresh. */
  redraw(): void;
  /** Updates marks and texts, and redraws curves that have moved. */
  tick(): void;
  /** Stores changes for the next visit. */
  keep(): void;
}
