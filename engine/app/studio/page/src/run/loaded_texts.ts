import type {Text} from "@codemirror/state";
import type {Context} from "../shell/context";

/**
 * Marks the run as stale while a text differs from the loaded one, until the edit is undone. A file that was opened after loading counts
 * once it is edited.
 */
export function followTexts({run, workbench, connection}: Context): void {
  const texts = new Map<number, Text | undefined>();
  const look = () => run.markStale(workbench.openDocuments.some(({file, state}) => texts.has(file) && !texts.get(file)?.eq(state.doc)));
  run.textsSent = () => workbench.whenSynced();
  run.on("loaded", () => {
    texts.clear();
    for (const {file, base} of workbench.openDocuments) texts.set(file, base);
    look();
  });
  workbench.on("changed", ({file}) => {
    texts.set(file, texts.get(file));
    look();
  });
  connection.on("connection", ({state}) => { if (state === "open") texts.clear(); });
}
