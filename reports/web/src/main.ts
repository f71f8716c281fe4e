import { read } from "./data";
import { h, slug } from "./dom";
import { model_of } from "./model";
import { chapter_section } from "./sections/chapter";
import { method } from "./sections/method";
import { opening } from "./sections/opening";
import { overview } from "./sections/overview";
import { problems } from "./sections/problems";
import { sentence } from "./verdict";

const page = document.getElementById("page");
const outcome = read(document.getElementById("plumb-data")?.textContent);

if ("problems" in outcome) {
  page?.replaceChildren(problems(outcome.problems));
} else {
  const model = model_of(outcome.page);
  const places = [
    ["overview", "Overview"],
    ...model.chapters.map(({ name }) => [slug(name), name]),
    ["method", "Method"],
  ] as const;
  const links = places.map(([id, name]) => h("a", { href: `#${id ?? ""}` }, name ?? ""));
  document.title = `${outcome.page.report.title || "Plumb report"}: ${sentence(model)}`;
  page?.replaceChildren(
    opening(model),
    h("nav", { "aria-label": "Sections" }, ...links),
    h("main", {}, overview(model), ...model.chapters.map(chapter_section), method(model)),
  );
  // The sections were not there when the browser looked for the address's place.
  if (location.hash) document.getElementById(decodeURIComponent(location.hash.slice(1)))?.scrollIntoView();
}

addEventListener("beforeprint", () => {
  for (const closed of document.querySelectorAll("details")) closed.open = true;
});
