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
const controls = "button, a[href], summary, [role=tab], [role=slider], [role=separator], [role=option], [role=listbox], [role=menuitem], input, [data-own-keys]";
/** These have none for Space. */
const spaceless = "[role=slider], [role=separator], input[type=range]";

/** Has whoever has the focus a use for a key? `data-own-keys` lists those of an element. */
function hasOwnKey(target: EventTarget | null, key: string): boolean {
  const control = target instanceof Element ? target.closest<HTMLElement>(controls) : null;
  if (!control || !ownKeys.has(key)) return false;
  if (control.dataset.ownKeys !== undefined) return control.dataset.ownKeys.split(" ").includes(key);
  return key !== "Space" || !control.matches(spaceless);
}

export class Shortcuts {
  private readonly all: Shortcut[] = [];
  /** The button that has the focus by a click: Space is not for it, but for the page. */
  private clicked: Element | null = null;

  constructor() {
    document.addEventListener("keydown", (event) => this.press(event));
    document.addEventListener("click", ({target, detail}) => { if (detail > 0) this.clicked = target instanceof Element ? target.closest("button") : null; });
    document.addEventListener("focusin", ({target}) => { if (target !== this.clicked) this.clicked = null; });
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
    const key = keyOf(event), plain = !key.startsWith("Ctrl+") && !key.startsWith("Alt+") && !/^(Shift\+)?F\d/.test(key);
    const isFree = key === "Space" && event.target === this.clicked;
    if (plain && (takesText(event.target) || (!isFree && hasOwnKey(event.target, key)))) return;
    const found = this.all.find((one) => one.key === key && (one.within?.() ?? true));
    if (!found) return;
    event.preventDefault();
    found.action(event);
  }
}
