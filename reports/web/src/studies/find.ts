// A search for scenes in which engines are wrong: all engines by one ruler, and each finding once, with the command that
// runs it again and shows its replay.
import type { Study } from "../data";
import { h, slug, table } from "../dom";
import { count, given, words } from "../format";
import { type StudyView } from "../model";
import { command } from "../pieces";

interface Engine {
  engine: string;
  scenes: number;
  not_supported: number;
  failed: number;
  wrong: number;
  compared: number;
  closed: number;
  energy_rise_median: number | null; // of the scene's energy range, like the shares
  "energy_rise_above_0.1_percent": number;
  "energy_rise_above_1_percent": number;
  overlap_median: number | null; // m
  overlap_nine_in_ten: number | null; // m
}

interface Found {
  name: string;
  engine: string;
  reason: string;
  words: string;
  times: number;
  from: string;
  posed: string; // "well", "ambiguous", "impossible"
  drawn_bodies: number;
  bodies: number;
  moving_bodies: number;
  file: string;
}

interface Search {
  scenes: number;
  engines: Engine[];
  found: Found[];
}

const most_shown = 500;

const percent = (share: number | null): string => (share === null ? "not finite" : `${given(100 * share, "", 2)} %`);
const millimetres = (length: number | null): string => (length === null ? "not finite" : given(1e3 * length, "mm", 2));

const cells = (heads: string[], texts: (string | HTMLElement)[]) => texts.map((text, index) => h("td", { "data-label": heads[index + 1] }, text));

const engine_heads = ["engine", "scenes", "not supported", "failed", "wrong", "energy up > .1 %", "> 1 %", "median rise", "deepest overlap, median", "9 in 10 below"];

function engine_row(one: Engine): HTMLTableRowElement {
  const numbers = [one.scenes, one.not_supported, one.failed, one.wrong].map(String);
  const shares = [one["energy_rise_above_0.1_percent"], one["energy_rise_above_1_percent"], one.energy_rise_median].map(percent);
  const depths = [one.overlap_median, one.overlap_nine_in_ten].map(millimetres);
  return h("tr", {}, h("th", { scope: "row" }, one.engine), ...cells(engine_heads, [...numbers, ...shares, ...depths]));
}

const found_heads = ["engine", "what, and what runs it again", "moving bodies", "from"];

const quoted = (engine: string) => (/[ :]/.test(engine) ? `"${engine}"` : engine);

// The replay shows the engine beside ours, or ours beside another of the search.
function beside(one: Found, engines: Engine[]): string {
  const others = ["impulse", ...engines.map((each) => each.engine)];
  const other = others.find((name) => name !== one.engine && !/^(fault|closed-form):/.test(name));
  return other === undefined ? "" : ` --engine ${quoted(other)}`;
}

function found_row(one: Found, engines: Engine[]): HTMLTableRowElement {
  const from = `${one.from}, ${one.drawn_bodies} ${one.drawn_bodies === 1 ? "body" : "bodies"}${one.posed === "well" ? "" : `, ${one.posed}`}`;
  const relations = one.reason.startsWith("relation ") ? " --relations" : "";
  const run = `./plumb run out/${one.file} --engine ${quoted(one.engine)}${beside(one, engines)}${relations}`;
  const again = /^(fault|closed-form):/.test(one.engine) ? "./plumb find --again out/found" : run;
  const what = h("div", { class: "told" }, words(one.words), command(again));
  return h("tr", { id: slug(one.name) }, h("th", { scope: "row" }, one.engine), ...cells(found_heads, [what, String(one.moving_bodies), from]));
}

export function find(study: Study): StudyView {
  const { scenes, engines, found } = study.findings as unknown as Search;
  const sentence = `${count(found.length, "finding")} in ${count(scenes, "random scene")}`;
  const compared = engines[0]?.compared ?? 0;
  const ruler = () =>
    h(
      "section",
      { id: slug("ruler") },
      h("h2", {}, "All engines by one ruler"),
      h(
        "p",
        { class: "lede" },
        `Energy and overlap are measured in the ${count(compared, "scene")} that every engine ran to the end, whatever they state about themselves; energy relative to the scene's range, where none comes from outside.`,
      ),
      table("All engines by one ruler", engine_heads, engines.map(engine_row)),
    );
  const scenes_found = () =>
    h(
      "section",
      { id: slug("found") },
      h("h2", {}, "Findings"),
      h("p", { class: "lede" }, "Each is told once, in the smallest scene that shows it. Its command writes a page with the replay."),
      table("Findings", found_heads, found.slice(0, most_shown).map((one) => found_row(one, engines))),
      found.length > most_shown ? h("p", { class: "basis" }, `And ${count(found.length - most_shown, "more finding")}.`) : null,
    );
  return { sentence, sections: [{ id: "ruler", name: "Engines", content: ruler }, { id: "found", name: "Findings", content: scenes_found }] };
}
