// A search for scenes in which engines are wrong: all engines by one ruler, and each finding once, with its replay beside
// that of another engine or of its image, and the command that runs it again.
import type { Study } from "../data";
import { h, slug, table } from "../dom";
import { folded } from "../folded";
import { count, enumerate, given, shell, words } from "../format";
import { look_of } from "../looks";
import { label_of, truth_look, type Replayed, type StudyView } from "../model";
import { command } from "../pieces";
import { replay_rule, type Replay } from "../replay/data";
import { replays_together } from "../replay/view";
import { list } from "../rules";

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
  job: string; // the key of the result with its replays
  engine: string;
  reason: string;
  words: string;
  times: number;
  from: string;
  posed: string; // "well", "ambiguous", "impossible", "overlapping"
  drawn_bodies: number;
  bodies: number;
  moving_bodies: number;
  file: string;
  image: string | null; // the file of the image, of a broken relation
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

/** Whether `plumb run` does not know it. */
const is_of_search = (engine: string): boolean => /^(fault|closed-form):/.test(engine);

// The replay shows the engine beside ours, or ours beside another of the search.
function beside(one: Found, engines: Engine[]): string[] {
  const others = ["impulse", ...engines.map((each) => each.engine)];
  const other = others.find((name) => name !== one.engine && !is_of_search(name));
  return other === undefined ? [] : ["--engine", other];
}

/** The engines of a replay have no records of their own. A closed form is a reference, unless it is what was searched. */
function replayed(replay: Replay, engine: string): Replayed {
  const entries = replay.runs.map((run) => {
    const exact = run.engine !== engine && run.engine.startsWith("closed-form:");
    const label = label_of(run);
    return { engine: { label, engine: run.engine, method: run.method, exact, execution: "", ...(exact ? truth_look : look_of(label)) }, run: { ...run, exact, status: "ok" as const } };
  });
  return { scenario: replay.scenario, variant: replay.variant, comparisons: [], entries, replay };
}

/** Made when it is opened: unpacking all replays of a search takes long. */
function replays(one: Found, study: Study): HTMLElement | null {
  const films = (study.results.find(({ key }) => key === one.job)?.values["run"] as { films?: unknown } | undefined)?.films;
  const problems: string[] = [];
  list(replay_rule)(films, problems);
  if (problems.length || !(films as Replay[]).length) return null;
  const items = (films as Replay[]).map((film) => replayed(film, one.engine));
  const [first, image] = items;
  const title = image ? "Replay beside its image" : `Replay of ${first?.entries.map(({ engine }) => engine.label).join(" and ") ?? ""}`;
  return folded(title, () => [replays_together(items, one.name)], { holds: slug(one.name) });
}

function found_article(one: Found, study: Study, engines: Engine[]): HTMLElement {
  const bodies = (many: number): string => `${many} ${many === 1 ? "body" : "bodies"}`;
  const posed = one.posed === "well" ? "" : `; ${one.posed}`;
  const at = (file: string): string => `${study.folder ?? "out"}/${file}`;
  const files = one.image === null ? at(one.file) : `${at(one.file)} and ${at(one.image)}`;
  const relations = one.reason.startsWith("relation ") ? ["--relations"] : [];
  const run = ["run", at(one.file), "--engine", one.engine, ...beside(one, engines), ...relations];
  const again = shell(["./plumb", ...(is_of_search(one.engine) ? ["find", "--again", at("found")] : run)]);
  return h(
    "article",
    { id: slug(one.name), class: "case finding" },
    h("h3", {}, one.engine),
    h("p", {}, words(one.words)),
    h("p", { class: "basis" }, `${bodies(one.bodies)}, ${one.moving_bodies} moving, cut down from ${one.from} with ${bodies(one.drawn_bodies)}${posed}. ${files}`),
    command(again),
    replays(one, study),
  );
}

const most_named = 5; // engines, in a headline

/** "Of 96 random scenes, impulse is wrong in 7, box2d in 12 and chipmunk in 33: 22 findings" */
function headline({ scenes, engines, found }: Search): string {
  const findings = count(found.length, "finding");
  if (!engines.length || engines.length > most_named) return `${findings} in ${count(scenes, "random scene")}`;
  const wrong = engines.map(({ engine, wrong }, index) => `${engine} ${index ? "" : "is wrong "}in ${wrong}`);
  return `Of ${count(scenes, "random scene")}, ${enumerate(wrong)}: ${findings}`;
}

export function find(study: Study): StudyView {
  const search = study.findings as unknown as Search;
  const { engines, found } = search;
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
      h("p", { class: "lede" }, "Each is told once, in the smallest scene that shows it."),
      ...found.slice(0, most_shown).map((one) => found_article(one, study, engines)),
      found.length > most_shown ? h("p", { class: "basis" }, `And ${count(found.length - most_shown, "more finding")}.`) : null,
    );
  return { sentence: headline(search), sections: [{ id: "ruler", name: "Engines", content: ruler }, { id: "found", name: "Findings", content: scenes_found }] };
}
