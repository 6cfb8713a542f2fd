import {h} from "./dom";

const shownFor = 5000;  // ms

/** Notices in the corner of the page, which are also announced to screen readers. */
export class Notices {
  readonly element: HTMLElement;
  private readonly polite = h("div", {class: "unseen", role: "status", "aria-live": "polite"});
  private readonly list = h("div", {class: "notices"});

  constructor() {
    this.element = h("div", {}, this.polite, this.list);
  }

  announce(text: string): void {
    this.polite.textContent = text;
  }

  notify(text: string, kind: "note" | "fault" = "note"): void {
    for (const same of [...this.list.children]) if (same.firstChild?.textContent === text) same.remove();
    const notice = h("div", {class: `notice notice-${kind}`, role: kind === "fault" ? "alert" : null}, h("span", {}, text),
      h("button", {type: "button", class: "plain", "aria-label": "Close this notice", onclick: () => notice.remove()}, "×"));
    this.list.append(notice);
    if (kind === "note") {
      this.announce(text);
      setTimeout(() => notice.remove(), shownFor);
    }
    while (this.list.children.length > 4) this.list.firstChild?.remove();
  }
}
