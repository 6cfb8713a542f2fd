import type {BlockType} from "../palette/reference";
import {Ranges} from "./ranges";
import type {Placed, Shapes} from "./shapes";
import type {TextRange} from "./types";

/** Place of a shape in the texts, for edits. */
export interface Place {
  file: number;
  /** Name of the shape in that file. */
  name: string;
  range: TextRange;
}

/** Mapping between shapes and places in the texts. */
export class Places {
  readonly ranges = new Ranges();
  /** Names of the parts that lead to the drawn one. */
  scope: string[] = [];
  root = -1;

  constructor(private readonly shapes: Shapes) {}

  /** Returns the drawn block around a range of a text, or "". */
  around(file: number, from: number, to: number): string {
    return this.ranges.around(file, from, to, (id) => this.drawn(id));
  }

  place(id: string): Place | undefined {
    const range = this.range(id);
    return range ? {file: range.file, name: id.slice(id.lastIndexOf(".") + 1), range} : undefined;
  }

  /** Returns the file of the drawn part. */
  get file(): number {
    const [first] = [...this.shapes.placed.values()].flatMap(({shape}) => (shape.within.length === 0 ? this.range(shape.id) ?? [] : []));
    return this.scope.length > 0 ? first?.file ?? this.root : this.root;
  }

  /** Returns the names of the drawn signals as in the text. With `types` it includes outputs without a sink, which are not drawn. */
  signals(placed: Iterable<Placed> = this.shapes.placed.values(), types: BlockType[] = []): string[] {
    return [...placed].flatMap(({shape: {id, type, own, within, isPart, outputs: drawn}}) => {
      const known = isPart ? undefined : types.find((one) => one.name === type), outputs = known?.outputs.map(({name}) => ({port: name})) ?? drawn;
      if (within.length > 0 || own === "output" || id.startsWith(":constant:")) return [];
      if (own === "input") return [id.slice(":input:".length)];
      const name = id.slice(id.lastIndexOf(".") + 1);
      return outputs.map(({port}) => (outputs.length === 1 && !isPart ? name : `${name}.${port}`));
    });
  }

  /** Returns the name of a drawn output as in the file: names of parts, block and port; "" for a number. */
  path({node, port}: {node: string; port: string}): string {
    if (node.startsWith(":constant:")) return "";
    if (node.startsWith(":input:")) return node.slice(":input:".length);
    return [...this.scope, ...this.relative(node), port].join(".");
  }

  /** Returns the names from the drawn part to a shape. An id of a shape may start at the drawn part or at the file. */
  relative(id: string): string[] {
    const names = id.split("."), isWhole = this.scope.length > 0 && names.length > this.scope.length && this.scope.every((name, i) => names[i] === name);
    return isWhole ? names.slice(this.scope.length) : names;
  }

  private range(id: string): TextRange | undefined {
    return this.ranges.of([...this.scope, id].join(".")) ?? this.ranges.of(id);
  }

  /** Returns the drawn block of a shape or port of the text, or "". */
  private drawn(id: string): string {
    const whole = this.scope.join("."), own = whole && id.startsWith(`${whole}.`) ? id.slice(whole.length + 1) : id;
    const first = own.slice(0, Math.max(0, own.indexOf(".", 1))), upTo = (name: string) => name.slice(0, Math.max(0, name.lastIndexOf(".")));
    return [own, first, upTo(own), id, upTo(id)].find((name) => name !== "" && this.shapes.find(name)) ?? "";
  }
}
