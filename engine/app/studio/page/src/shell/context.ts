import type {Connection} from "../connection/connection";
import type {RunModel} from "../run/run_model";
import type {Workbench} from "../text/workbench";
import type {Settings} from "./settings";
import type {Shortcuts} from "./shortcuts";
import type {Theme} from "./theme";

/** Services of the page for its views. */
export interface Context {
  connection: Connection;
  run: RunModel;
  settings: Settings;
  shortcuts: Shortcuts;
  theme: Theme;
  /** Texts: open files, their edits, the selection. */
  workbench: Workbench;
  /** Announces a text to screen readers. */
  announce(text: string): void;
  /** Shows a sentence for a few seconds; faults remain until they are closed. */
  notify(text: string, kind?: "note" | "fault"): void;
  /** Brings a pane to the front: "text", "drawing", "scopes", "scene", "figures", "tuning". */
  show(pane: string): void;
}

/** Part of the page. */
export interface View {
  dispose(): void;
  /** Called when the pane is brought to the front, or leaves it. */
  shown?(isShown: boolean): void;
}
