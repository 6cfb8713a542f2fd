import type {Connection} from "../connection/connection";
import type {RunModel} from "../run/run_model";
import type {Workbench} from "../text/workbench";
import type {Settings} from "./settings";
import type {Shortcuts} from "./shortcuts";
import type {Theme} from "./theme";

/** What every view of the page gets. */
export interface Context {
  connection: Connection;
  run: RunModel;
  settings: Settings;
  shortcuts: Shortcuts;
  theme: Theme;
  /** The texts: what is open, edits of them, selection. */
  workbench: Workbench;
  /** Says something to who does not see the page. */
  announce(text: string): void;
  /** Shows a sentence for a few seconds; faults stay until they are closed. */
  notify(text: string, kind?: "note" | "fault"): void;
  /** Brings a pane to the front: "text", "drawing", "scopes", "scene", "figures", "tuning". */
  show(pane: string): void;
}

/** A part of the page. */
export interface View {
  dispose(): void;
  /** The pane came to the front, or left it. */
  shown?(isShown: boolean): void;
}
