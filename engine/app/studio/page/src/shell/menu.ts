import {h, listen} from "./dom";

/** Opens a menu below a button, or at a point of the window; keys are arrows, Enter, Esc. Closing it restores the focus. */
export function openMenu(at: HTMLElement | {x: number; y: number}, entries: [string, () => void][], label = "Menu"): void {
  document.querySelector(".menu")?.remove();
  const before = document.activeElement as HTMLElement | null;
  const ends: (() => void)[] = [];
  const close = () => {
    ends.forEach((end) => end());
    menu.remove();
    before?.focus();
  };
  const items = entries.map(([text, action]) =>
    h("button", {type: "button", role: "menuitem", class: "plain menu-item", tabindex: -1, onclick: () => { close(); action(); }}, text));
  const menu = h("div", {class: "menu", role: "menu", "aria-label": label}, ...items);
  document.body.append(menu);
  place(menu, at);
  ends.push(listen(menu, "keydown", (event: KeyboardEvent) => press(event, items, close)),
    listen(document, "pointerdown", (event: PointerEvent) => { if (!menu.contains(event.target as Node)) close(); }));
  items[0]?.focus();
}

function place(menu: HTMLElement, at: HTMLElement | {x: number; y: number}): void {
  const box = at instanceof HTMLElement ? at.getBoundingClientRect() : undefined;
  const [x, y] = at instanceof HTMLElement ? [box!.left, box!.bottom + 2] : [at.x, at.y];
  menu.style.setProperty("left", `${Math.max(4, Math.min(x, innerWidth - menu.offsetWidth - 6))}px`);
  menu.style.setProperty("top", `${Math.max(4, Math.min(y, innerHeight - menu.offsetHeight - 6))}px`);
}

function press(event: KeyboardEvent, items: HTMLElement[], close: () => void): void {
  const now = items.indexOf(document.activeElement as HTMLElement), last = items.length - 1;
  const next: Record<string, number> = {ArrowDown: now === last ? 0 : now + 1, ArrowUp: now <= 0 ? last : now - 1, Home: 0, End: last};
  if (event.key === "Escape" || event.key === "Tab") close();
  else if (event.key in next) items[next[event.key]].focus();
  else return;
  event.preventDefault();
  event.stopPropagation();
}
