// Every case against every engine: verdicts, each with a number, each leading to its evidence.
import { show, type View } from "../address";
import { h, slug } from "../dom";
import type { Case, Engine, Entry, Model } from "../model";
import { badge } from "../sections/pieces";
import type { Measure } from "./measures";
import { key_of, ordered, scenario, sorting, variant, type Key } from "./order";

function cell(entry: Entry | undefined, place: Case, head: string, measure: Measure): HTMLTableCellElement {
  if (!entry) return h("td", { class: "none", "data-label": head }, "\u2013");
  const { run, engine } = entry;
  const why = run.status === "ok" ? null : h("span", { class: "reason" }, run.reason);
  const link = h("a", { href: `#${slug(place.scenario, place.variant, engine.label)}` }, badge(run.verdict), measure.shown(entry), why);
  return h("td", { "data-label": head, "data-verdict": run.verdict }, link);
}

/** Sorts by its column; again: the other way; once more: as listed. */
function head(key: Key, view: View): HTMLTableCellElement {
  const { id, down } = sorting(view);
  const mine = id === key.id;
  const sign = h("span", { class: "direction", "aria-hidden": "true" }, mine ? (down ? "\u25be" : "\u25b4") : "\u25b4");
  const button = h("button", { type: "button", ...(mine ? { class: "sorted" } : {}) }, key.name, sign);
  button.addEventListener("click", () => {
    const next = new URLSearchParams(view);
    if (mine && !down) next.set("sort", `-${key.id}`);
    else if (mine) next.delete("sort");
    else next.set("sort", key.id);
    show(next);
    // The table was made anew.
    for (const made of document.querySelectorAll<HTMLElement>(".matrix thead button")) {
      if (made.firstChild?.textContent === key.name) made.focus();
    }
  });
  return h("th", { scope: "col", "aria-sort": mine ? (down ? "descending" : "ascending") : "none" }, button);
}

export function matrix(model: Model, engines: Engine[], view: View, measure: Measure): HTMLElement {
  const asked = sorting(view);
  let above = "";
  const rows = ordered(model, asked, measure).map((place) => {
    const first = place.scenario !== above;
    above = place.scenario;
    const name = h("th", { scope: "row" }, first ? h("a", { href: `#${slug(place.scenario)}` }, place.scenario) : h("span", { class: "unseen" }, place.scenario));
    const to_case = h("a", { href: `#${slug(place.scenario, place.variant)}` }, place.variant);
    const row = h("tr", first ? { class: "first" } : {}, name, h("td", { class: "variant" }, to_case));
    for (const engine of engines) {
      row.append(cell(place.entries.find(({ engine }) => engine === engine), place, engine.label, measure));
    }
    return row;
  });
  const caption = "Verdicts by case and engine";
  const heads = [scenario, variant, ...engines.map(key_of)].map((key) => head(key, view));
  return h(
    "div",
    { class: "table", tabindex: "0", role: "group", "aria-label": caption },
    h("table", { class: "matrix grouped" }, h("caption", {}, caption), h("thead", {}, h("tr", {}, ...heads)), h("tbody", {}, ...rows)),
  );
}
