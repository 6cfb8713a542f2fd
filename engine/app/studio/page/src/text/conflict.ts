// Dialog for a file that was changed by another program during editing: both texts side by side, and a choice. Lines that only one of them
// has changed are merged before.

import {type Extension, RangeSetBuilder} from "@codemirror/state";
import {Decoration, EditorView} from "@codemirror/view";
import type {Context} from "../shell/context";
import {openDialog} from "../shell/dialog";
import {h} from "../shell/dom";
import {reading} from "./editor";
import {differentLines} from "./line_differences";
import type {Conflict} from "./saving";

/** Marks lines of a text by their indices. */
function marked(text: string, lines: Set<number>): Extension {
  const builder = new RangeSetBuilder<Decoration>();
  let from = 0;
  text.split("\n").forEach((line, i) => {
    if (lines.has(i)) builder.add(from, from, Decoration.line({class: "different"}));
    from += line.length + 1;
  });
  return EditorView.decorations.of(builder.finish());
}

/** Shows both texts; the user keeps or drops the own one. */
export function showConflict(context: Context, conflict: Conflict): void {
  const {document, text, hash} = conflict, own = document.state.doc.toString(), {ours, theirs} = differentLines(own.split("\n"), text.split("\n"));
  const holders = [h("div", {class: "side"}), h("div", {class: "side"})];
  const editors = [[own, ours, "Your text"], [text, theirs, "The file"]].map(([content, lines, title], i) =>
    new EditorView({parent: holders[i], doc: content as string, extensions: [reading(title as string), marked(content as string, lines as Set<number>)]}));
  const scrollers = editors.map(({scrollDOM}) => scrollDOM);
  scrollers.forEach((one, i) => one.addEventListener("scroll", () => { scrollers[1 - i].scrollTop = one.scrollTop; }));
  const {workbench, notify} = context;
  const overwrite = async () => { if (await workbench.saving.overwrite(document, text, hash)) notify(`${document.name} is saved with your text; undo restores the file's`); };
  openDialog(`${document.name} was changed by another program`, [
    h("p", {}, `${ours.size} of your lines and ${theirs.size} of the file's lines differ (marked). Nothing has been written.`),
    h("div", {class: "conflict"}, h("h3", {}, "Your text"), h("h3", {}, "The file as it is now"), ...holders),
  ], (close) => [
    h("button", {type: "button", onclick: close}, "Continue editing"),
    h("button", {type: "button", onclick: () => { close(); workbench.saving.takeText(document, text, hash); }}, "Use the file (undo restores yours)"),
    h("button", {type: "button", onclick: () => { close(); void overwrite().catch((fault) => notify(fault.message, "fault")); }}, "Overwrite with mine"),
    h("button", {type: "button", class: "main", autofocus: true, onclick: () => { close(); workbench.saving.takeBoth(document, conflict); }}, "Keep both: the file's lines as comments"),
  ], () => editors.forEach((editor) => editor.destroy()));
}
