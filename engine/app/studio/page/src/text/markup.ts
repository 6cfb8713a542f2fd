// Documentation from the language server is markup of texts of diagrams: only plain elements without attributes come into the page.

const plain = new Set(["P", "CODE", "PRE", "EM", "STRONG", "UL", "OL", "LI", "BR", "HR", "H1", "H2", "H3", "H4", "TABLE", "THEAD", "TBODY", "TR", "TH", "TD", "BLOCKQUOTE", "SPAN", "DIV"]);
const dropped = new Set(["SCRIPT", "STYLE", "IFRAME", "OBJECT", "TEMPLATE", "SVG", "MATH"]);

function copied(node: Node): Node[] {
  if (node.nodeType === Node.TEXT_NODE) return [document.createTextNode(node.textContent ?? "")];
  if (!(node instanceof HTMLElement) || dropped.has(node.tagName.toUpperCase())) return [];
  const children = [...node.childNodes].flatMap(copied);
  if (!plain.has(node.tagName)) return children;
  const element = document.createElement(node.tagName.toLowerCase());
  element.append(...children);
  return [element];
}

/** What of a markup may be shown. */
export const plainNodes = (html: string): Node[] => [...new DOMParser().parseFromString(html, "text/html").body.childNodes].flatMap(copied);

/** The same as a text, for a library that takes no nodes. */
export function plainMarkup(html: string): string {
  const holder = document.createElement("div");
  holder.append(...plainNodes(html));
  return new XMLSerializer().serializeToString(holder);
}
