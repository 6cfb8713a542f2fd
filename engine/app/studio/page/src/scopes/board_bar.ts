import {h, listen} from "../shell/dom";
import {openMenu} from "../shell/menu";
import {fixedText, quantityText} from "./numbers";
import type {Pin} from "./pins";
import type {ScopeBoard} from "./scope_board";

/** Selectable widths of the followed window [s]. */
const widths = [0.1, 0.5, 1, 2, 5, 10, 30, 60, 300];

/** Bar above the scopes: their state, the width of the window, pinned runs. */
export class BoardBar {
  readonly element = h("div", {class: "scope-bar", role: "toolbar", "aria-label": "Scopes"});
  private readonly state = h("span", {class: "chip", role: "status"});
  private readonly follow = h("button", {type: "button", class: "plain small", title: "Follow the newest (F)"}, "Follow");
  private readonly width = h("select", {class: "small", "aria-label": "Time span shown", title: "Time span shown"});
  private readonly signals = h("button", {type: "button", class: "plain small", "aria-pressed": "false", title: "Signals of the run (A)"}, "Signals");
  private readonly pins = h("ul", {class: "pins", "aria-label": "Kept runs"});

  private lastPin: Pin | undefined;

  constructor(private readonly board: ScopeBoard) {
    const more = h("button", {type: "button", class: "plain small", "aria-label": "More about scopes", "aria-haspopup": "menu"}, "⋯");
    const pin = h("button", {type: "button", class: "plain small", title: "Pin what the scopes show of this run, to compare later ones with it (P)", onclick: () => void board.pin()}, "Pin run");
    const open = h("button", {type: "button", class: "plain small", title: "New scope (N)", onclick: () => { board.open().element.focus(); board.shared.keep(); }}, "+ Scope");
    this.element.append(this.state, this.follow, this.width, h("span", {class: "gap"}), this.pins, pin, open, this.signals, more);
    listen(this.follow, "click", () => board.follow());
    listen(this.width, "change", () => board.follow(Number(this.width.value)));
    listen(this.signals, "click", () => this.showSignals(board.signals.element.hidden));
    listen(more, "click", () => openMenu(more, [
      ["Copy the address of this view", () => board.copyAddress()], ["Reset to the scopes of the file", () => board.reset()],
      ...(board.shared.fan ? [["Remove the sweep", () => board.shared.context.run.clearFan()] as [string, () => void]] : []),
    ], "Scopes"));
    board.signals.element.hidden = true;
  }

  showSignals(isShown: boolean): void {
    this.board.signals.element.hidden = !isShown;
    this.signals.setAttribute("aria-pressed", String(isShown));
    if (isShown) this.board.signals.focus();
  }

  update(): void {
    const {window, pins} = this.board.shared, {state} = this.board.shared.context.run.news, text = this.stateText();
    if (this.state.textContent !== text) this.state.textContent = text;
    this.state.dataset.state = window.isFollowing ? state : "back";
    this.follow.hidden = window.isFollowing;
    this.listWidths(window.width);
    if (this.pins.childElementCount !== pins.all.length || pins.all.at(-1) !== this.lastPin) this.listPins();
  }

  private listPins(): void {
    const {pins} = this.board.shared;
    this.lastPin = pins.all.at(-1);
    this.pins.replaceChildren(...pins.all.map((pin) => h("li", {class: "chip", title: pin.label}, h("span", {class: "pin-label"}, pin.label),
      h("button", {type: "button", class: "plain small", "aria-label": `Remove ${pin.label}`, onclick: () => pins.drop(pin)}, "×"))));
  }

  /** Returns the state: following, looking back, or paused. In the first two, data may still arrive. */
  private stateText(): string {
    const {window, now, context} = this.board.shared, {state} = context.run.news, {low, high} = window.at(now);
    const paused = state === "playing" ? "" : state === "ended" ? "ended" : "paused";
    if (!window.isFollowing) return `looking back ${fixedText(low, 3)} to ${fixedText(high, 3)} s${paused && `, model ${paused}`}`;
    return paused ? `model ${paused}` : "following";
  }

  private listWidths(now: number): void {
    const all = [...new Set([...widths, now])].sort((a, b) => a - b);
    if (this.width.options.length !== all.length || Number(this.width.value) !== now)
      this.width.replaceChildren(...all.map((width) => h("option", {value: width, selected: width === now}, quantityText(width, "s"))));
    this.width.value = String(now);
  }
}
