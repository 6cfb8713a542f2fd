import {HighlightStyle, syntaxHighlighting} from "@codemirror/language";
import type {Extension} from "@codemirror/state";
import {EditorView} from "@codemirror/view";
import {tags} from "@lezer/highlight";

const highlight = HighlightStyle.define([
  {tag: [tags.propertyName, tags.definition(tags.propertyName)], color: "var(--syntax-key)"},
  {tag: [tags.number, tags.bool, tags.null], color: "var(--syntax-number)"},
  {tag: [tags.string, tags.special(tags.string)], color: "var(--syntax-string)"},
  {tag: [tags.comment, tags.lineComment], color: "var(--syntax-comment)", fontStyle: "italic"},
  {tag: [tags.keyword, tags.typeName, tags.labelName], color: "var(--syntax-keyword)"},
]);

const look = EditorView.theme({
  "&": {height: "100%", color: "var(--ink)", backgroundColor: "var(--surface)", fontSize: "13px"},
  "&.cm-focused": {outline: "none"},
  ".cm-scroller": {fontFamily: "var(--mono)", lineHeight: "1.5"},
  ".cm-content": {caretColor: "var(--ink)"},
  ".cm-cursor": {borderLeftColor: "var(--ink)"},
  ".cm-gutters": {backgroundColor: "var(--surface)", color: "var(--ink-faint)", border: "none", fontSize: "12px"},
  ".cm-activeLine, .cm-activeLineGutter": {backgroundColor: "color-mix(in srgb, var(--hover) 55%, transparent)"},
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground": {backgroundColor: "var(--selection) !important"},
  ".cm-matchingBracket": {backgroundColor: "var(--accent-soft) !important"},
  ".cm-panels": {backgroundColor: "var(--ground)", color: "var(--ink)"},
  ".cm-tooltip": {backgroundColor: "var(--raised)", color: "var(--ink)", border: "1px solid var(--line)", borderRadius: "4px", boxShadow: "var(--shadow)"},
  ".cm-tooltip-autocomplete > ul > li[aria-selected]": {backgroundColor: "var(--accent)", color: "var(--accent-ink)"},
  ".cm-completionInfo": {maxWidth: "420px", whiteSpace: "pre-wrap"},
  ".cm-diagnostic": {padding: "5px 8px", borderLeft: "4px solid var(--line-strong)", maxWidth: "560px", whiteSpace: "pre-wrap"},
  ".cm-diagnostic-error": {borderLeftColor: "var(--bad)"},
  ".cm-diagnostic-warning": {borderLeftColor: "var(--warn)"},
  ".cm-diagnosticAction": {height: "auto", padding: "2px 8px", backgroundColor: "var(--accent)", color: "var(--accent-ink)", borderRadius: "4px"},
  ".cm-lintRange-error": {backgroundImage: "none", textDecoration: "underline wavy var(--bad) 1px", textUnderlineOffset: "3px"},
  ".cm-lintRange-warning": {backgroundImage: "none", textDecoration: "underline wavy var(--warn) 1px", textUnderlineOffset: "3px"},
});

export const appearance: Extension = [look, syntaxHighlighting(highlight)];
