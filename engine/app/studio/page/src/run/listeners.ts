/** Listeners of an object, by the names of its events. */
export class Listeners<Events extends object> {
  private readonly all = new Map<keyof Events, Set<(event: never) => void>>();

  /** Adds a listener. Returns a function that removes it. */
  on<Name extends keyof Events>(name: Name, listener: (event: Events[Name]) => void): () => void {
    const own = this.all.get(name) ?? new Set();
    this.all.set(name, own.add(listener));
    return () => void own.delete(listener);
  }

  emit<Name extends keyof Events>(name: Name, event: Events[Name]): void {
    for (const listener of [...(this.all.get(name) ?? [])]) (listener as (event: Events[Name]) => void)(event);
  }
}
