// Keys of the whole page. Each has a text, which "?" lists.

export interface Shortcut {
  /** As a person reads it: "Ctrl+S", "Space", "Shift+F", "?". Ctrl is also Cmd. */
  key: string;
  text: string;
  action: (event: KeyboardEvent) => void;
  /** Where the key holds; without it everywhere but in fields and the editor. */
  within?: () => boolean;
  /** Group in the list. */
  group?: string;
}

const names: Record<string, string> = {" ": "Space", ArrowLeft: "Left", ArrowRight: "Right", ArrowUp: "Up", ArrowDown: "Down", Escape: "Esc"};
const isWritten = (key: string) => key.length === 1 && key.toLowerCase() === key.toUpperCase();

/** A pressed key as shortcuts write it. Signs such as "?" are written without the Shift that they need. */
export function keyOf(event: KeyboardEvent): string {
  const key = names[event.key] ?? (event.key.length === 1 ? event.key.toUpperCase() : event.key);
  const shift = event.shiftKey && !(isWritten(event.key) && event.key !== " ");
  return (event.ctrlKey || event.metaKey ? "Ctrl+" : "") + (event.altKey ? "Alt+" : "") + (shift ? "Shift+" : "") + key;
}

/** Does whoever has the focus take letters? */
function takesText(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  const input = target instanceof HTMLInputElement && !["checkbox", "radio", "range", "button"].includes(target.type);
  return input || target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement || target.isContentEditable;
}

/** Buttons and the like have uses of their own for these keys. */
const ownKeys = new Set(["Space", "Enter", "Left", "Right", "Up", "Down", "Home", "End", "PageUp", "PageDown"]);
const hasOwnKeys = (target: EventTarget | null) =>
  target instanceof Element && target.closest("button, a[href], summary, [role=tab], [role=slider], [role=separator], [role=option], [role=listbox], [role=menuitem], input, [data-own-keys]") !== null;

export class Shortcuts {
  private readonly all: Shortcut[] = [];

  constructor() {
    document.addEventListener("keydown", (event) => this.press(event));
  }

  /** Adds a key; a later one goes before an earlier one. Returns what removes it. */
  add(shortcut: Shortcut): () => void {
    this.all.unshift(shortcut);
    return () => { this.all.splice(this.all.indexOf(shortcut), 1); };
  }

  /** All keys, in the order in which they were added. */
  list(): readonly Shortcut[] {
    return [...this.all].reverse();
  }

  private press(event: KeyboardEvent): void {
    if (event.defaultPrevented || event.isComposing || document.querySelector("dialog[open]")) return;
    const key = keyOf(event), plain = !key.startsWith("Ctrl+") && !key.startsWith("Alt+") && !/^F\d/.test(key);
    if (plain && (takesText(event.target) || (ownKeys.has(key) && hasOwnKeys(event.target)))) return;
    const found = this.all.find((one) => one.key === key && (one.within?.() ?? true));
    if (!found) return;
    event.preventDefault();
    found.action(event);
  }
}
