import {h} from "../shell/dom";

/** Breadcrumbs from the file to the part that is drawn. */
export class Crumbs {
  readonly element = h("nav", {class: "crumbs", "aria-label": "Parts"});

  constructor(private readonly go: (depth: number) => void) {}

  show(file: string, scope: string[]): void {
    const crumb = (text: string, depth: number) =>
      h("button", {type: "button", class: "plain", "aria-current": depth === scope.length ? "location" : null, title: text, onclick: () => this.go(depth)}, text);
    this.element.replaceChildren(crumb(file, 0), ...scope.flatMap((name, i) => [h("span", {class: "between", "aria-hidden": true}, "›"), crumb(name, i + 1)]));
  }
}
