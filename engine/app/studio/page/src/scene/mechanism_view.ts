import type {Fault} from "../connection/connection";
import type {Context, View} from "../shell/context";
import {h, listen} from "../shell/dom";
import {MechanismFeed} from "./mechanism_feed";
import {factsOf, type Mechanism, placed} from "./mechanism_model";
import type {Colors} from "./mechanism_parts";
import type {MechanismStage} from "./mechanism_stage";
import "./mechanism.css";

/** Mechanism of the file in space, moved by the signals of the run, with a list of its lengths. */
export class MechanismView implements View {
  private readonly stageHost = h("div", {class: "mechanism-stage"});
  private readonly choice = h("select", {"aria-label": "Mechanism", hidden: true});
  private readonly facts = h("dl", {class: "mechanism-facts", "aria-label": "Lengths and positions"});
  private readonly empty = h("p", {class: "empty"});
  private readonly body = h("div", {class: "mechanism"}, this.choice, this.stageHost, this.facts);
  private readonly ends: (() => void)[];
  private readonly feed: MechanismFeed;
  private mechanisms: Mechanism[] = [];
  private mechanism: Mechanism | undefined;
  private stage: MechanismStage | undefined;
  private values = new Map<string, number>();
  private isSeen = true;
  private opened = 0;

  constructor(host: HTMLElement, private readonly context: Context) {
    const {run, connection, theme, shortcuts} = context;
    host.append(this.body, this.empty);
    this.feed = new MechanismFeed(connection, (values) => this.take(values));
    this.ends = [
      run.on("loaded", () => void this.open()), theme.on(() => this.stage?.recolor(this.colors())),
      listen(this.choice, "change", () => void this.choose(Number(this.choice.value))),
      shortcuts.add({key: "D", text: "describe lengths and positions of the mechanism", group: "3-D", within: () => this.body.contains(document.activeElement), action: () => this.tell()}),
    ];
    void this.open();
  }

  shown(isShown: boolean): void {
    this.isSeen = isShown;
    this.feed.want(isShown);
  }

  dispose(): void {
    ++this.opened;
    for (const end of this.ends) end();
    this.feed.dispose();
    this.stage?.dispose();
  }

  private async open(): Promise<void> {
    const number = ++this.opened;
    if (!this.context.run.loaded) return this.showNone("No diagram is loaded yet.");
    try {
      const {mechanisms} = await this.context.connection.call<{mechanisms: Mechanism[]}>("mechanism");
      if (number !== this.opened) return;
      this.mechanisms = mechanisms;
      if (mechanisms.length === 0) return this.showNone("This diagram has no mechanism. A figure with “plot: rig” draws one; figure 21 of the thesis has three dampers in space.");
      this.choice.replaceChildren(...mechanisms.map(({title}, i) => h("option", {value: i}, title || `mechanism ${i + 1}`)));
      this.choice.hidden = mechanisms.length < 2;
      // The first three-dimensional mechanism is the default.
      await this.choose(Math.max(0, mechanisms.findIndex(({dimensions}) => dimensions === 3)));
    } catch (thrown) {
      if (number === this.opened) this.showNone(`The mechanism cannot be shown: ${(thrown as Fault).message}`);
    }
  }

  private showNone(text: string): void {
    this.stage?.dispose();
    [this.stage, this.mechanism] = [undefined, undefined];
    this.feed.want(false);
    this.empty.textContent = text;
    [this.empty.hidden, this.body.hidden] = [false, true];
  }

  private async choose(index: number): Promise<void> {
    const mechanism = this.mechanisms[index], number = this.opened;
    this.choice.value = String(index);
    [this.empty.hidden, this.body.hidden] = [true, false];
    this.stage?.dispose();
    [this.stage, this.mechanism, this.values] = [undefined, mechanism, new Map()];
    this.facts.replaceChildren();
    const {MechanismStage} = await import("./mechanism_stage");
    await this.feed.follow(mechanism);
    if (number !== this.opened || this.mechanism !== mechanism) return;
    this.feed.want(this.isSeen);
    try {
      this.stage = new MechanismStage(this.stageHost, mechanism, this.colors());
    } catch {
      this.stageHost.replaceChildren(h("p", {class: "empty"}, "This browser has no WebGL, so the mechanism is not drawn. Its lengths and positions are listed below."));
    }
    this.update();
  }

  private take(values: Map<string, number>): void {
    this.values = values;
    this.update();
  }

  private update(): void {
    if (!this.mechanism) return;
    const all = placed(this.mechanism, this.values), facts = factsOf(this.mechanism, all);
    this.stage?.show(all);
    if (this.facts.children.length !== facts.length) this.facts.replaceChildren(...facts.map(() => h("div", {}, h("dt"), h("dd"))));
    facts.forEach(({name, value}, i) => {
      const [term, text] = this.facts.children[i].children;
      if (term.textContent !== name) term.textContent = name;
      if (text.textContent !== value) text.textContent = value;
    });
  }

  private tell(): void {
    if (!this.mechanism) return;
    this.context.announce(factsOf(this.mechanism, placed(this.mechanism, this.values)).map(({name, value}) => `${name}: ${value}`).join("; ") || "No values yet.");
  }

  private colors(): Colors {
    return this.context.theme.isDark
      ? {housing: "#7d93ad", steel: "#c9ced6", dark: "#59616c", ground: "#4a525d", acting: "#ff8d85", accent: "#6cb0f5", line: "#9aa3af"}
      : {housing: "#8fa6c1", steel: "#b4bac3", dark: "#59616c", ground: "#c3c7cd", acting: "#b3261e", accent: "#1d5fa8", line: "#5f6875"};
  }
}
