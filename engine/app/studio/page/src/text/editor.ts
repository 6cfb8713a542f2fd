// Extensions of an editor for diagrams, for any file.

import {autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap} from "@codemirror/autocomplete";
import {defaultKeymap, history, historyKeymap} from "@codemirror/commands";
import {yaml} from "@codemirror/lang-yaml";
import {bracketMatching, foldGutter, foldKeymap, indentOnInput, indentUnit} from "@codemirror/language";
import {lintGutter, lintKeymap, nextDiagnostic} from "@codemirror/lint";
import {highlightSelectionMatches, searchKeymap} from "@codemirror/search";
import {EditorState, type Extension} from "@codemirror/state";
import {drawSelection, EditorView, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers, rectangularSelection} from "@codemirror/view";
import {appearance} from "./theme";

/** Returns the style nonce that the server has put into the page. */
export const nonced = () => EditorView.cspNonce.of(document.querySelector<HTMLMetaElement>("meta[name=style-nonce]")?.nonce ?? "");

export function editing(title: string, isWritable: boolean): Extension {
  return [
    nonced(), lineNumbers(), highlightActiveLineGutter(), foldGutter(), lintGutter(), history({newGroupDelay: 600}), drawSelection(), indentOnInput(),
    indentUnit.of("  "), EditorState.tabSize.of(2), bracketMatching(), closeBrackets(), autocompletion({activateOnTyping: true}),
    rectangularSelection(), highlightActiveLine(), highlightSelectionMatches(), yaml(), appearance,
    keymap.of([{key: "F8", run: nextDiagnostic}, ...closeBracketsKeymap, ...defaultKeymap, ...searchKeymap, ...historyKeymap, ...foldKeymap, ...completionKeymap, ...lintKeymap]),
    EditorState.readOnly.of(!isWritable),
    EditorView.contentAttributes.of({"aria-label": `Text of ${title}`}),
  ];
}

/** Returns the extensions of a read-only editor. */
export function reading(title: string): Extension {
  return [nonced(), lineNumbers(), drawSelection(), yaml(), appearance, EditorState.readOnly.of(true),
    EditorView.editable.of(false), EditorView.contentAttributes.of({"aria-label": title, tabindex: "0"})];
}
