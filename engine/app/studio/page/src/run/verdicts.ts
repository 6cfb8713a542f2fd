import {h, listen} from "../shell/dom";
import type {Loaded, Verdict} from "./run_types";

const marks: Record<Verdict["verdict"], string> = {ok: "✓", FAIL: "✗", known: "≠", open: "·"};
const words: Record<Verdict["verdict"], string> = {ok: "holds", FAIL: "fails", known: "is expected to fail", open: "is not judged yet"};

/** Verdicts of the file's claims: a button with their counts, above the list. */
export class Verdicts {
  private readonly counts = h("summary", {class: "verdict-counts"});
  private readonly list = h("ul", {class: "verdict-list"});
  readonly element = h("details", {class: "verdicts", hidden: true}, this.counts, this.list);

  constructor(private readonly announce: (text: string) => void) {
    listen(document, "pointerdown", ({target}: PointerEvent) => { if (!this.element.contains(target as Node)) this.element.open = false; });
    listen(this.element, "keydown", (event: KeyboardEvent) => {
      if (event.key !== "Escape" || !this.element.open) return;
      event.stopPropagation();
      this.element.open = false;
    });
  }

  load({claims}: Loaded): void {
    this.element.hidden = claims.length === 0;
    this.show(claims.map(({that}) => ({that, verdict: "open", text: ""})));
  }

  /** Shows the verdicts at the end of a run. */
  judge(verdicts: Verdict[]): void {
    this.element.hidden = verdicts.length === 0;
    this.show(verdicts);
    const failed = verdicts.filter(({verdict}) => verdict === "FAIL").length;
    if (verdicts.some(({verdict}) => verdict !== "open")) this.announce(failed === 0 ? "all claims hold" : `${failed} of ${verdicts.length} claims fail`);
  }

  private show(verdicts: Verdict[]): void {
    const count = (one: Verdict["verdict"]) => verdicts.filter(({verdict}) => verdict === one).length;
    const parts = (["ok", "FAIL", "known", "open"] as const).filter((one) => count(one) > 0);
    this.counts.replaceChildren("Claims ", ...parts.map((one) => h("span", {class: `verdict verdict-${one}`, title: `${count(one)} ${words[one]}`}, `${marks[one]} ${count(one)}`)));
    this.list.replaceChildren(...verdicts.map(({that, verdict, text}) => h("li", {class: `verdict-${verdict}`},
      h("span", {class: "verdict", role: "img", "aria-label": words[verdict]}, marks[verdict]), h("span", {}, that), text && h("span", {class: "verdict-value"}, text))));
  }
}
