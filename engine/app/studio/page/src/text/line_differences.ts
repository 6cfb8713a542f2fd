const most = 2000;  // lines without common start and end; beyond it all of them count as different

/** Returns the indices of the lines of two texts that are not in their longest common subsequence. */
export function differentLines(ours: string[], theirs: string[]): {ours: Set<number>; theirs: Set<number>} {
  let first = 0, end = 0;
  const shorter = Math.min(ours.length, theirs.length);
  while (first < shorter && ours[first] === theirs[first]) ++first;
  while (end < shorter - first && ours[ours.length - 1 - end] === theirs[theirs.length - 1 - end]) ++end;
  const a = ours.slice(first, ours.length - end), b = theirs.slice(first, theirs.length - end);
  const different = {ours: new Set(a.keys()), theirs: new Set(b.keys())};
  if (a.length <= most && b.length <= most) for (const [i, j] of common(a, b)) { different.ours.delete(i); different.theirs.delete(j); }
  const moved = (lines: Set<number>) => new Set([...lines].map((line) => line + first));
  return {ours: moved(different.ours), theirs: moved(different.theirs)};
}

/** Returns a longest common subsequence of lines, as pairs of indices. */
function common(a: string[], b: string[]): [number, number][] {
  const lengths = Array.from({length: a.length + 1}, () => new Uint16Array(b.length + 1));
  for (let i = a.length - 1; i >= 0; --i)
    for (let j = b.length - 1; j >= 0; --j) lengths[i][j] = a[i] === b[j] ? lengths[i + 1][j + 1] + 1 : Math.max(lengths[i + 1][j], lengths[i][j + 1]);
  const pairs: [number, number][] = [];
  for (let i = 0, j = 0; i < a.length && j < b.length;) {
    if (a[i] === b[j]) pairs.push([i++, j++]);
    else if (lengths[i + 1][j] >= lengths[i][j + 1]) ++i;
    else ++j;
  }
  return pairs;
}
