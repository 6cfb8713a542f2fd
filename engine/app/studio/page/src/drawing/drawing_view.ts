import type {DiagramFault, Fault} from "../connection/connection";
import type {Context, View} from "../shell/context";
import {h, listen} from "../shell/dom";
import {openMenu} from "../shell/menu";
import {keyOf as keyOfEvent} from "../shell/shortcuts";
import {BlockCard} from "./block_card";
import {Connecting} from "./connecting";
import {Crumbs} from "./crumbs";
import {GraphSource} from "./graph_source";
import {describe} from "./description";
import {Places} from "./places";
import {Selection} from "./selection";
import {ShapeEdits} from "./shape_edits";
import {type Placed, Shapes} from "./shapes";
import {dragSignals} from "./signal_drag";
import type {Picture, Shape, TextRange} from "./types";
import {Viewport} from "./viewport";
import "./drawing.css";

/** Drawing of the diagram, through which its text is edited. */
export class DrawingView implements View {
  private readonly shapes = new Shapes();
  private readonly places = new Places(this.shapes);
  private readonly source: GraphSource;
  private readonly viewport: Viewport;
  private readonly crumbs: Crumbs;
  private readonly card: BlockCard;
  private readonly connecting: Connecting;
  private readonly canvas = h("div", {class: "canvas", tabindex: 0, role: "listbox", "aria-label": "Drawing", "data-focus": true, "data-own-keys": "Enter Left Right Up Down"});
  private readonly fault = h("div", {class: "drawing-fault", hidden: true, role: "status"});
  private readonly busy = h("div", {class: "drawing-busy", hidden: true}, "laying out…");
  private readonly ends: (() => void)[];
  private readonly selection: Selection;
  private readonly edits: ShapeEdits;
  private readonly opened = new Set<string>();
  private picture: Picture | undefined;
  /** Newest picture, which may not be complete yet. */
  private latest: Picture | undefined;
  private pressed = [0, 0];

  constructor(host: HTMLElement, private readonly context: Context) {
    const {workbench, connection} = context;
    this.source = new GraphSource(connection, {
      drawn: ({ranges}) => this.take(ranges), picture: (picture) => void this.show(picture), fault: (fault) => this.complain(fault),
      busy: (isBusy) => { this.busy.hidden = !isBusy || this.picture !== undefined; },
    });
    this.crumbs = new Crumbs((depth) => this.enter(this.places.scope.slice(0, depth)));
    const tool = (text: string, title: string, action: () => void) => h("button", {type: "button", class: "plain", title, "aria-label": title, onclick: action}, text);
    const head = h("div", {class: "drawing-head"}, this.crumbs.element,
      tool("+ Block", "Insert a block (I)", () => void this.edits.insert()),
      tool("−", "Zoom out (-)", () => this.viewport.zoom(0.8)), tool("+", "Zoom in (+)", () => this.viewport.zoom(1.25)), tool("Fit", "Fit the drawing (0)", () => this.viewport.fit()));
    this.canvas.append(this.shapes.root);
    host.append(h("div", {class: "drawing"}, head, this.canvas, this.busy, this.fault));
    this.viewport = new Viewport(this.canvas, this.shapes.root);
    this.card = new BlockCard(this.canvas, context, () => this.canvas.focus());
    this.connecting = new Connecting(this.canvas, this.shapes, this.viewport, context, this.places);
    this.selection = new Selection(this.canvas, this.shapes, this.places, this.viewport, context);
    this.edits = new ShapeEdits(this.places, this.selection, this.card, context);
    this.ends = [
      dragSignals(this.canvas, this.shapes, this.places), ...keyList.map(([key, text]) => context.shortcuts.add({key, text, group: "Drawing", within: () => false, action: () => {}})),
      workbench.on("root", () => this.enter([])), workbench.on("synced", () => void this.source.refresh()),
      workbench.on("moved", ({file, at}) => this.places.ranges.move(file, at)),
      workbench.on("selected", ({file, from, to}) => this.selection.follow(file, from, to)), workbench.on("marks", () => this.mark()),
      listen(this.canvas, "pointerdown", (event: PointerEvent) => { this.pressed = [event.clientX, event.clientY]; }, {capture: true}),
      listen(this.canvas, "contextmenu", (event: MouseEvent) => this.openMenu(event)),
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

  /** Shows the inside of a part, by the names that lead to it; [] is the file itself. */
  private enter(scope: string[]): void {
    const {workbench} = this.context;
    this.places.scope = scope;
    this.places.root = workbench.root;
    this.picture = this.latest = undefined;
    this.canvas.classList.add("old");
    this.busy.hidden = false;
    this.card.close();
    this.crumbs.show(workbench.nameOf(workbench.root), scope);
    this.source.show({file: workbench.root, scope: scope.join("."), open: [...this.opened], units: true});
  }

  private take(ranges: Record<string, TextRange>): void {
    this.context.workbench.setFaults(this.context.workbench.root, []);
    this.places.ranges.take(ranges);
    this.fault.hidden = true;
    this.canvas.classList.toggle("old", !this.picture);
    this.mark();
  }

  private async show(picture: Picture): Promise<void> {
    this.latest = picture;
    const groups = await this.shapes.made(picture);
    if (picture !== this.latest) return;
    const isFirst = this.picture === undefined;
    this.picture = picture;
    this.canvas.classList.remove("old");
    this.shapes.show(picture, groups, (shape) => describe(shape, picture), isFirst || this.context.theme.isStill);
    this.viewport.resize(picture.width, picture.height);
    if (isFirst) this.viewport.begin(picture.shapes.filter(({isFrame}) => !isFrame).reduce<Shape | undefined>((first, one) => (first && first.x <= one.x ? first : one), undefined));
    if (isFirst && this.places.scope.length > 0) void this.context.workbench.activate(this.places.file);
    this.canvas.setAttribute("aria-label", `Drawing of ${[this.context.workbench.nameOf(this.context.workbench.root), ...this.places.scope].join(", ")}: ${picture.shapes.filter(({own, id}) => !own && !id.startsWith(":")).length} blocks`);
    this.mark();
    this.selection.restore();
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

  /** Shows a fault in the text. */
  private toFault({file, line, column}: DiagramFault): void {
    const {workbench} = this.context, entry = workbench.files.find(({name}) => file.endsWith(name));
    void workbench.revealLine(entry?.file ?? workbench.root, line, column);
  }

  /** Marks shapes whose text has a fault. */
  private mark(): void {
    const {workbench} = this.context, faulty = new Map<string, string>();
    for (const {file} of workbench.files)
      for (const {from, to, message, severity} of workbench.marksOf(file)) {
        const id = severity === "error" ? this.places.around(file, from, to) || this.places.around(file, from, from) : "";
        if (id) faulty.set(id, message);
      }
    this.shapes.markFaulty(faulty);
  }

  private click(event: MouseEvent): void {
    const isMoved = Math.hypot(event.clientX - this.pressed[0], event.clientY - this.pressed[1]) > 4;
    if (this.card.contains(event.target) || isMoved) return;
    this.canvas.focus();
    this.selection.take(event.target);
  }

  /** Enters a part, or opens the card of a block. */
  private activate(placed: Placed | undefined): void {
    if (!placed || placed.shape.id.startsWith(":")) return;
    if (placed.shape.isPart) return this.enter([...this.places.scope, ...this.places.relative(placed.shape.id)]);
    this.edits.edit(placed);
  }

  /** Expands a part in place, or collapses it. */
  private toggle({shape}: Placed): void {
    if (!shape.isPart) return;
    const name = [...this.places.scope, ...this.places.relative(shape.id)].join(".");
    if (!this.opened.delete(name)) this.opened.add(name);
    this.enter(this.places.scope);
  }

  private openMenu(event: MouseEvent): void {
    if (this.card.contains(event.target)) return;
    event.preventDefault();
    this.selection.take(event.target);
    openMenu({x: event.clientX, y: event.clientY}, this.entries(), "Drawing");
  }

  /** Returns the menu entries for the selection. */
  private entries(): [string, () => void][] {
    const {current, wire} = this.selection, insert: [string, () => void] = ["Insert a block …", () => void this.edits.insert()];
    if (wire) return [["Bode plot of the loop, opened here", () => this.edits.bode(this.canvas)], ["Delete the wire", () => void this.edits.remove()], insert];
    if (!current || current.shape.id.startsWith(":")) return [insert, ["Fit the drawing", () => this.viewport.fit()]];
    const inside: [string, () => void][] = [["Open", () => this.activate(current)], [current.shape.isFrame ? "Collapse" : "Expand here", () => this.toggle(current)]];
    return [...(current.shape.isPart ? inside : []), ["Edit …", () => this.edits.edit(current)], ["Rename …", () => this.edits.edit(current, "name")],
      ["Connect to …", () => void this.connecting.byKeys(current)], ["Bode plot of the loop, opened at its output", () => this.edits.bode(this.canvas)], ["Delete", () => void this.edits.remove()], insert];
  }

  private press(event: KeyboardEvent): void {
    if (this.card.contains(event.target)) return;
    const key = keyOfEvent(event), {current} = this.selection, withCurrent = (action: (placed: Placed) => void) => () => { if (current) action(current); };
    const actions: Record<string, () => void> = {
      "+": () => this.viewport.zoom(1.25), "-": () => this.viewport.zoom(0.8), "0": () => this.viewport.fit(),
      Enter: () => this.activate(current), F2: withCurrent((one) => this.edits.edit(one, "name")), Delete: () => void this.edits.remove(), Backspace: () => this.up(),
      E: withCurrent((one) => this.edits.edit(one)), I: () => void this.edits.insert(), C: withCurrent((one) => void this.connecting.byKeys(one)), O: withCurrent((one) => this.toggle(one)),
      Esc: () => this.card.close(), W: () => this.selection.nextWire(), B: () => this.edits.bode(this.canvas),
      "Shift+Left": () => this.viewport.pan(-60, 0), "Shift+Right": () => this.viewport.pan(60, 0), "Shift+Up": () => this.viewport.pan(0, -60), "Shift+Down": () => this.viewport.pan(0, 60),
      Left: () => this.selection.step("ArrowLeft"), Right: () => this.selection.step("ArrowRight"), Up: () => this.selection.step("ArrowUp"), Down: () => this.selection.step("ArrowDown"),
    };
    if (!actions[key]) return;
    event.preventDefault();
    event.stopPropagation();
    actions[key]();
  }

  private up(): void {
    if (this.places.scope.length > 0) this.enter(this.places.scope.slice(0, -1));
  }
}

/** Rows for the list of keys; they apply while the drawing has the focus. */
const keyList: [string, string][] = [
  ["Left", "select the next block in that direction (all arrows)"], ["Enter", "open a part, edit a block"], ["O", "expand a part"], ["Backspace", "leave a part"],
  ["F2", "rename a block everywhere"], ["C", "connect its output"], ["W", "next wire of a block"], ["B", "Bode plot of the loop, opened at the wire or at the block's output"], ["Delete", "delete a block or wire"], ["I", "insert a block"],
  ["+", "larger"], ["-", "smaller"], ["0", "fit the drawing"], ["Shift+Left", "pan the drawing (all arrows)"],
];
