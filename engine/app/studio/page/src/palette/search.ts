import type {BlockType} from "./reference";

/** How well a type of block suits what is searched: 0 not at all. */
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

/** Types that have all words, the best first; all by their families without a word. */
export function found(types: BlockType[], query: string): BlockType[] {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  if (words.length === 0) return types;
  return types.map((type) => ({type, points: score(type, words)})).filter(({points}) => points > 0)
    .sort((a, b) => b.points - a.points || a.type.name.length - b.type.name.length).map(({type}) => type);
}
