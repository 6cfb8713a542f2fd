import type {Context} from "../shell/context";
import {h, listen} from "../shell/dom";

/** Display time [ms]. */
const shownFor = 8000;

/** Message beside the pointer with the reason of a refusal, until the next key press or click. */
export class Refusal {
  private element: HTMLElement | undefined;
  private ends: (() => void)[] = [];

  constructor(private readonly context: Context) {}

  show({clientX, clientY}: {clientX: number; clientY: number}, why: string): void {
    this.hide();
    const element = h("div", {class: "refusal", role: "alert"}, why), timer = window.setTimeout(() => this.hide(), shownFor);
    document.body.append(element);
    element.style.setProperty("left", `${Math.max(4, Math.min(clientX + 12, innerWidth - element.offsetWidth - 6))}px`);
    element.style.setProperty("top", `${Math.max(4, Math.min(clientY + 14, innerHeight - element.offsetHeight - 6))}px`);
    this.element = element;
    this.ends = [() => clearTimeout(timer), listen(document, "pointerdown", () => this.hide(), {capture: true}), listen(document, "keydown", () => this.hide(), {capture: true})];
    this.context.announce(why);
  }

  hide(): void {
    for (const end of this.ends) end();
    this.ends = [];
    this.element?.remove();
    this.element = undefined;
  }
}
