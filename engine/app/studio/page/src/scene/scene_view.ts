import type {Fault} from "../connection/connection";
import type {Context, View} from "../shell/context";
import {h, listen} from "../shell/dom";
import {ClockSync} from "./clock_sync";
import {Hand} from "./hand";
import {HandLatency} from "./hand_latency";
import {PointerSource} from "./pointer_source";
import {SceneCanvas} from "./scene_canvas";
import {describeScene, type SceneInfo, type SceneNews, shapesOf, startOf} from "./scene_info";
import {Steering} from "./steering";
import "./scene.css";

/** Returns the text below a scene: the general hint, and the text of the diagram. */
function wordsOf({pointer}: SceneInfo): string {
  if (pointer?.hand === false) return "The hand of the file moves it; you only watch.";
  if (!pointer) return "This diagram moves its own hand; you only watch.";
  const {text} = pointer, seen = /seen.*not felt/i.test(text) ? "" : "The resistance is seen, not felt.";
  return ["Press and move over the scene, or use arrow keys or a gamepad.", text, seen].filter(Boolean).join(" ");
}

/** Scene of the file during the run. Pointer, arrow keys or gamepad over it control the hand. */
export class SceneView implements View {
  private readonly stage = h("div", {class: "scene-stage"});
  private readonly words = h("p", {class: "scene-words"});
  private readonly state = h("span", {class: "scene-state", role: "status"});
  private readonly lag = h("span", {class: "scene-lag", title: "Median time from a pointer movement to the first frame that shows its effect"});
  private readonly stay = h("button", {type: "button", "aria-pressed": "false", title: "The hand follows the pointer without a pressed button; a click or Esc releases it"}, "Hold without a button");
  private readonly own = h("button", {type: "button", "aria-pressed": "false", title: "Restarts with the hand of the file; again: your hand"}, "Hand of the file");
  private readonly tell = h("button", {type: "button", title: "Describe the scene (D)"}, "Describe");
  private readonly whole = h("button", {type: "button", title: "The scene takes the whole screen; Esc ends it"}, "Full screen");
  private readonly empty = h("p", {class: "empty"});
  private readonly foot = h("div", {class: "scene-foot"}, this.words, this.state, this.lag, this.stay, this.own, this.whole, this.tell);
  private readonly root = h("div", {class: "scene"}, this.stage, this.empty, this.foot);
  private readonly latency = new HandLatency();
  private readonly sizes = new ResizeObserver(() => { if (this.canvas?.fit()) this.draw(); });
  private readonly ends: (() => void)[];
  private parts: {dispose(): void}[] = [];
  private canvas: SceneCanvas | undefined;
  private hand: Hand | undefined;
  private pointer: PointerSource | undefined;
  private info: SceneInfo | undefined;
  private news: SceneNews | undefined;
  private isSeen = true;
  private frame: number | undefined;
  private opened = 0;

  constructor(host: HTMLElement, private readonly context: Context) {
    const {run, connection, shortcuts} = context;
    host.append(this.root);
    this.sizes.observe(this.stage);
    this.ends = [
      run.on("loaded", () => void this.open()), run.on("state", () => this.showState()),
      connection.on("scene", (news: SceneNews) => this.take(news)),
      connection.on("connection", ({state}) => (state === "open" ? this.watch() : this.letGo())),
      listen(window, "blur", () => this.letGo()), listen(document, "visibilitychange", () => { if (document.hidden) this.letGo(); }),
      listen(this.stay, "click", () => this.toggleStay()), listen(this.tell, "click", () => this.describe()), listen(this.own, "click", () => void this.change()),
      listen(this.whole, "click", () => void this.fill()),
      shortcuts.add({key: "D", text: "describe the scene", group: "Scene", within: () => this.stage.contains(document.activeElement), action: () => this.describe()}),
      shortcuts.add({key: "Left", text: "move the hand over the scene (all arrows; Shift: slowly; Esc releases it)", group: "Scene", within: () => false, action: () => {}}),
    ];
    void this.open();
  }

  shown(isShown: boolean): void {
    this.isSeen = isShown;
    if (!isShown) this.letGo();
    this.watch();
  }

  dispose(): void {
    this.letGo();
    this.isSeen = false;
    this.watch();
    this.sizes.disconnect();
    this.close();
    for (const end of this.ends) end();
  }

  private close(): void {
    for (const part of this.parts.splice(0)) part.dispose();
    if (this.frame !== undefined) cancelAnimationFrame(this.frame);
    this.frame = undefined;
    this.stage.replaceChildren();
    [this.canvas, this.hand, this.pointer, this.info, this.news] = [undefined, undefined, undefined, undefined, undefined];
  }

  private async open(): Promise<void> {
    const {loaded} = this.context.run, number = ++this.opened;
    if (!loaded?.scene) return this.showNone(loaded ? "This diagram has no scene. A section “scene:” in its text shows objects that follow signals; example 82 has one." : "No diagram is loaded yet.");
    try {
      const {scene} = await this.context.connection.call<{scene: SceneInfo | null}>("scene");
      if (number !== this.opened) return;
      if (scene) this.show(scene);
      else this.showNone("This diagram has no scene.");
    } catch (thrown) {
      this.showNone(`The scene cannot be shown: ${(thrown as Fault).message}`);
    }
  }

  private showNone(text: string): void {
    this.close();
    this.empty.textContent = text;
    this.empty.hidden = false;
    this.foot.hidden = true;
  }

  private show(info: SceneInfo): void {
    this.close();
    [this.empty.hidden, this.foot.hidden] = [true, false];
    this.info = info;
    const canvas = (this.canvas = new SceneCanvas(this.stage, info));
    this.stage.append(canvas.element);
    canvas.fit();
    this.words.textContent = wordsOf(info);
    const isPlayable = Boolean(info.pointer) && info.pointer!.hand !== false;
    this.stay.hidden = !isPlayable;
    this.own.hidden = !info.pointer;
    this.own.setAttribute("aria-pressed", String(info.pointer?.hand === false));
    canvas.element.classList.toggle("scene-playable", isPlayable);
    canvas.element.setAttribute("aria-label", `Scene${info.title ? ` of ${info.title}` : ""}${isPlayable ? "; arrows move the hand, Esc releases it" : ""}; D describes it`);
    if (isPlayable) this.attach(canvas, info);
    this.watch();
    this.showState();
    this.draw();
  }

  private attach(canvas: SceneCanvas, info: SceneInfo): void {
    const hand = (this.hand = new Hand(info.pointer!, info));
    const pointer = new PointerSource(canvas.element, () => this.hand, (x, y) => canvas.placeOf(x, y), () => this.flush());
    const span = Math.max(info.x[1] - info.x[0], info.y[1] - info.y[0]);
    const steering = new Steering(canvas.element, {hand: () => this.hand, start: () => hand.at ?? startOf(info, this.news), span: () => span, flush: () => this.flush()});
    const clock = new ClockSync(this.context.connection, () => hand.held && this.context.run.loaded?.loop !== undefined);
    this.parts = [pointer, steering, clock, {dispose: listen(canvas.element, "blur", () => { if (!pointer.stays) this.letGo(); })}];
    pointer.stays = this.stay.getAttribute("aria-pressed") === "true";
    this.pointer = pointer;
  }

  /** Switches between the page's hand and the file's own. The run restarts, and continues playing if it was. */
  private async change(): Promise<void> {
    const {run} = this.context, isPlaying = run.news.state === "playing";
    if (run.file === null) return;
    this.letGo();
    run.hasHand = !run.hasHand;
    try {
      await run.load(run.file);
      if (isPlaying || !run.hasHand) await run.play();
    } catch (thrown) {
      run.hasHand = !run.hasHand;
      this.context.notify((thrown as Fault).message, "fault");
    }
  }

  private toggleStay(): void {
    const stays = this.stay.getAttribute("aria-pressed") !== "true";
    this.stay.setAttribute("aria-pressed", String(stays));
    if (this.pointer) this.pointer.stays = stays;
    if (!stays) this.letGo();
  }

  private watch(): void {
    if (this.context.connection.state !== "open") return;
    this.context.connection.call("scene.watch", {on: this.isSeen && this.info !== undefined}).catch(() => {});
  }

  private letGo(): void {
    if (!this.hand?.held) return;
    this.hand.release(performance.now() / 1000);
    this.flush();
  }

  /** Sends the samples of the hand at once, since events arrive in groups anyway. */
  private flush(): void {
    const samples = this.hand?.collect() ?? [];
    if (samples.length === 0) return;
    this.context.connection.tell("run.input", {samples});
    // Gripping starts a paused run.
    if (this.hand?.held && this.context.run.news.state === "paused" && samples.some(({name}) => name === this.info?.pointer?.held)) void this.context.run.play();
    this.latency.sent(samples);
    this.showState();
    this.draw();
  }

  private take(news: SceneNews): void {
    this.news = news;
    this.draw();
  }

  /** Draws once per screen refresh. */
  private draw(): void {
    this.frame ??= requestAnimationFrame(() => {
      this.frame = undefined;
      if (!this.canvas || !this.info) return;
      const at = this.hand?.held ? this.hand.at : undefined;
      this.canvas.draw(this.news ? shapesOf(this.info, this.news) : [], at && {at, pulled: startOf(this.info, this.news)});
      const took = this.news && this.latency.drawn(this.news, performance.now() / 1000);
      if (took !== undefined) this.context.run.latency.measured(1000 * took);
      this.showState();
    });
  }

  private showState(): void {
    const {news} = this.context.run, parts = [news.state === "playing" ? "" : news.state === "ended" ? "The run has ended; restart it to continue." : "The run is paused."];
    if (this.hand) parts.push(this.hand.held ? "You hold the hand." : "The hand is free.");
    const lag = this.latency.median, text = parts.filter(Boolean).join(" ");
    if (this.state.textContent !== text) this.state.textContent = text;
    this.lag.textContent = lag === undefined ? "" : `lag ${Math.round(1000 * lag)} ms`;
  }

  private async fill(): Promise<void> {
    if (document.fullscreenElement) await document.exitFullscreen();
    else await this.root.requestFullscreen().catch(() => this.context.notify("this browser does not give a page the whole screen"));
    this.canvas?.element.focus();
  }

  private describe(): void {
    if (this.info && this.news) this.context.announce(describeScene(this.info, this.news));
    else this.context.announce("The scene has not moved yet.");
  }
}
