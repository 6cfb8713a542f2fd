import {ChangeSet, Text} from "@codemirror/state";

export interface Change {
  from: number;
  to: number;
  text: string;
}

/** Returns a single change from the first text to the second: the range between their common start and end. */
export function difference(before: Text, after: Text): ChangeSet {
  const old = before.toString(), now = after.toString(), most = Math.min(old.length, now.length);
  let from = 0, end = 0;
  while (from < most && old[from] === now[from]) ++from;
  while (end < most - from && old[old.length - 1 - end] === now[now.length - 1 - end]) ++end;
  return ChangeSet.of({from, to: old.length - end, insert: now.slice(from, now.length - end)}, old.length);
}

/** Returns a set of changes in the server's format: all positions refer to the original text. */
export function listed(changes: ChangeSet): Change[] {
  const all: Change[] = [];
  changes.iterChanges((from, to, _a, _b, inserted) => all.push({from, to, text: inserted.toString()}));
  return all;
}

export const setOf = (changes: Change[], length: number) => ChangeSet.of(changes.map(({from, to, text}) => ({from, to, insert: text})), length);
