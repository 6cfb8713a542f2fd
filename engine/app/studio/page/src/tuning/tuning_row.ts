import {Fault} from "../connection/connection";
import {icon} from "../run/icons";
import type {Parameter, SetEcho} from "../run/run_types";
import type {DisplayUnit} from "../scopes/display_unit";
import type {Context} from "../shell/context";
import {h, listen} from "../shell/dom";
import {placeOf, places, sliderRange, valueAt, valueText} from "./parameter_range";
import {SetQueue} from "./set_queue";

/** Number of runs in a fan. */
const fanRuns = 9;

/** Row of a live parameter: a slider, a field, and the value that the run has accepted. */
export class TuningRow {
  readonly element = h("li", {class: "tuned"});
  private readonly slider = h("input", {type: "range", class: "tuned-slider", min: 0, max: places, step: 1});
  private readonly field = h("input", {type: "text", class: "tuned-field", spellcheck: "false", autocomplete: "off"});
  private readonly echo = h("span", {class: "tuned-echo"});
  private readonly fault = h("p", {class: "tuned-fault", role: "alert", hidden: true});
  private readonly pinned = h("button", {type: "button", class: "plain small", title: "Pin to the top"}, icon("pin"));
  private readonly back: HTMLButtonElement;
  private readonly write: HTMLButtonElement;
  private readonly queue = new SetQueue<string | number>((value) => this.send(value));
  private readonly unit: DisplayUnit;
  /** True after a value was set; until then the slider shows its range. */
  private isTuned = false;
  private range: {low: number; high: number};
  private readonly inText: {text: string; value: number};

  constructor(private readonly parameter: Parameter, private readonly context: Context, isPinned: boolean, pin: () => void) {
    const {name, doc} = parameter;
    this.unit = parameter.shown;
    this.range = sliderRange(parameter);
    this.inText = {text: parameter.text, value: parameter.value};
    this.back = this.button("Reset", `Back to ${parameter.text}, the value in the text`, () => void this.queue.put(this.inText.text));
    this.write = this.button("To text", "Write this value to the text, as one edit (Ctrl+Z undoes it)", () => this.writeToText());
    this.pinned.setAttribute("aria-label", `Pin to the top: ${name}`);
    this.setPinned(isPinned);
    listen(this.pinned, "click", pin);
    for (const control of [this.slider, this.field]) control.setAttribute("aria-label", `${name}${doc ? `, ${doc}` : ""}`);
    this.element.append(
      h("div", {class: "tuned-head"}, h("span", {class: "tuned-name", title: name}, name), h("span", {class: "tuned-doc", title: doc}, doc), this.pinned),
      h("div", {class: "tuned-line"}, this.slider, this.field),
      h("div", {class: "tuned-foot"}, this.echo, this.back, this.write, this.button("Sweep", `Run it at ${fanRuns} values between the ends; the curves appear behind the scopes`, () => void this.fan())), this.fault);
    listen(this.slider, "input", () => void this.queue.put(valueAt(Number(this.slider.value), this.range)));
    listen(this.field, "keydown", (event: KeyboardEvent) => this.press(event));
    listen(this.field, "change", () => this.enter());
    this.show();
  }

  /** Shows a value that the run has accepted, from this page or another one. */
  took({value, text, tick}: SetEcho): void {
    if (value === null) return void (this.echo.textContent = `${text} from tick ${tick}`);
    this.isTuned = true;
    this.parameter.value = value;
    this.range = {low: Math.min(this.range.low, value), high: Math.max(this.range.high, value)};
    this.refuse(undefined);
    this.show();
    this.echo.textContent = `${valueText(value, this.unit)} from tick ${tick}`;
    this.echo.title = this.echo.textContent;
  }

  setPinned(isPinned: boolean): void {
    this.pinned.setAttribute("aria-pressed", String(isPinned));
  }

  private button(text: string, title: string, action: () => void): HTMLButtonElement {
    return h("button", {type: "button", class: "plain small", title, "aria-label": `${title}: ${this.parameter.name}`, onclick: action}, text);
  }

  private show(): void {
    const {value} = this.parameter, text = valueText(value, this.unit);
    if (document.activeElement !== this.slider) this.slider.value = String(placeOf(value, this.range));
    if (document.activeElement !== this.field) this.field.value = text;
    this.slider.setAttribute("aria-valuetext", text);
    this.slider.title = `${valueText(this.range.low, this.unit)} to ${valueText(this.range.high, this.unit)}`;
    if (!this.isTuned) this.echo.textContent = this.slider.title;
    this.back.hidden = this.write.hidden = value === this.inText.value;
  }

  private press(event: KeyboardEvent): void {
    if (event.key === "Enter") this.enter();
    if (event.key !== "Escape") return;
    this.field.value = valueText(this.parameter.value, this.unit);
    this.refuse(undefined);
  }

  /** Sets the value of the field; a number without a unit has that of the field. */
  private enter(): void {
    const text = this.field.value.trim();
    if (text === this.entered || text === "" || text === valueText(this.parameter.value, this.unit)) return;
    const isBare = /^[-+]?[\d.]+(e[-+]?\d+)?$/i.test(text);
    this.entered = isBare && this.unit.text && this.unit.text !== "1" ? `${text} ${this.unit.text}` : text;
    this.field.value = this.entered;
    void this.queue.put(this.entered);
  }

  /** Text that was sent last: Enter and the change of the field follow each other. */
  private entered = "";

  private async send(value: string | number): Promise<void> {
    try {
      await this.context.run.set(this.parameter.name, value);
    } catch (thrown) {
      this.refuse(Fault.from(thrown).message);
    } finally {
      this.entered = "";
    }
  }

  private refuse(why: string | undefined): void {
    this.fault.hidden = why === undefined;
    this.fault.textContent = why ?? "";
    this.field.setAttribute("aria-invalid", String(why !== undefined));
  }

  /** Requests a text edit with the value, which undo can revert. */
  private writeToText(): void {
    const detail = {name: this.parameter.name, text: valueText(this.parameter.value, this.unit)};
    this.element.dispatchEvent(new CustomEvent("studio:write", {bubbles: true, cancelable: true, detail}));
  }

  private async fan(): Promise<void> {
    this.echo.textContent = `running ${fanRuns} values …`;
    try {
      const {points} = await this.context.run.fan(this.parameter.name, this.range.low, this.range.high, fanRuns);
      this.echo.textContent = `${points.length} runs are behind the scopes`;
      this.context.show("scopes");
    } catch (thrown) {
      this.echo.textContent = "";
      this.refuse(Fault.from(thrown).message);
    }
  }
}
