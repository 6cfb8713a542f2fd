/** Diagram of the gallery. */
export interface Entry {
  entry: number;
  name: string;
  title: string;
  group: string;
  caption?: string;
}

const plain = (text: string) => text.toLowerCase().normalize("NFD").replaceAll(/\p{M}/gu, "");

/** Rates the match of an entry with a word; 0 is no match. */
function fit({name, title, group, caption = ""}: Entry, word: string): number {
  const [inTitle, inName, inRest] = [plain(title), plain(name), plain(`${group} ${caption}`)];
  if (inTitle.split(/\W+/).includes(word) || inName.split(/\W+/).includes(word)) return 4;
  if (inTitle.includes(word) || inName.includes(word)) return 3;
  return inRest.includes(word) ? 1 : 0;
}

/** Splits a query into words; "figure 38" becomes fig38, as in the names of files. */
const words = (query: string) => plain(query).replaceAll(/\b(?:figure|fig\.?)\s*(\d+)/g, (_, number: string) => `fig${number.padStart(2, "0")}`).split(/\s+/).filter(Boolean);

/** Returns the entries that match all words of a query, best first; without a query all of them in order. */
export function found(entries: readonly Entry[], query: string): Entry[] {
  const wanted = words(query);
  if (wanted.length === 0) return [...entries];
  const rated = entries.map((entry) => ({entry, fits: wanted.map((word) => fit(entry, word))})).filter(({fits}) => fits.every((one) => one > 0));
  const sum = (fits: number[]) => fits.reduce((total, one) => total + one, 0);
  return rated.sort((a, b) => sum(b.fits) - sum(a.fits)).map(({entry}) => entry);
}
