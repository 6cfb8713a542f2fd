// Functions for creating elements. Texts are inserted as text, never as markup.

type Child = Node | string | null | undefined | false;
type Properties = Record<string, unknown>;

function put(element: Element, key: string, value: unknown): void {
  if (value === undefined || value === null || value === false) return;
  if (key.startsWith("on") && typeof value === "function") element.addEventListener(key.slice(2), value as EventListener);
  else element.setAttribute(key, value === true ? "" : String(value));
}

function filled<E extends Element>(element: E, properties: Properties, children: Child[]): E {
  for (const [key, value] of Object.entries(properties)) put(element, key, value);
  element.append(...children.filter((child): child is Node | string => child instanceof Node || typeof child === "string"));
  return element;
}

/** Creates an HTML element: attributes by name, listeners such as `onclick`, and children as nodes or text. */
export function h<K extends keyof HTMLElementTagNameMap>(name: K, properties: Properties = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  return filled(document.createElement(name), properties, children);
}

/** Creates an SVG element in the same way. */
export function svg<K extends keyof SVGElementTagNameMap>(name: K, properties: Properties = {}, ...children: Child[]): SVGElementTagNameMap[K] {
  return filled(document.createElementNS("http://www.w3.org/2000/svg", name), properties, children);
}

/** Adds a listener; returns a function that removes it. */
export function listen(target: EventTarget, name: string, listener: (event: any) => void, options?: AddEventListenerOptions): () => void {
  target.addEventListener(name, listener, options);
  return () => target.removeEventListener(name, listener, options);
}
