// The time that a case's replay and charts show together.

export class Cursor {
  private now = 0;
  private readonly listeners = new Set<() => void>();

  constructor(readonly end: number) {} // s

  get time(): number {
    return this.now;
  }

  set(time: number): void {
    const next = Math.min(this.end, Math.max(0, time));
    if (next === this.now) return;
    this.now = next;
    for (const listener of this.listeners) listener();
  }

  /** Tells of every change; returns how to stop that. */
  on(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}
