import type {BlockType} from "../palette/reference";
import {Ranges} from "./ranges";
import type {Placed, Shapes} from "./shapes";
import type {TextRange} from "./types";

/** Where the text of a shape is edited. */
export interface Place {
  file: number;
  /** Its name in that file. */
  name: string;
  range: TextRange;
}

/** Which shape belongs to which place of the texts, and the reverse. */
export class Places {
  readonly ranges = new Ranges();
  /** Names of parts down to what is drawn. */
  scope: string[] = [];
  root = -1;

  constructor(private readonly shapes: Shapes) {}

  /** The drawn block around a place in a text, or "". */
  around(file: number, from: number, to: number): string {
    return this.ranges.around(file, from, to, (id) => this.drawn(id));
  }

  place(id: string): Place | undefined {
    const range = this.range(id);
    return range ? {file: range.file, name: id.slice(id.lastIndexOf(".") + 1), range} : undefined;
  }

  /** The file of what is drawn. */
  get file(): number {
    const [first] = [...this.shapes.placed.values()].flatMap(({shape}) => (shape.within.length === 0 ? this.range(shape.id) ?? [] : []));
    return this.scope.length > 0 ? first?.file ?? this.root : this.root;
  }

  /** How the text names the signals of what is drawn, and of `types` also outputs that nothing hears yet, which are not drawn. */
  signals(placed: Iterable<Placed> = this.shapes.placed.values(), types: BlockType[] = []): string[] {
    return [...placed].flatMap(({shape: {id, type, own, within, isPart, outputs: drawn}}) => {
      const known = isPart ? undefined : types.find((one) => one.name === type), outputs = known?.outputs.map(({name}) => ({port: name})) ?? drawn;
      if (within.length > 0 || own === "output" || id.startsWith(":constant:")) return [];
      if (own === "input") return [id.slice(":input:".length)];
      const name = id.slice(id.lastIndexOf(".") + 1);
      return outputs.map(({port}) => (outputs.length === 1 && !isPart ? name : `${name}.${port}`));
    });
  }

  /** How the file names the signal of an output that is drawn: names of parts down to it, block and port; "" for a number. */
  path({node, port}: {node: string; port: string}): string {
    if (node.startsWith(":constant:")) return "";
    if (node.startsWith(":input:")) return node.slice(":input:".length);
    return [...this.scope, ...this.relative(node), port].join(".");
  }

  /** Names from what is drawn down to a shape; those of shapes begin at what is drawn, or at the file. */
  relative(id: string): string[] {
    const names = id.split("."), isWhole = this.scope.length > 0 && names.length > this.scope.length && this.scope.every((name, i) => names[i] === name);
    return isWhole ? names.slice(this.scope.length) : names;
  }

  private range(id: string): TextRange | undefined {
    return this.ranges.of([...this.scope, id].join(".")) ?? this.ranges.of(id);
  }

  /** The drawn block of a shape or port of the text, or "". */
  private drawn(id: string): string {
    const whole = this.scope.join("."), own = whole && id.startsWith(`${whole}.`) ? id.slice(whole.length + 1) : id;
    const first = own.slice(0, Math.max(0, own.indexOf(".", 1))), upTo = (name: string) => name.slice(0, Math.max(0, name.lastIndexOf(".")));
    return [own, first, upTo(own), id, upTo(id)].find((name) => name !== "" && this.shapes.find(name)) ?? "";
  }
}
