// The page's address: the id of an element and, after a "?", the view of the overview. "#bounce--e%3D0.8?engine=box2d"
// goes to a case, with an overview that shows box2d only. Links share both, and the browser's history restores them.
import { make_for, make_within, unfold_around } from "./folded";

/** Filters and order of the overview; empty: everything, in the listed order. */
export type View = URLSearchParams;

interface Address {
  id: string;
  view: View;
}

function parse(hash: string): Address {
  const [id = "", view = ""] = hash.replace(/^#/, "").split("?", 2);
  return { id, view: new URLSearchParams(view) };
}

const current = (): Address => parse(location.hash);

const watchers: ((view: View) => void)[] = [];

function set({ id, view }: Address, how: "pushState" | "replaceState"): void {
  const query = view.toString();
  history[how](null, "", `#${id}${query ? `?${query}` : ""}`);
}

/** Calls back with the view of the address, now and whenever it changes. */
export function watch(changed: (view: View) => void): void {
  watchers.push(changed);
  changed(current().view);
}

/** Changes the view and adds an entry to the browser's history, or replaces the current entry. */
export function show(view: View, replace = false): void {
  set({ id: "overview", view }, replace ? "replaceState" : "pushState");
  for (const changed of watchers) changed(view);
}

export const current_view = (): View => current().view;

/** Changes the view and stays where the reader is. */
export function show_here(view: View): void {
  set({ ...current(), view }, "replaceState");
  for (const changed of watchers) changed(view);
}

const find = (id: string): HTMLElement | null => document.getElementById(id) ?? document.getElementById(decodeURIComponent(id));

/** Folded parts may not exist yet: creates them if the id is not found. */
function element_of(id: string): HTMLElement | null {
  const found = find(id);
  if (found || !id) return found;
  make_for(id);
  return find(id);
}

/** Scrolls repeatedly: parts near the screen are laid out late and may change their size. */
function scroll_to(element: HTMLElement): void {
  element.scrollIntoView();
  let frames = 3;
  const again = (): void => {
    element.scrollIntoView();
    if (--frames) requestAnimationFrame(again);
  };
  requestAnimationFrame(again);
}

/**
 * Scrolls to the element of the address and unfolds it. If it is an engine's verdict (data-marks), highlights the rows of
 * that engine (data-engine) in its case.
 */
function arrive(): void {
  const element = element_of(current().id);
  for (const old of document.querySelectorAll(".linked")) old.classList.remove("linked");
  if (!element) return;
  unfold_around(element);
  const own = element.querySelector<HTMLDetailsElement>(":scope > details.whole");
  if (own) {
    make_within(own);
    own.open = true;
  }
  const engine = element.dataset["marks"];
  if (engine !== undefined) {
    const article = element.closest("article");
    if (article) make_within(article);
    for (const row of article?.querySelectorAll<HTMLElement>("[data-engine]") ?? []) {
      if (row.dataset["engine"] === engine) row.classList.add("linked");
    }
    element.classList.add("linked");
  }
  scroll_to(element);
  if (!element.matches("a, button, input, select, [tabindex]")) element.tabIndex = -1;
  element.focus({ preventScroll: true });
}

/** Called once, when the page is complete. */
export function follow_address(): void {
  if (current().id) arrive();
  addEventListener("popstate", () => {
    for (const changed of watchers) changed(current().view);
    arrive();
  });
  // Links inside the page keep the view.
  document.addEventListener("click", (event) => {
    const link = event.target instanceof Element ? event.target.closest('a[href^="#"]') : null;
    if (!link || event.defaultPrevented || event.button || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    set({ ...current(), ...parse_link(link.getAttribute("href") ?? "") }, "pushState");
    arrive();
  });
}

const parse_link = (href: string): Partial<Address> => (href.includes("?") ? parse(href) : { id: href.slice(1) });
