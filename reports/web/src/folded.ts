// Folded parts of the page. Each is created when it is opened or when the browser is idle, so that a long page opens at
// once and folded text can still be searched.
import { h, type Child } from "./dom";

const unmade = new Map<HTMLDetailsElement, () => void>();
const holding = new Map<HTMLDetailsElement, string>(); // those that are made on demand only, and the id around their parts

// A MutationObserver runs before the next paint and before other scripts; the event "toggle" comes too late.
const opened = new MutationObserver((changes) => {
  for (const { target } of changes) make(target as HTMLDetailsElement);
});

function make(details: HTMLDetailsElement): void {
  const parts = unmade.get(details);
  unmade.delete(details);
  parts?.();
}

interface Options {
  kind?: "checks" | "more" | "caveats";
  open?: boolean;
  /** The id of the element around it, with which the ids inside begin. A large report has too much of it to be made while the browser is idle. */
  holds?: string;
}

export function folded(title: Child | Child[], parts: () => Child[], { kind = "more", open = false, holds }: Options = {}): HTMLDetailsElement {
  const details = h("details", { class: kind, ...(open ? { open: "" } : {}) }, h("summary", {}, ...(Array.isArray(title) ? title : [title])));
  if (holds !== undefined) holding.set(details, holds);
  unmade.set(details, () => {
    for (const part of parts()) if (part) details.append(part);
  });
  if (open) make(details);
  else opened.observe(details, { attributeFilter: ["open"] });
  return details;
}

/** Creates all folded parts inside an element, including those inside other folded parts. */
export function make_within(element: Element): void {
  for (;;) {
    const inside = [...unmade.keys()].filter((details) => element.contains(details));
    if (!inside.length) return;
    inside.forEach(make);
  }
}

/** Creates the parts that may contain an id. */
export function make_for(id: string): void {
  const on_the_way = (holds: string): boolean => id === holds || id.startsWith(`${holds}--`);
  for (;;) {
    const inside = [...unmade.keys()].filter((details) => on_the_way(holding.get(details) ?? id));
    if (!inside.length) return;
    inside.forEach(make);
  }
}

/** Opens all folds around an element. */
export function unfold_around(element: Element): void {
  for (let around = element.closest("details"); around; around = around.parentElement?.closest("details") ?? null) around.open = true;
}

const patience = 1000; // ms between parts in a browser that is never idle, such as one of a busy machine

/** Creates the remaining parts while the browser is idle. Browsers without requestIdleCallback create them on opening. */
export function make_when_idle(): void {
  globalThis.requestIdleCallback?.(
    (idle) => {
      for (const details of unmade.keys()) {
        if (holding.has(details)) continue;
        make(details);
        if (idle.timeRemaining() <= 0) return make_when_idle();
      }
    },
    { timeout: patience },
  );
}

/** Opens everything; returns a function that closes it again. */
export function unfold_all(): () => void {
  make_within(document.documentElement);
  const closed = [...document.querySelectorAll("details")].filter(({ open }) => !open);
  for (const details of closed) details.open = true;
  return () => {
    for (const details of closed) details.open = false;
  };
}
