import type {Fan} from "../run/run_types";
import type {Context} from "../shell/context";
import type {Cursors} from "./cursors";
import type {Pins} from "./pins";
import type {Look} from "./plot";
import type {TimeWindow} from "./time_window";

/** What all scopes of a board have in common. */
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
  /** Where the pointer is over a scope [s]. */
  hover: number | undefined;
  /** Draws all scopes anew with the next picture of the screen. */
  redraw(): void;
  /** Brings marks and texts up to date, and what has moved. */
  tick(): void;
  /** Something changed that is kept between visits. */
  keep(): void;
}
