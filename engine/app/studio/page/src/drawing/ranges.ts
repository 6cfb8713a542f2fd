import type {TextRange} from "./types";

/** Where the shapes of a drawing stand in the texts; ranges move with edits until the next drawing. */
export class Ranges {
  private all = new Map<string, TextRange>();

  take(ranges: Record<string, TextRange>): void {
    this.all = new Map(Object.entries(ranges));
  }

  of(id: string): TextRange | undefined {
    return this.all.get(id);
  }

  move(file: number, at: (position: number, side: number) => number): void {
    for (const [id, range] of this.all) if (range.file === file) this.all.set(id, {file, from: at(range.from, 1), to: at(range.to, -1)});
  }

  /** The shape with the narrowest range around a place in a text. */
  around(file: number, from: number, to: number): string | undefined {
    const around = [...this.all].filter(([, range]) => range.file === file && range.from <= from && to <= range.to);
    return around.sort(([, a], [, b]) => a.to - a.from - (b.to - b.from))[0]?.[0];
  }

  /** Files that are drawn, the most frequent one first. */
  files(): number[] {
    const counts = new Map<number, number>();
    for (const {file} of this.all.values()) counts.set(file, (counts.get(file) ?? 0) + 1);
    return [...counts].sort(([, a], [, b]) => b - a).map(([file]) => file);
  }
}
