import {listen} from "../shell/dom";
import type {RunModel} from "./run_model";

/** Space plays and pauses also from a slider, which has no use of its own for it. */
export function toggleBySpace(slider: HTMLElement, run: RunModel): void {
  listen(slider, "keydown", (event: KeyboardEvent) => {
    if (event.key !== " ") return;
    event.preventDefault();
    void run.toggle();
  });
}
