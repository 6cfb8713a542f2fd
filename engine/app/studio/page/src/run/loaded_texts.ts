import type {Text} from "@codemirror/state";
import type {Context} from "../shell/context";

/** Marks the run as stale while a text differs from the one that the run was loaded with: an edit that is undone leaves none. */
export function followTexts({run, workbench, connection}: Context): void {
  const texts = new Map<number, Text | "unknown">();
  const differs = () => workbench.openDocuments.some(({file, state}) => { const text = texts.get(file); return text === "unknown" || (text !== undefined && !state.doc.eq(text)); });
  run.textsSent = () => workbench.whenSynced();
  run.on("loaded", () => {
    texts.clear();
    for (const document of workbench.openDocuments) texts.set(document.file, document.base);
    run.markStale(differs());
  });
  workbench.on("changed", ({file}) => {
    if (!texts.has(file)) texts.set(file, "unknown");
    run.markStale(differs());
  });
  connection.on("connection", ({state}) => { if (state === "open") texts.clear(); });
}
