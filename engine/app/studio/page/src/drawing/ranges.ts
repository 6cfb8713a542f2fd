import type {TextRange} from "./types";

/** Ranges of the drawn shapes in the texts. They move with edits until the next drawing. */
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

  /** Returns the block with the narrowest range around a range of a text. `blockOf` returns the drawn block of a shape or port, or "". */
  around(file: number, from: number, to: number, blockOf: (id: string) => string): string {
    let best = "", width = Infinity;
    for (const [id, range] of this.all) {
      if (range.file !== file || range.from > from || to > range.to || range.to - range.from >= width) continue;
      const block = blockOf(id);
      if (block) [best, width] = [block, range.to - range.from];
    }
    return best;
  }
}
