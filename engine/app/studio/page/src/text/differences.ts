import {ChangeSet, Text} from "@codemirror/state";

export interface Change {
  from: number;
  to: number;
  text: string;
}

/** One change that makes the second text of the first: all between what both begin and end with. */
export function difference(before: Text, after: Text): ChangeSet {
  const old = before.toString(), now = after.toString(), most = Math.min(old.length, now.length);
  let from = 0, end = 0;
  while (from < most && old[from] === now[from]) ++from;
  while (end < most - from && old[old.length - 1 - end] === now[now.length - 1 - end]) ++end;
  return ChangeSet.of({from, to: old.length - end, insert: now.slice(from, now.length - end)}, old.length);
}

/** A set of changes as the server takes it: all refer to the text before. */
export function listed(changes: ChangeSet): Change[] {
  const all: Change[] = [];
  changes.iterChanges((from, to, _a, _b, inserted) => all.push({from, to, text: inserted.toString()}));
  return all;
}

export const setOf = (changes: Change[], length: number) => ChangeSet.of(changes.map(({from, to, text}) => ({from, to, insert: text})), length);
