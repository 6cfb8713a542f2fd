import {openDialog} from "./dialog";
import {h} from "./dom";
import type {Shortcuts} from "./shortcuts";

const editorKeys: [string, string][] = [
  ["Ctrl+Z", "undo, also edits of the drawing"], ["Ctrl+Shift+Z", "redo"], ["Ctrl+F", "find"], ["Ctrl+Space", "complete"],
  ["F2", "rename everywhere"], ["F12", "go to the definition"], ["F8", "next fault"], ["Ctrl+.", "quick fixes of a fault"],
];

/** Shows all keys of the page, by group. */
export function showShortcuts(shortcuts: Shortcuts): void {
  const groups = new Map<string, [string, string][]>();
  for (const {group = "Page", key, text} of shortcuts.list()) groups.set(group, [...(groups.get(group) ?? []), [key, text]]);
  groups.set("Text", [...(groups.get("Text") ?? []), ...editorKeys]);
  const list = h("dl", {class: "keys"});
  for (const [group, keys] of groups) {
    list.append(h("h3", {}, group));
    for (const [key, text] of keys) list.append(h("dt", {}, ...(key === "+" ? ["+"] : key.split("+")).map((one) => h("kbd", {}, one || "+"))), h("dd", {}, text));
  }
  openDialog("Keys", [list]);
}
