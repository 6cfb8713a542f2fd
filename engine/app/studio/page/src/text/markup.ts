// Conversion of Markdown from the language server to elements. Documentation may contain texts of diagrams, so HTML in it remains text.

import {lexer, type Token, type Tokens} from "marked";

const children = (tokens: Token[] | undefined, text = "") => (tokens ? tokens.flatMap(nodesOf) : [document.createTextNode(text)]);

function element(name: string, ...content: Node[]): HTMLElement {
  const made = document.createElement(name);
  made.append(...content);
  return made;
}

const row = (cells: Tokens.TableCell[], name: "td" | "th") => element("tr", ...cells.map(({tokens}) => element(name, ...children(tokens))));

const makers: Record<string, (token: any) => Node[]> = {
  heading: ({depth, tokens}: Tokens.Heading) => [element(`h${Math.min(6, depth)}`, ...children(tokens))],
  paragraph: ({tokens}: Tokens.Paragraph) => [element("p", ...children(tokens))],
  blockquote: ({tokens}: Tokens.Blockquote) => [element("blockquote", ...children(tokens))],
  list: ({ordered, items}: Tokens.List) => [element(ordered ? "ol" : "ul", ...items.map(({tokens}) => element("li", ...children(tokens))))],
  table: ({header, rows}: Tokens.Table) => [element("table", row(header, "th"), ...rows.map((one) => row(one, "td")))],
  code: ({text}: Tokens.Code) => [element("pre", document.createTextNode(text))],
  codespan: ({text}: Tokens.Codespan) => [element("code", document.createTextNode(text))],
  strong: ({tokens}: Tokens.Strong) => [element("strong", ...children(tokens))],
  em: ({tokens}: Tokens.Em) => [element("em", ...children(tokens))],
  br: () => [element("br")], hr: () => [element("hr")], space: () => [],
  text: ({tokens, text}: Tokens.Text) => children(tokens, text), link: ({tokens, text}: Tokens.Link) => children(tokens, text),
};

function nodesOf(token: Token): Node[] {
  return makers[token.type]?.(token) ?? [document.createTextNode("text" in token ? String(token.text) : token.raw)];
}

/** Returns a Markdown text as elements of the page. */
export const markupNodes = (markdown: string): Node[] => lexer(markdown).flatMap(nodesOf);
