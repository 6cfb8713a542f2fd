// Guard for SVG from texts of a diagram: the page accepts only the elements and attributes that drawings use.

const elements = new Set(["svg", "g", "path", "rect", "circle", "text", "tspan", "line", "polyline", "polygon", "title"]);
const attributes = new Set([
  "xmlns", "viewBox", "width", "height", "x", "y", "cx", "cy", "r", "rx", "ry", "d", "points", "x1", "y1", "x2", "y2", "dx", "dy", "transform",
  "fill", "stroke", "stroke-width", "stroke-linejoin", "stroke-linecap", "stroke-dasharray", "opacity", "fill-opacity",
  "font-size", "font-family", "font-style", "font-weight", "text-anchor", "paint-order", "class",
]);
/** Pattern of references, which no attribute value needs. */
const points = /url\s*\(|javascript:|data:/i;

function refused(element: Element): string | undefined {
  if (element.namespaceURI !== "http://www.w3.org/2000/svg" || !elements.has(element.localName)) return `<${element.localName}>`;
  for (const {name, value} of element.attributes) if (!attributes.has(name) || points.test(value)) return `${name} in <${element.localName}>`;
  return undefined;
}

/** Parses an SVG text into an element of this page. Throws if it is malformed or contains anything that drawings do not use. */
export function svgElement(text: string): SVGSVGElement {
  const parsed = new DOMParser().parseFromString(text, "image/svg+xml"), root = parsed.documentElement;
  for (const element of [root, ...root.querySelectorAll("*")]) {
    const what = refused(element);
    if (what) throw new Error(`the drawing has ${what} in it, which is not shown`);
  }
  return document.adoptNode(root) as unknown as SVGSVGElement;
}
