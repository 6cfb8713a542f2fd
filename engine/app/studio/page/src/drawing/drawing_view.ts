import type {DiagramFault, Fault} from "../connection/connection";
import type {Context, View} from "../shell/context";
import {h, listen} from "../shell/dom";
import {keyOf as keyOfEvent} from "../shell/shortcuts";
import {BlockCard} from "./block_card";
import {Connecting} from "./connecting";
import {Crumbs} from "./crumbs";
import {GraphSource} from "./graph_source";
import {nextShape} from "./navigation";
import {Ranges} from "./ranges";
import {keyOf, type Placed, Shapes} from "./shapes";
import type {Picture, Shape, TextRange, Wire} from "./types";
import {Viewport} from "./viewport";
import "./drawing.css";

/** The drawing of the diagram: a view of its text, which is edited through it. */
export class DrawingView implements View {
  private readonly shapes = new Shapes();
  private readonly ranges = new Ranges();
  private readonly source: GraphSource;
  private readonly viewport: Viewport;
  private readonly crumbs: Crumbs;
  private readonly card: BlockCard;
  private readonly connecting: Connecting;
  private readonly canvas = h("div", {class: "canvas", tabindex: 0, role: "listbox", "aria-label": "Drawing", "data-focus": true, "data-own-keys": true});
  private readonly fault = h("div", {class: "drawing-fault", hidden: true, role: "status"});
  private readonly busy = h("div", {class: "drawing-busy", hidden: true}, "laying out…");
  private readonly ends: (() => void)[];
  private scope: string[] = [];
  private readonly opened = new Set<string>();
  private selected = "";
  private selectedWire: Wire | undefined;
  private picture: Picture | undefined;

  constructor(host: HTMLElement, private readonly context: Context) {
    const {workbench, connection} = context;
    this.source = new GraphSource(connection, {
      drawn: ({ranges}) => this.take(ranges), picture: (picture) => this.show(picture), fault: (fault) => this.complain(fault),
      busy: (isBusy) => { this.busy.hidden = !isBusy || this.picture !== undefined; },
    });
    this.crumbs = new Crumbs((depth) => this.enter(this.scope.slice(0, depth)));
    const tool = (text: string, title: string, action: () => void) => h("button", {type: "button", class: "plain", title, "aria-label": title, onclick: action}, text);
    const head = h("div", {class: "drawing-head"}, this.crumbs.element,
      tool("+ Block", "Insert a block (I)", () => void this.insert()),
      tool("−", "Smaller (-)", () => this.viewport.zoom(0.8)), tool("+", "Larger (+)", () => this.viewport.zoom(1.25)), tool("Fit", "Whole drawing (0)", () => this.viewport.fit()));
    this.canvas.append(this.shapes.root);
    host.append(h("div", {class: "drawing"}, head, this.canvas, this.busy, this.fault));
    this.viewport = new Viewport(this.canvas, this.shapes.root);
    this.card = new BlockCard(this.canvas, context, () => this.canvas.focus());
    this.connecting = new Connecting(this.canvas, this.shapes, this.viewport, context, (id) => this.place(id), () => this.file);
    this.ends = [
      workbench.on("root", () => this.enter([])), workbench.on("synced", () => void this.source.refresh()),
      workbench.on("moved", ({file, at}) => this.ranges.move(file, at)),
      workbench.on("selected", ({file, from, to}) => this.follow(file, from, to)), workbench.on("marks", () => this.mark()),
      listen(this.canvas, "click", (event: MouseEvent) => this.click(event)),
      listen(this.canvas, "dblclick", (event: MouseEvent) => this.activate(this.shapes.of(event.target))),
      listen(this.canvas, "keydown", (event: KeyboardEvent) => this.press(event)),
    ];
    if (workbench.root >= 0) this.enter([]);
  }

  dispose(): void {
    for (const end of this.ends) end();
    this.connecting.dispose();
    this.viewport.dispose();
    this.source.dispose();
  }

  /** Draws a part by the names down to it; [] is the file itself. */
  private enter(scope: string[]): void {
    const {workbench} = this.context;
    this.scope = scope;
    this.picture = undefined;
    this.canvas.classList.add("old");
    this.busy.hidden = false;
    this.card.close();
    this.crumbs.show(workbench.nameOf(workbench.root), scope);
    this.source.show({file: workbench.root, scope: scope.join("."), open: [...this.opened], units: true});
  }

  private take(ranges: Record<string, TextRange>): void {
    this.context.workbench.setFaults(this.context.workbench.root, []);
    this.ranges.take(ranges);
    this.fault.hidden = true;
    this.canvas.classList.toggle("old", !this.picture);
    this.mark();
  }

  private show(picture: Picture): void {
    const isFirst = this.picture === undefined;
    this.picture = picture;
    this.canvas.classList.remove("old");
    this.shapes.show(picture, (shape) => this.describe(shape, picture), isFirst || this.context.theme.isStill);
    this.viewport.resize(picture.width, picture.height);
    if (isFirst) this.viewport.fit();
    if (isFirst && this.scope.length > 0) void this.context.workbench.activate(this.file);
    this.canvas.setAttribute("aria-label", `Drawing of ${[this.context.workbench.nameOf(this.context.workbench.root), ...this.scope].join(", ")}: ${picture.shapes.filter(({own, id}) => !own && !id.startsWith(":")).length} blocks`);
    this.mark();
    this.select(this.selected, false);
  }

  /** What a shape is, for who does not see it. */
  private describe(shape: Shape, picture: Picture): string {
    const name = (id: string) => id.replace(/^:(input|output|constant):/, "");
    if (shape.own) return `${shape.own} ${name(shape.id)} of the file`;
    if (shape.id.startsWith(":constant:")) return `constant ${shape.lines.join(" ")}`;
    const sources = picture.wires.filter(({to}) => to?.node === shape.id).map(({from}) => name(from.node));
    const sinks = [...new Set(picture.wires.filter(({from, to}) => from.node === shape.id && to).map(({to}) => name(to!.node)))];
    return [`${shape.name || shape.id}, ${shape.isPart ? "part " : ""}${shape.type}`, sources.length > 0 ? `from ${sources.join(", ")}` : "", sinks.length > 0 ? `to ${sinks.join(", ")}` : ""].filter(Boolean).join("; ");
  }

  private complain(fault: Fault): void {
    this.canvas.classList.toggle("old", this.picture !== undefined);
    this.context.workbench.setFaults(this.context.workbench.root, fault.faults);
    const [first] = fault.faults;
    this.fault.replaceChildren(h("span", {"aria-hidden": true}, "!"), h("span", {class: "why"}, first ? `${first.subject ? `${first.subject}: ` : ""}${first.text}${first.cure ? `; ${first.cure}` : ""}` : fault.message),
      fault.faults.length > 1 ? h("span", {}, `and ${fault.faults.length - 1} more`) : "", first ? h("button", {type: "button", onclick: () => this.toFault(first)}, "Show") : "");
    this.fault.hidden = false;
    this.busy.hidden = true;
  }

  /** The place of a fault in the text. */
  private toFault({file, line, column}: DiagramFault): void {
    const {workbench} = this.context, entry = workbench.files.find(({name}) => file.endsWith(name));
    void workbench.revealLine(entry?.file ?? workbench.root, line, column);
  }

  /** Marks shapes that have a fault in their text. */
  private mark(): void {
    const {workbench} = this.context, faulty = new Map<string, string>();
    for (const {file} of workbench.files)
      for (const {from, to, message, severity} of workbench.marksOf(file)) {
        const id = severity === "error" ? this.around(file, from, to) || this.around(file, from, from) : "";
        if (id) faulty.set(id, message);
      }
    for (const {shape, element} of this.shapes.placed.values()) {
      const message = faulty.get(shape.id);
      element.classList.toggle("faulty", message !== undefined);
      if (message) element.setAttribute("aria-description", message);
      else element.removeAttribute("aria-description");
    }
  }

  private around(file: number, from: number, to: number): string {
    return this.ranges.around(file, from, to, (id) => this.drawn(id));
  }

  /** The drawn block of a shape or port of the text, or "". */
  private drawn(id: string): string {
    const whole = this.scope.join("."), own = whole && id.startsWith(`${whole}.`) ? id.slice(whole.length + 1) : id;
    for (const name of [own, own.slice(0, Math.max(0, own.indexOf(".", 1))), own.slice(0, Math.max(0, own.lastIndexOf("."))), id, id.slice(0, Math.max(0, id.lastIndexOf(".")))])
      if (name && this.shapes.find(name)) return name;
    return "";
  }

  /** The file of what is drawn. */
  private get file(): number {
    const {root} = this.context.workbench;
    if (this.scope.length === 0) return root;
    const [first] = [...this.shapes.placed.values()].flatMap(({shape}) => (shape.within.length === 0 ? this.range(shape.id) ?? [] : []));
    return first?.file ?? root;
  }

  // --- selection ---

  private get current(): Placed | undefined {
    return this.shapes.placed.get(this.selected);
  }

  private select(key: string, announce = true): void {
    this.selected = key;
    for (const [own, {element}] of this.shapes.placed) {
      element.classList.toggle("selected", own === key);
      element.setAttribute("aria-selected", String(own === key));
    }
    const {current} = this;
    if (current) this.canvas.setAttribute("aria-activedescendant", current.element.id);
    else this.canvas.removeAttribute("aria-activedescendant");
    if (current && announce) this.context.announce(current.element.getAttribute("aria-label") ?? "");
  }

  private range(id: string): TextRange | undefined {
    return this.ranges.of([...this.scope, id].join(".")) ?? this.ranges.of(id);
  }

  /** Where the text of a shape is edited: its file, and its name there. */
  private place(id: string): {file: number; name: string; range: TextRange} | undefined {
    const range = this.range(id);
    return range ? {file: range.file, name: id.slice(id.lastIndexOf(".") + 1), range} : undefined;
  }

  /** The place in the text becomes the shape in the drawing. */
  private follow(file: number, from: number, to: number): void {
    const found = this.shapes.find(this.around(file, from, to));
    if (!found || keyOf(found.shape) === this.selected) return;
    this.select(keyOf(found.shape), false);
    this.viewport.reveal(found.shape);
  }

  private choose(placed: Placed | undefined): void {
    this.selectWire(undefined);
    if (!placed) return this.select("", false);
    this.select(keyOf(placed.shape));
    const place = this.place(placed.shape.id);
    if (place) void this.context.workbench.reveal(place.range.file, place.range.from, place.range.to);
  }

  private selectWire(wire: Wire | undefined): void {
    this.selectedWire = wire;
    for (const {wire: own, element} of this.shapes.laid) element.classList.toggle("selected", own === wire);
    if (wire) this.context.announce(`wire from ${wire.from.node} to ${wire.to?.node ?? "nothing"}`);
  }

  private click(event: MouseEvent): void {
    if (this.card.contains(event.target)) return;
    this.canvas.focus();
    const laid = this.shapes.wireOf(event.target);
    if (!laid) return this.choose(this.shapes.of(event.target));
    this.select("", false);
    this.selectWire(laid.wire);
  }

  // --- what is done with shapes ---

  /** A part is entered, a block shown with what may be changed. */
  private activate(placed: Placed | undefined): void {
    if (!placed || placed.shape.id.startsWith(":")) return;
    if (placed.shape.isPart) return this.enter([...this.scope, ...this.relative(placed.shape.id)]);
    this.edit(placed);
  }

  /** Names from what is drawn down to a shape; the names of shapes begin at what is drawn, or at the file. */
  private relative(id: string): string[] {
    const names = id.split("."), isWhole = this.scope.length > 0 && this.scope.every((name, i) => names[i] === name) && names.length > this.scope.length;
    return isWhole ? names.slice(this.scope.length) : names;
  }

  private edit(placed: Placed, field: "name" | "value" = "value"): void {
    const place = this.place(placed.shape.id);
    if (place) void this.card.open(placed.shape, place, field);
  }

  private async remove(): Promise<void> {
    const {workbench} = this.context, wire = this.selectedWire;
    if (wire?.to) return this.disconnect(wire);
    const place = this.current ? this.place(this.current.shape.id) : undefined;
    if (place) await this.attempt(() => workbench.splice(place.file, {kind: "delete", name: place.name}), `${place.name} is deleted`);
  }

  private async disconnect({to}: Wire): Promise<void> {
    const place = this.place(to!.node);
    await this.attempt(() => this.context.workbench.splice(place?.file ?? this.file, {kind: "disconnect", to: place?.name ?? "", input: to!.port}), "the wire is removed");
    this.selectWire(undefined);
  }

  private async attempt(action: () => Promise<unknown>, done: string): Promise<void> {
    try {
      await action();
      this.context.announce(done);
    } catch (thrown) {
      this.context.notify((thrown as Error).message, "fault");
    }
  }

  private async insert(): Promise<void> {
    const {openPalette} = await import("../palette/palette");
    openPalette(this.context, {file: this.file, signals: this.signals(), preferred: this.current ? this.signals([this.current])[0] ?? "" : ""});
  }

  /** How the text names the signals of what is drawn. */
  private signals(placed: Iterable<Placed> = this.shapes.placed.values()): string[] {
    return [...placed].flatMap(({shape: {id, own, within, isPart, outputs}}) => {
      if (within.length > 0 || own === "output" || id.startsWith(":constant:")) return [];
      if (own === "input") return [id.slice(":input:".length)];
      return outputs.map(({port}) => (outputs.length === 1 && !isPart ? id : `${id}.${port}`));
    });
  }

  private press(event: KeyboardEvent): void {
    if (this.card.contains(event.target)) return;
    const key = keyOfEvent(event), {current} = this;
    const actions: Record<string, () => void> = {
      "+": () => this.viewport.zoom(1.25), "-": () => this.viewport.zoom(0.8), "0": () => this.viewport.fit(),
      Enter: () => this.activate(current), F2: () => { if (current) this.edit(current, "name"); }, Delete: () => void this.remove(), Backspace: () => this.up(),
      E: () => { if (current) this.edit(current); }, I: () => void this.insert(), C: () => { if (current) void this.connecting.byKeys(current); },
      Esc: () => this.card.close(), W: () => this.nextWire(),
      "Shift+Left": () => this.viewport.pan(-60, 0), "Shift+Right": () => this.viewport.pan(60, 0), "Shift+Up": () => this.viewport.pan(0, -60), "Shift+Down": () => this.viewport.pan(0, 60),
    };
    const action = actions[key] ?? (event.key.startsWith("Arrow") && key.length <= 5 ? () => this.step(event.key) : undefined);
    if (!action) return;
    event.preventDefault();
    event.stopPropagation();
    action();
  }

  private step(key: string): void {
    const all = [...this.shapes.placed.values()].filter(({shape}) => !shape.isFrame), next = nextShape(all, this.current, key);
    if (!next) return;
    this.choose(next);
    this.viewport.reveal(next.shape);
  }

  /** Goes through the wires of the selected block, to delete one by keys. */
  private nextWire(): void {
    const own = this.shapes.laid.filter(({wire: {from, to}}) => to && [from.node, to.node].includes(this.current?.shape.id ?? from.node));
    if (own.length > 0) this.selectWire(own[(own.findIndex(({wire}) => wire === this.selectedWire) + 1) % own.length].wire);
  }

  private up(): void {
    if (this.scope.length > 0) this.enter(this.scope.slice(0, -1));
  }
}
