import {listen} from "../shell/dom";

/** Accepts names and expressions that are dropped on an element. */
export function takeDrops(element: HTMLElement, take: (source: string) => void): void {
  listen(element, "dragover", (event: DragEvent) => {
    if (!event.dataTransfer?.types.includes("text/plain")) return;
    event.preventDefault();
    element.classList.add("dropping");
  });
  listen(element, "dragleave", () => element.classList.remove("dropping"));
  listen(element, "drop", (event: DragEvent) => {
    event.preventDefault();
    event.stopPropagation();
    element.classList.remove("dropping");
    const source = event.dataTransfer?.getData("text/plain").trim();
    if (source) take(source);
  });
}
