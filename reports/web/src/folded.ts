// Parts of the page that stand folded. Each is made when it is opened, or when the browser has nothing better to do: so
// a long page opens at once, and what is folded can still be searched.
import { h, type Child } from "./dom";

const unmade = new Map<HTMLDetailsElement, () => void>();

// Told before anything is drawn, and before anybody else can look; of "toggle" one is told later.
const opened = new MutationObserver((changes) => {
  for (const { target } of changes) make(target as HTMLDetailsElement);
});

function make(details: HTMLDetailsElement): void {
  const parts = unmade.get(details);
  unmade.delete(details);
  parts?.();
}

interface Look {
  kind?: "checks" | "more";
  open?: boolean;
}

export function folded(title: string, parts: () => Child[], { kind = "more", open = false }: Look = {}): HTMLDetailsElement {
  const details = h("details", { class: kind, ...(open ? { open: "" } : {}) }, h("summary", {}, title));
  unmade.set(details, () => {
    for (const part of parts()) if (part) details.append(part);
  });
  if (open) make(details);
  else opened.observe(details, { attributeFilter: ["open"] });
  return details;
}

/** All that an element holds, whether it is open or not; parts may hold further ones. */
export function make_within(element: Element): void {
  for (;;) {
    const inside = [...unmade.keys()].filter((details) => element.contains(details));
    if (!inside.length) return;
    inside.forEach(make);
  }
}

/** So that an element is seen. */
export function unfold_around(element: Element): void {
  for (let around = element.closest("details"); around; around = around.parentElement?.closest("details") ?? null) around.open = true;
}

/** Makes what is still unmade, bit by bit. Browsers that do not tell when they are idle make it when it is opened. */
export function make_when_idle(): void {
  globalThis.requestIdleCallback?.((idle) => {
    for (const details of unmade.keys()) {
      if (idle.timeRemaining() <= 0) return make_when_idle();
      make(details);
    }
  });
}

/** Opens everything; returns how to close again what was closed. */
export function unfold_all(): () => void {
  make_within(document.documentElement);
  const closed = [...document.querySelectorAll("details")].filter(({ open }) => !open);
  for (const details of closed) details.open = true;
  return () => {
    for (const details of closed) details.open = false;
  };
}
