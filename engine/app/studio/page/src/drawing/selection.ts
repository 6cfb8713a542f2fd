import type {Context} from "../shell/context";
import {nextShape} from "./navigation";
import type {Places} from "./places";
import {keyOf, type Placed, type Shapes} from "./shapes";
import type {Wire} from "./types";
import type {Viewport} from "./viewport";

/** Selected shape or wire of the drawing, which also selects its text. */
export class Selection {
  private key = "";
  wire: Wire | undefined;

  constructor(private readonly canvas: HTMLElement, private readonly shapes: Shapes, private readonly places: Places, private readonly viewport: Viewport, private readonly context: Context) {}

  get current(): Placed | undefined {
    return this.shapes.placed.get(this.key);
  }

  /** Selects the same shape in a new picture. */
  restore(): void {
    this.select(this.key, false);
    this.selectWire(undefined);
  }

  /** Selects the shape or wire under the pointer. */
  take(target: EventTarget | null): void {
    const laid = this.shapes.wireOf(target);
    if (!laid) return this.choose(this.shapes.of(target));
    this.select("", false);
    this.selectWire(laid.wire);
  }

  /** Selects the shape of a range in the text. */
  follow(file: number, from: number, to: number): void {
    const found = this.shapes.find(this.places.around(file, from, to));
    if (!found || keyOf(found.shape) === this.key) return;
    this.select(keyOf(found.shape), false);
    this.viewport.reveal(found.shape);
  }

  /** Selects the next shape in the direction of an arrow key. */
  step(key: string): void {
    const next = nextShape([...this.shapes.placed.values()].filter(({shape}) => !shape.isFrame), this.current, key);
    if (!next) return;
    this.choose(next);
    this.viewport.reveal(next.shape);
  }

  /** Selects the next wire of the selected block. */
  nextWire(): void {
    const id = this.current?.shape.id, own = this.shapes.laid.filter(({wire: {from, to}}) => to && (id === undefined || from.node === id || to.node === id));
    if (own.length > 0) this.selectWire(own[(own.findIndex(({wire}) => wire === this.wire) + 1) % own.length].wire);
  }

  selectWire(wire: Wire | undefined): void {
    this.wire = wire;
    for (const {wire: own, element} of this.shapes.laid) element.classList.toggle("selected", own === wire);
    if (wire) this.context.announce(`wire from ${wire.from.node} to ${wire.to?.node ?? "nothing"}`);
  }

  private choose(placed: Placed | undefined): void {
    this.selectWire(undefined);
    this.select(placed ? keyOf(placed.shape) : "");
    const place = placed && this.places.place(placed.shape.id);
    if (place) void this.context.workbench.reveal(place.range.file, place.range.from, place.range.to);
  }

  private select(key: string, announce = true): void {
    this.key = key;
    for (const [own, {element}] of this.shapes.placed) {
      const isSelected = String(own === key);
      if (element.getAttribute("aria-selected") === isSelected) continue;
      element.classList.toggle("selected", own === key);
      element.setAttribute("aria-selected", isSelected);
    }
    const {current} = this;
    if (current) this.canvas.setAttribute("aria-activedescendant", current.element.id);
    else this.canvas.removeAttribute("aria-activedescendant");
    if (current && announce) this.context.announce(current.element.getAttribute("aria-label") ?? "");
  }
}
