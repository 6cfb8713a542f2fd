import {ensureSyntaxTree, syntaxTree} from "@codemirror/language";
import type {EditorState} from "@codemirror/state";
import type {SyntaxNode} from "@lezer/common";

export interface Field {
  key: string;
  text: string;
  /** True for a single number or word, false for a list or mapping. */
  isScalar: boolean;
  from: number;
  to: number;
}

const mappings = new Set(["FlowMapping", "BlockMapping"]), scalars = new Set(["Literal", "QuotedLiteral"]);

/** Returns the value of a pair, without its key, colon, tag and anchor. */
function valueOf(pair: SyntaxNode): SyntaxNode | null {
  for (let node = pair.lastChild; node; node = node.prevSibling) if (![":", "?", "Key", "Comment", "Tag", "Anchor"].includes(node.name)) return node;
  return null;
}

function firstMapping(state: EditorState, from: number, to: number): SyntaxNode | null {
  let found: SyntaxNode | null = null;
  const tree = ensureSyntaxTree(state, to, 200) ?? syntaxTree(state);
  tree.iterate({from, to, enter: (node) => {
    if (found) return false;
    if (mappings.has(node.name) && node.from > from && node.to <= to + 1) found = node.node;
    return undefined;
  }});
  return found;
}

/** Returns the keys and values of the block whose text is in this range. */
export function fieldsOf(state: EditorState, from: number, to: number): Field[] {
  const mapping = firstMapping(state, from, to), fields: Field[] = [];
  for (let pair = mapping?.firstChild ?? null; pair; pair = pair.nextSibling) {
    const key = pair.getChild("Key"), value = pair.name === "Pair" ? valueOf(pair) : null;
    if (!key || !value) continue;
    fields.push({key: state.sliceDoc(key.from, key.to), text: state.sliceDoc(value.from, value.to), isScalar: scalars.has(value.name), from: value.from, to: value.to});
  }
  return fields;
}
