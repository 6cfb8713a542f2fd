// Light or dark: the system's choice, or the reader's own.

export type Choice = "system" | "light" | "dark";

export class Theme {
  private readonly dark = matchMedia("(prefers-color-scheme: dark)");
  private readonly still = matchMedia("(prefers-reduced-motion: reduce)");
  private readonly listeners = new Set<() => void>();
  private own: Choice = "system";

  constructor() {
    this.dark.addEventListener("change", () => this.show());
    this.show();
  }

  get choice(): Choice {
    return this.own;
  }

  choose(choice: Choice): void {
    this.own = choice;
    this.show();
  }

  get isDark(): boolean {
    return this.own === "system" ? this.dark.matches : this.own === "dark";
  }

  /** Shall nothing move by itself? */
  get isStill(): boolean {
    return this.still.matches;
  }

  /** The value of a token, as "--ink"; for canvases. */
  token(name: string): string {
    return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  }

  /** Calls the listener when colours change. Returns what ends it. */
  on(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  private show(): void {
    document.documentElement.dataset.theme = this.isDark ? "dark" : "light";
    for (const listener of [...this.listeners]) listener();
  }
}
