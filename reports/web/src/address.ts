// The page's address: a place and, after a "?", the view of the overview: "#bounce--e%3D0.8?engine=box2d" is a case,
// while the overview shows box2d alone. A link shares both, and going back finds the view as it was.

import { make_within, unfold_around } from "./folded";

/** What the overview shows; empty: everything, as it is listed. */
export type View = URLSearchParams;

interface Address {
  place: string;
  view: View;
}

function parse(hash: string): Address {
  const [place = "", view = ""] = hash.replace(/^#/, "").split("?", 2);
  return { place, view: new URLSearchParams(view) };
}

const present = (): Address => parse(location.hash);

const watchers: ((view: View) => void)[] = [];

function set({ place, view }: Address, how: "pushState" | "replaceState"): void {
  const query = view.toString();
  history[how](null, "", `#${place}${query ? `?${query}` : ""}`);
}

/** Calls back with the view of the address, now and whenever it is another. */
export function watch(tell: (view: View) => void): void {
  watchers.push(tell);
  tell(present().view);
}

/** Changes the view, as a step that can be gone back; `lasting` takes the place of the present one. */
export function show(view: View, lasting = false): void {
  set({ place: "overview", view }, lasting ? "replaceState" : "pushState");
  for (const tell of watchers) tell(view);
}

const standing_at = (place: string): HTMLElement | null =>
  document.getElementById(place) ?? document.getElementById(decodeURIComponent(place));

function element_at(place: string): HTMLElement | null {
  const found = standing_at(place);
  if (found || !place) return found;
  make_within(document.documentElement);
  return standing_at(place);
}

/** What comes near is laid out only then, and may be another size than was thought. */
function bring_to(element: HTMLElement): void {
  element.scrollIntoView();
  let frames = 3;
  const again = (): void => {
    element.scrollIntoView();
    if (--frames) requestAnimationFrame(again);
  };
  requestAnimationFrame(again);
}

/** Goes to the address's place and unfolds what hides it. What it asks for (data-asks) is marked (data-of) beside it. */
function arrive(): void {
  const element = element_at(present().place);
  for (const asked of document.querySelectorAll(".asked")) asked.classList.remove("asked");
  if (!element) return;
  unfold_around(element);
  const asked = element.dataset["asks"];
  if (asked !== undefined) {
    const article = element.closest("article");
    if (article) make_within(article);
    for (const of of article?.querySelectorAll<HTMLElement>("[data-of]") ?? []) {
      if (of.dataset["of"] === asked) of.classList.add("asked");
    }
    element.classList.add("asked");
  }
  bring_to(element);
  if (!element.matches("a, button, input, select, [tabindex]")) element.tabIndex = -1;
  element.focus({ preventScroll: true });
}

/** To be called when the page stands. */
export function follow_address(): void {
  if (present().place) arrive();
  addEventListener("popstate", () => {
    for (const tell of watchers) tell(present().view);
    arrive();
  });
  // Links keep the view.
  document.addEventListener("click", (event) => {
    const link = event.target instanceof Element ? event.target.closest('a[href^="#"]') : null;
    if (!link || event.defaultPrevented || event.button || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    set({ ...present(), ...parse_link(link.getAttribute("href") ?? "") }, "pushState");
    arrive();
  });
}

const parse_link = (href: string): Partial<Address> => (href.includes("?") ? parse(href) : { place: href.slice(1) });
