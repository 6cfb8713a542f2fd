// Drawing of wires from an output to an input, by dragging or from a list. Only inputs with a matching unit are offered.

import {Fault} from "../connection/connection";
import type {Context} from "../shell/context";
import {listen, svg} from "../shell/dom";
import {openMenu} from "../shell/menu";
import type {Places} from "./places";
import {Refusal} from "./refusal";
import type {Placed, Shapes} from "./shapes";
import type {End, Shape} from "./types";
import type {Viewport} from "./viewport";

interface Source {
  shape: Shape;
  port: string;
  file: number;
  /** Full name with the port, even if the drawing shows only one of several outputs. */
  name: string;
}

/** Input that accepts the signal. An input that is not drawn, such as a further one of a list, is placed at the left of the block. */
interface Target {
  placed: Placed;
  port: string;
  isDrawn: boolean;
  x: number;
  y: number;
}

const near = 28;  // pixels of the picture

export class Connecting {
  private source: Source | undefined;
  private targets: Target[] = [];
  private target: Target | undefined;
  private readonly refusal: Refusal;
  private readonly ends: (() => void)[];

  constructor(private readonly canvas: HTMLElement, private readonly shapes: Shapes, private readonly viewport: Viewport, private readonly context: Context,
              private readonly places: Places) {
    this.refusal = new Refusal(context);
    this.ends = [
      listen(canvas, "pointerdown", (event: PointerEvent) => this.grab(event), {capture: true}),
      listen(document, "keydown", (event: KeyboardEvent) => { if (event.key === "Escape" && this.source) this.stop(); }),
    ];
  }

  dispose(): void {
    for (const end of this.ends) end();
    this.refusal.hide();
  }

  /** Lists the inputs that accept the first output of a block. */
  async byKeys({shape}: Placed): Promise<void> {
    const [port] = shape.outputs;
    if (!port) return this.context.announce(`${shape.name} has no output`);
    const source = this.sourceOf(shape, port.port);
    if (!source) return;
    const targets = await this.fitting(source), box = this.canvas.getBoundingClientRect();
    if (targets.length === 0) return this.context.notify(`no input accepts ${source.name}: no unit fits`);
    openMenu({x: box.left + 20, y: box.top + 20}, targets.map((target): [string, () => void] => [`${source.name} → ${this.labelOf(target)}`, () => void this.connect(source, target)]), "Connect to");
  }

  private labelOf({placed: {shape}, port}: Target): string {
    return `${shape.name || shape.id.replace(/^:\w+:/, "")}.${port}`;
  }

  private sourceOf(shape: Shape, port: string): Source | undefined {
    if (shape.own === "input") return {shape, port, file: this.places.file, name: port};
    const place = this.places.place(shape.id);
    return place ? {shape, port, file: place.file, name: `${place.name}.${port}`} : undefined;  // the server omits the name of a single output
  }

  /** Returns the inputs in the same file that accept an output. */
  private async fitting(source: Source): Promise<Target[]> {
    const {workbench, connection} = this.context, document = await workbench.open(source.file), where = source.shape.within.join();
    const here = [...this.shapes.placed.values()].filter(({shape}) => shape.within.join() === where && shape.own !== "input" && !shape.id.startsWith(":constant:"));
    try {
      const {inputs} = await connection.call<{inputs: {node: string; input: string}[]}>("fits", {file: source.file, version: document.version, from: source.name});
      return inputs.flatMap(({node, input}) => {
        const placed = here.find(({shape}) => (node === "" ? shape.id === `:output:${input}` : this.places.place(shape.id)?.name === node));
        return placed ? [this.targetAt(placed, input)] : [];
      });
    } catch {
      return here.flatMap((placed) => placed.shape.inputs.map(({port}) => this.targetAt(placed, port)));  // the splice refuses unsuitable inputs
    }
  }

  private targetAt(placed: Placed, port: string): Target {
    const {x, y, height, inputs} = placed.shape, drawn = inputs.find((one) => one.port === port || (inputs.length === 1 && one.port === `${port}.1`));
    return {placed, port, isDrawn: drawn !== undefined, x: x + (drawn?.x ?? 0), y: y + (drawn?.y ?? height / 2)};
  }

  private grab(event: PointerEvent): void {
    const port = event.target instanceof Element ? event.target.closest<SVGElement>(".port-output") : null;
    const placed = port ? this.shapes.of(port) : undefined, source = placed && port ? this.sourceOf(placed.shape, port.dataset.port!) : undefined;
    if (!source || event.button !== 0) return;
    event.stopPropagation();
    event.preventDefault();
    this.source = source;
    this.canvas.setPointerCapture(event.pointerId);
    void this.offer(source);
    const begin: End = {node: source.shape.id, port: source.port}, ends = [
      listen(this.canvas, "pointermove", (moved: PointerEvent) => this.follow(moved, begin)),
      listen(this.canvas, "pointerup", (released: PointerEvent) => this.drop(released)),
      listen(this.canvas, "lostpointercapture", () => { ends.forEach((end) => end()); this.stop(); }),
    ];
  }

  private async offer(source: Source): Promise<void> {
    const targets = await this.fitting(source);
    if (this.source !== source) return;
    this.targets = targets;
    this.canvas.classList.add("connecting");
    for (const {placed, port} of targets) {
      placed.element.classList.add("fits");
      this.dotOf(placed, port)?.classList.add("fits");
    }
  }

  private dotOf(placed: Placed, port: string): SVGElement | undefined {
    return [...placed.element.querySelectorAll<SVGElement>(".port-input")].find((dot) => dot.dataset.port === port);
  }

  private follow(event: PointerEvent, {port}: End): void {
    if (!this.source) return;
    const {shape} = this.source, out = shape.outputs.find((one) => one.port === port)!, [x, y] = this.viewport.at(event);
    this.point(this.nearest(x, y));
    const end = this.target ? [this.target.x, this.target.y] : [x, y], start = [shape.x + out.x, shape.y + out.y], bend = Math.max(30, Math.abs(end[0] - start[0]) / 2);
    this.shapes.overlay(svg("path", {class: "loose", d: `M${start.join(" ")}C${start[0] + bend} ${start[1]} ${end[0] - bend} ${end[1]} ${end.join(" ")}`}));
  }

  /** Returns the drawn input near a position, or else any input of the block there. */
  private nearest(x: number, y: number): Target | undefined {
    const distance = (target: Target) => Math.hypot(target.x - x, target.y - y), sorted = [...this.targets].sort((a, b) => distance(a) - distance(b));
    const inside = ({placed: {shape: {x: left, y: top, width, height}}}: Target) => x >= left && x <= left + width && y >= top && y <= top + height;
    return sorted.find((target) => target.isDrawn && distance(target) < near) ?? sorted.find(inside);
  }

  private point(target: Target | undefined): void {
    if (this.target) this.dotOf(this.target.placed, this.target.port)?.classList.remove("target");
    this.target = target;
    if (target) this.dotOf(target.placed, target.port)?.classList.add("target");
  }

  /** Connects to the drawn input at the pointer; elsewhere on a block with several inputs it shows a list. */
  private drop(event: PointerEvent): void {
    const {source, target, targets} = this, [x, y] = this.viewport.at(event);
    this.stop();
    if (!source) return;
    if (!target) return this.dropAside(source, event, [x, y]);
    const own = targets.filter(({placed}) => placed === target.placed), isBeside = target.isDrawn && Math.hypot(target.x - x, target.y - y) < near;
    if (isBeside || own.length === 1) return void this.connect(source, target);
    openMenu({x: event.clientX, y: event.clientY}, own.map((one): [string, () => void] => [`${this.labelOf(one)}${one.isDrawn ? "" : ", new"}`, () => void this.connect(source, one)]), "Connect to");
  }

  /** Tries the edit for a drop on a target that was not offered, and shows the reason of the refusal. */
  private dropAside(source: Source, event: PointerEvent, [x, y]: [number, number]): void {
    const inside = ({shape}: Placed) => !shape.isFrame && x >= shape.x - near / 2 && x <= shape.x + shape.width + near / 2 && y >= shape.y - near / 2 && y <= shape.y + shape.height + near / 2;
    const placed = [...this.shapes.placed.values()].find(inside);
    if (!placed || placed.shape === source.shape && x > placed.shape.x + placed.shape.width / 2) return;
    const why = this.reasonAgainst(source, placed), [first] = placed.shape.inputs.map(({port}) => this.targetAt(placed, port)).sort((a, b) => Math.hypot(a.x - x, a.y - y) - Math.hypot(b.x - x, b.y - y));
    if (why || !first) return this.refusal.show(event, why || `${placed.shape.name || placed.shape.type} has no input`);
    const port = this.openPort(placed, first.port);
    void this.connect(source, {...first, port}, event);
  }

  /** Returns the name of an output of the file; the port of its shape has no name. */
  private openPort({shape}: Placed, port: string): string {
    return /^:output:(.*)$/.exec(shape.id)?.[1] ?? port;
  }

  /** Returns the reason why no input of a shape can accept the signal, as far as the drawing alone shows it; otherwise "". */
  private reasonAgainst(source: Source, {shape}: Placed): string {
    if (shape.within.join() !== source.shape.within.join()) return `${shape.name} is in another file than ${source.name}; open the part and connect its input there`;
    if (shape.own === "input") return `${shape.name || "this"} is an input of the file; it has an output only`;
    return shape.id.startsWith(":constant:") ? "this is a constant of the text and takes no signal; drop the wire on the block that reads it" : "";
  }

  private stop(): void {
    this.point(undefined);
    for (const {placed, port} of this.targets) {
      placed.element.classList.remove("fits");
      this.dotOf(placed, port)?.classList.remove("fits");
    }
    this.targets = [];
    this.source = undefined;
    this.canvas.classList.remove("connecting");
    this.shapes.overlay();
  }

  private async connect(source: Source, target: Target, at?: {clientX: number; clientY: number}): Promise<void> {
    const {shape} = target.placed, to = this.places.place(shape.id)?.name ?? "", before = this.sourceOfInput(target);
    try {
      await this.context.workbench.splice(source.file, {kind: "connect", from: source.name, to, input: target.port});
      const said = `${source.name} is connected to ${this.labelOf(target)}`;
      if (before && before !== source.name) this.context.notify(`${said} instead of ${before}: an input has one source; Ctrl+Z restores it`);
      else this.context.announce(said);
    } catch (thrown) {
      const why = Fault.from(thrown).message, label = this.labelOf(target);
      if (at) this.refusal.show(at, why.startsWith(label) ? why : `${source.name} to ${label}: ${why}`);
      else this.context.notify(why, "fault");
    }
  }

  /** Returns the present source of a drawn input. */
  private sourceOfInput({placed: {shape}, port, isDrawn}: Target): string {
    const fed = isDrawn ? this.shapes.laid.find(({wire: {to}}) => to?.node === shape.id && (to.port === port || to.port === `${port}.1`)) : undefined;
    return fed ? this.places.path(fed.wire.from) : "";
  }
}
