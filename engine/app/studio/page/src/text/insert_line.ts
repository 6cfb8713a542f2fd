import {ensureSyntaxTree, syntaxTree} from "@codemirror/language";
import type {ChangeSpec, EditorState} from "@codemirror/state";
import type {SyntaxNode} from "@lezer/common";

/** The pair of a section of the file: `claims: ...`. */
function sectionOf(state: EditorState, name: string): SyntaxNode | null {
  const top = (ensureSyntaxTree(state, state.doc.length, 300) ?? syntaxTree(state)).topNode.getChild("Document")?.getChild("BlockMapping");
  for (let pair = top?.firstChild ?? null; pair; pair = pair.nextSibling) {
    const key = pair.getChild("Key");
    if (key && state.sliceDoc(key.from, key.to) === name) return pair;
  }
  return null;
}

/** An item more in a section that is a list or one mapping in braces; a section that is not there is begun at the end. */
export function insertedItem(state: EditorState, section: string, text: string): ChangeSpec {
  const pair = sectionOf(state, section), last = state.doc.line(state.doc.lines);
  if (!pair) return {from: state.doc.length, insert: `${last.length > 0 ? "\n" : ""}${section}:\n  - ${text}\n`};
  const list = pair.getChild("BlockSequence"), one = pair.getChild("FlowMapping");
  if (list) {
    const indent = list.from - state.doc.lineAt(list.from).from;
    return {from: list.to, insert: `\n${" ".repeat(indent)}- ${text}`};
  }
  if (one) return [{from: one.from, insert: "\n  - "}, {from: one.to, insert: `\n  - ${text}`}];
  throw new Error(`'${section}' is written in another way than as a list; the line would be: ${text}`);
}

/** A pair more, `NAME: text`, in a section that is a mapping of lines; a name that is taken gets a number. A section that is not there is begun at the end. */
export function insertedPair(state: EditorState, section: string, name: string, text: string): {changes: ChangeSpec; name: string} {
  const pair = sectionOf(state, section), last = state.doc.line(state.doc.lines), mapping = pair?.getChild("BlockMapping");
  if (!pair) return {name, changes: {from: state.doc.length, insert: `${last.length > 0 ? "\n" : ""}${section}:\n  ${name}: ${text}\n`}};
  if (!mapping) throw new Error(`'${section}' is written in another way than in lines; the line would be: ${name}: ${text}`);
  const keys = new Set(mapping.getChildren("Pair").flatMap((one) => one.getChildren("Key").map(({from, to}) => state.sliceDoc(from, to))));
  let free = name;
  for (let i = 2; keys.has(free); ++i) free = `${name}${i}`;
  const indent = mapping.from - state.doc.lineAt(mapping.from).from;
  return {name: free, changes: {from: mapping.to, insert: `\n${" ".repeat(indent)}${free}: ${text}`}};
}
