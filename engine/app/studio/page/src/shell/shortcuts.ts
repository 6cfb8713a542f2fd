// Keys of the whole page. Each has a text for the list of "?".

export interface Shortcut {
  /** Key in its written form: "Ctrl+S", "Space", "Shift+F", "?". Ctrl also means Cmd. */
  key: string;
  text: string;
  action: (event: KeyboardEvent) => void;
  /** True where the key applies; by default everywhere except in fields and the editor. */
  within?: () => boolean;
  /** Group in the list. */
  group?: string;
}

const names: Record<string, string> = {" ": "Space", ArrowLeft: "Left", ArrowRight: "Right", ArrowUp: "Up", ArrowDown: "Down", Escape: "Esc"};
const isWritten = (key: string) => key.length === 1 && key.toLowerCase() === key.toUpperCase();

/** Returns a pressed key in the form of shortcuts. Symbols such as "?" omit the Shift that they need. */
export function keyOf(event: KeyboardEvent): string {
  const key = names[event.key] ?? (event.key.length === 1 ? event.key.toUpperCase() : event.key);
  const shift = event.shiftKey && !(isWritten(event.key) && event.key !== " ");
  return (event.ctrlKey || event.metaKey ? "Ctrl+" : "") + (event.altKey ? "Alt+" : "") + (shift ? "Shift+" : "") + key;
}

/** True if the focused element accepts letters. */
function takesText(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  const input = target instanceof HTMLInputElement && !["checkbox", "radio", "range", "button"].includes(target.type);
  return input || target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement || target.isContentEditable;
}

/** Keys that buttons and other controls use themselves. */
const ownKeys = new Set(["Space", "Enter", "Left", "Right", "Up", "Down", "Home", "End", "PageUp", "PageDown"]);
const controls = "button, a[href], summary, [role=tab], [role=slider], [role=separator], [role=option], [role=listbox], [role=menuitem], input, [data-own-keys]";
/** Controls that do not use Space. */
const spaceless = "[role=slider], [role=separator], input[type=range]";

/** True if the focused element uses a key itself; `data-own-keys` lists the keys of an element. */
function hasOwnKey(target: EventTarget | null, key: string): boolean {
  const control = target instanceof Element ? target.closest<HTMLElement>(controls) : null;
  if (!control || !ownKeys.has(key)) return false;
  if (control.dataset.ownKeys !== undefined) return control.dataset.ownKeys.split(" ").includes(key);
  return key !== "Space" || !control.matches(spaceless);
}

export class Shortcuts {
  private readonly all: Shortcut[] = [];
  /** Button that was focused by a click: it leaves Space to the page. */
  private clicked: Element | null = null;

  constructor() {
    document.addEventListener("keydown", (event) => this.press(event));
    document.addEventListener("click", ({target, detail}) => { if (detail > 0) this.clicked = target instanceof Element ? target.closest("button") : null; });
    document.addEventListener("focusin", ({target}) => { if (target !== this.clicked) this.clicked = null; });
  }

  /** Adds a key, with precedence over earlier ones. Returns a function that removes it. */
  add(shortcut: Shortcut): () => void {
    this.all.unshift(shortcut);
    return () => { this.all.splice(this.all.indexOf(shortcut), 1); };
  }

  /** Returns all keys in the order in which they were added. */
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
