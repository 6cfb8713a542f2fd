import type {BlockType} from "./reference";

/** Rates the match of a block type with the words of a search; 0 is no match. */
function score({name, folder, doc, keys = []}: BlockType, words: string[]): number {
  const lower = name.toLowerCase(), text = `${folder} ${doc} ${keys.join(" ")}`.toLowerCase();
  let sum = 0;
  for (const word of words) {
    const one = lower === word ? 100 : lower.startsWith(word) ? 50 : lower.includes(word) ? 25 : new RegExp(`\\b${word.replace(/[^\p{L}\p{N}]/gu, "\\$&")}`, "u").test(text) ? 8 : text.includes(word) ? 2 : 0;
    if (one === 0) return 0;
    sum += one;
  }
  return sum;
}

/** Returns the types that match all words, best first; without a word all of them in order. */
export function found(types: BlockType[], query: string): BlockType[] {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  if (words.length === 0) return types;
  return types.map((type) => ({type, points: score(type, words)})).filter(({points}) => points > 0)
    .sort((a, b) => b.points - a.points || a.type.name.length - b.type.name.length).map(({type}) => type);
}
