import {blockTypes} from "../palette/reference";
import type {Context} from "../shell/context";
import type {BlockCard} from "./block_card";
import type {Places} from "./places";
import type {Selection} from "./selection";
import type {Placed} from "./shapes";
import type {Wire} from "./types";

/** Edits of the selection, as splices of the text. */
export class ShapeEdits {
  constructor(private readonly places: Places, private readonly selection: Selection, private readonly card: BlockCard, private readonly context: Context) {}

  edit({shape}: Placed, field: "name" | "value" = "value"): void {
    const place = this.places.place(shape.id);
    if (place) void this.card.open(shape, place, field);
  }

  /** Deletes the selected wire or block. */
  async remove(): Promise<void> {
    const {wire, current} = this.selection;
    if (wire?.to) return this.disconnect(wire);
    const place = current && this.places.place(current.shape.id);
    if (place) await this.attempt(() => this.context.workbench.splice(place.file, {kind: "delete", name: place.name}), `${place.name} is deleted`);
  }

  async insert(): Promise<void> {
    const {openPalette} = await import("../palette/palette"), {current} = this.selection, types = await blockTypes(this.context.connection).catch(() => []);
    openPalette(this.context, {file: this.places.file, signals: this.places.signals(undefined, types), preferred: current ? this.places.signals([current])[0] ?? "" : ""});
  }

  /** Requests a Bode plot of the loop through the selected wire, or through the output of the selected block. */
  bode(from: HTMLElement): void {
    const {wire, current} = this.selection, signal = wire ? this.places.path(wire.from) : current?.shape.outputs[0] ? this.places.path({node: current.shape.id, port: current.shape.outputs[0].port}) : "";
    if (signal) from.dispatchEvent(new CustomEvent("studio:bode", {bubbles: true, cancelable: true, detail: {signal}}));
    else this.context.notify("select a wire of the loop first (click it, or W)");
  }

  private async disconnect({to}: Wire): Promise<void> {
    const place = this.places.place(to!.node), edit = {kind: "disconnect", to: place?.name ?? "", input: to!.port};
    await this.attempt(() => this.context.workbench.splice(place?.file ?? this.places.file, edit), "the wire is removed");
    this.selection.selectWire(undefined);
  }

  private async attempt(action: () => Promise<unknown>, done: string): Promise<void> {
    try {
      await action();
      this.context.announce(done);
    } catch (thrown) {
      this.context.notify((thrown as Error).message, "fault");
    }
  }
}
