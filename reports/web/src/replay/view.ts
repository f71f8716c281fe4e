// The replay of a case: the stage and its controls, which follow the time of the case and the engines that are chosen for
// all charts. Created when it comes near the screen.
import { watch } from "../address";
import { Cursor } from "../charts/cursor";
import { when_near } from "../charts/figure";
import { chosen } from "../chosen";
import { h } from "../dom";
import { given, number } from "../format";
import type { Replayed } from "../model";
import { unpack_json } from "../packed";
import { Bars, button, check, choice, help, icon, listen, type Key } from "./controls";
import { scene_rule, type Replay, type Scene } from "./data";
import { Film } from "./film";
import { Figures } from "./outline";
import { Player, jumps_of, speeds, type Found, type Jump } from "./playback";
import { Stage, bounds_of, type Showing } from "./stage";

/** In larger scenes the signs of contacts cover the bodies. */
const most_with_contacts = 40; // bodies

/** On a narrower screen a few engines beside each other would be too small. */
const least_side_by_side = 600; // px

function scene_of(replay: Replay): Scene {
  const scene = unpack_json(replay.scene);
  const problems: string[] = [];
  scene_rule(scene, problems);
  if (problems.length) throw new Error(`scene${problems[0] ?? ""}`);
  return scene as Scene;
}

function films_of(item: Replayed, replay: Replay, bodies: number): Film[] {
  return item.entries.flatMap(({ engine, run }) => {
    const own = replay.runs.find(({ engine, method }) => engine === run.engine && method === run.method);
    return own ? [Film.of(engine, own, bodies)] : [];
  });
}

/** How exact the picture is. */
function fidelity(films: Film[]): string {
  const longest = Math.max(...films.map(({ run }) => run.length));
  const every = films.filter(({ run }) => run.every > 1);
  const thinned = every.map(({ engine, run }) => `${engine.label} every ${run.every} steps (error in between: up to ${number(run.between, "m", 2)})`);
  const missing = films.filter(({ engine, run }) => !engine.exact && run.contacts !== "kept");
  const none = missing.map(({ engine, run }) => `${engine.label} (${run.contacts === "none" ? "not reported" : "too many"})`);
  return [
    `Positions are rounded by up to ${number(longest / 2, "m", 2)}.`,
    thinned.length ? `Not every step is recorded: ${thinned.join(", ")}.` : "Every step is recorded.",
    none.length ? `No contacts: ${none.join(", ")}.` : "",
  ].join(" ");
}

class Replayer {
  readonly element: HTMLElement;
  private readonly view: Omit<Showing, "films">;
  private readonly stage: Stage;
  private readonly bars: Bars;
  private readonly player: Player;
  private readonly jumps: { jump: Jump; control: HTMLButtonElement }[];
  private readonly slider: HTMLInputElement;
  private readonly clock = h("span", { class: "clock" });
  private readonly play = button("Play", icon("play"), () => this.player.toggle());
  private readonly speed = choice("Speed", speeds.map((many) => [String(many), `${given(many)}\u00d7`] as const), (value) => {
    this.player.speed = Number(value);
  });
  private readonly followers: Replayer[] = []; // that its controls move as well
  private readonly options: Record<"side_by_side" | "contacts" | "velocities" | "energy" | "truth" | "loop", HTMLInputElement>;

  constructor(
    item: Replayed,
    scene: Scene,
    private readonly films: Film[],
    private readonly cursor: Cursor,
    { caption, led_by }: { caption?: string; led_by?: Replayer | undefined } = {},
  ) {
    const figures = new Figures(scene);
    const reference = films.find(({ engine }) => engine.exact) ?? films[0];
    if (!reference) throw new Error("there is no run to show");
    this.view = { side_by_side: innerWidth >= least_side_by_side || scene.bodies.length > most_with_contacts, contacts: scene.bodies.length <= most_with_contacts, velocities: false, ring: undefined };
    this.stage = new Stage(figures, films, bounds_of(reference, figures), () => ({ ...this.view, films: this.films_shown }));
    this.stage.canvas.setAttribute("aria-label", `Replay of ${item.scenario}, ${item.variant}`);
    this.bars = new Bars(films);
    this.player = new Player(cursor, () => this.follow());
    this.slider = h("input", { type: "range", min: "0", max: String(cursor.end), step: "any", value: "0", "aria-label": "Time" });
    this.slider.addEventListener("input", () => this.go(Number(this.slider.value)));
    this.jumps = jumps_of(item).map((jump) => ({ jump, control: button(`${jump.name}: ${jump.about}`, jump.name, () => this.jump(jump)) }));
    this.options = {
      side_by_side: check("Side by side", this.view.side_by_side, (on) => this.change({ side_by_side: on })),
      contacts: check("Contacts and impulses", this.view.contacts, (on) => this.change({ contacts: on })),
      velocities: check("Velocities", false, (on) => this.change({ velocities: on })),
      energy: check("Energy", true, (on) => (this.bars.element.hidden = !on)),
      truth: check("Truth", true, () => this.change({})),
      loop: check("Loop", false, (on) => (this.player.loop = on)),
    };
    this.element = h("div", { class: "replayer" }, h("div", { class: "pane" }, caption && h("p", { class: "basis" }, caption), this.stage.canvas));
    if (led_by) led_by.followers.push(this);
    else this.add_controls();
    cursor.on(() => this.follow());
    watch(() => this.follow());
  }

  private add_controls(): void {
    const keys = this.keys();
    this.element.append(
      this.transport(),
      h("div", { class: "row" }, ...this.jumps.map(({ control }) => control)),
      h("div", { class: "row" }, ...(["side_by_side", "contacts", "velocities", "energy"] as const).map((name) => this.label(name)), this.films.some(({ engine }) => engine.exact) ? this.label("truth") : null),
      this.bars.element,
      help(keys),
      h("p", { class: "fidelity" }, fidelity(this.films)),
    );
    listen(this.element, keys);
  }

  private each(action: (one: Replayer) => void): void {
    for (const one of [this, ...this.followers]) action(one);
  }

  private zoom_by(factor: number): void {
    this.each(({ stage }) => stage.zoom_by(factor));
  }

  private fit(): void {
    this.each(({ stage }) => stage.fit());
  }

  /** Of the engines that the page's legends choose. */
  private get films_shown(): Film[] {
    return chosen(this.films).filter(({ engine }) => this.options.truth.checked || !engine.exact);
  }

  private label(name: keyof Replayer["options"]): HTMLElement {
    const option = this.options[name];
    return h("label", {}, option, option.name);
  }

  private transport(): HTMLElement {
    this.speed.value = "1";
    return h(
      "div",
      { class: "row transport" },
      button("To the start", icon("start"), () => this.go(0)),
      button("A step back", icon("back"), () => this.step(-1)),
      this.play,
      button("A step forward", icon("on"), () => this.step(1)),
      this.slider,
      this.clock,
      this.speed,
      this.label("loop"),
      button("Zoom in", "+", () => this.zoom_by(1.5)),
      button("Zoom out", "\u2212", () => this.zoom_by(1 / 1.5)),
      button("Fit to the view", "Fit", () => this.fit()),
    );
  }

  private keys(): Key[] {
    const press = (name: keyof Replayer["options"]) => (): void => this.options[name].click();
    const pan = (x: number, y: number) => (): void => this.each(({ stage }) => stage.pan(0.1 * x, 0.1 * y));
    return [
      { keys: [" ", "k"], shown: "Space K", about: "play, pause", action: () => this.player.toggle() },
      { keys: ["ArrowLeft"], shown: "\u2190", about: "a step back; with Shift, ten", action: ({ shiftKey }) => this.step(shiftKey ? -10 : -1) },
      { keys: ["ArrowRight"], shown: "\u2192", about: "a step forward; with Shift, ten", action: ({ shiftKey }) => this.step(shiftKey ? 10 : 1) },
      { keys: ["Home"], shown: "Home", about: "to the start", action: () => this.go(0) },
      { keys: ["End"], shown: "End", about: "to the end", action: () => this.go(this.cursor.end) },
      { keys: ["ArrowUp", "]"], shown: "\u2191", about: "faster", action: () => this.player.faster(1) },
      { keys: ["ArrowDown", "["], shown: "\u2193", about: "slower", action: () => this.player.faster(-1) },
      ...this.jumps.map(({ jump }): Key => ({ keys: [jump.key], shown: jump.key, about: `${jump.name.toLowerCase()}: ${jump.about}`, action: () => this.jump(jump) })),
      { keys: ["l"], shown: "L", about: "loop", action: press("loop") },
      { keys: ["o"], shown: "O", about: "side by side, or on top of each other", action: press("side_by_side") },
      { keys: ["c"], shown: "C", about: "contact points, with the impulses of the last step on the second body (N s)", action: press("contacts") },
      { keys: ["v"], shown: "V", about: "velocities; an arrow is the displacement in 0.1 s", action: press("velocities") },
      { keys: ["e"], shown: "E", about: "energy", action: press("energy") },
      { keys: ["+", "="], shown: "+", about: "zoom in", action: () => this.zoom_by(1.5) },
      { keys: ["-"], shown: "\u2212", about: "zoom out", action: () => this.zoom_by(1 / 1.5) },
      { keys: ["0"], shown: "0", about: "fit to the view", action: () => this.fit() },
      { keys: ["a"], shown: "A", about: "look left", action: pan(1, 0) },
      { keys: ["d"], shown: "D", about: "look right", action: pan(-1, 0) },
      { keys: ["w"], shown: "W", about: "look up", action: pan(0, 1) },
      { keys: ["s"], shown: "S", about: "look down", action: pan(0, -1) },
    ];
  }

  private change(view: Partial<Showing>): void {
    this.each((one) => {
      Object.assign(one.view, view);
      one.follow();
    });
  }

  private go(time: number): void {
    this.view.ring = undefined;
    this.cursor.set(time);
    this.stage.draw();
  }

  /** Steps by the moments of the film with the most of them. */
  private step(by: number): void {
    this.player.pause();
    const [finest] = [...this.films_shown].sort((a, b) => b.times.length - a.times.length);
    if (!finest) return;
    const here = finest.moment_at(this.cursor.time);
    const between = this.cursor.time - (finest.times[here] ?? 0) > 1e-6;
    const next = here + by + Number(between && by < 0);
    this.go(finest.times[Math.min(finest.times.length - 1, Math.max(0, next))] ?? 0);
  }

  private jump(jump: Jump): void {
    const found = jump.find(this.films_shown);
    if (!found) return;
    this.player.pause();
    this.go(found.time);
    if (found.body !== undefined) this.view.ring = { film: found.film, body: found.body };
    this.follow();
  }

  private update_play_button(): void {
    const name = this.player.playing ? "Pause" : "Play";
    if (this.play.getAttribute("aria-label") === name) return;
    this.play.setAttribute("aria-label", name);
    this.play.title = name;
    this.play.replaceChildren(icon(this.player.playing ? "pause" : "play"));
  }

  private follow(): void {
    const films = this.films_shown;
    if (this.player.playing) this.view.ring = undefined;
    for (const film of films) film.go_to(this.cursor.time);
    this.stage.draw();
    this.bars.show(films);
    this.slider.value = String(this.cursor.time);
    const time = given(this.cursor.time, "s", 4);
    this.slider.setAttribute("aria-valuetext", time);
    this.clock.textContent = `${this.cursor.time.toFixed(3)}\u202fs of ${given(this.cursor.end, "s", 4)}`;
    this.update_play_button();
    this.speed.value = String(this.player.speed);
    for (const { jump, control } of this.jumps) update_jump(control, jump, jump.find(films));
  }
}

function update_jump(control: HTMLButtonElement, jump: Jump, found: Found | undefined): void {
  control.disabled = !found;
  const text = found ? `${jump.name}: ${given(found.time, "s", 3)} (${found.text})` : `${jump.name}: none`;
  if (control.textContent !== text) control.textContent = text;
}

/** Fills a figure when it comes near the screen. */
function figure(kind: string, title: string, content: () => HTMLElement[]): HTMLElement {
  const holder = h("div", { class: "stage" });
  when_near(holder, () => {
    try {
      holder.replaceChildren(...content());
    } catch (error) {
      holder.replaceChildren(h("p", { role: "alert" }, `This replay cannot be shown: ${(error as Error).message}`));
    }
    holder.dataset["ready"] = "";
  });
  return h("figure", { class: kind }, h("figcaption", {}, h("strong", {}, title)), holder);
}

export function replay_figure(item: Replayed, cursor: Cursor): HTMLElement | null {
  const { replay } = item;
  if (!replay?.runs.length) return null;
  return figure("replay", "Replay", () => {
    const scene = scene_of(replay);
    return [new Replayer(item, scene, films_of(item, replay, scene.bodies.length), cursor).element];
  });
}

/** Replays that play at the same time, by the controls of the first; two are beside each other, with what they show above. */
export function replays_together(items: Replayed[], title: string): HTMLElement {
  const several = items.length > 1;
  return figure(several ? "replay beside" : "replay", title, () => {
    const parts = items.flatMap((item) => {
      if (!item.replay) return [];
      const scene = scene_of(item.replay);
      return [{ item, scene, films: films_of(item, item.replay, scene.bodies.length) }];
    });
    const cursor = new Cursor(Math.max(0, ...parts.flatMap(({ films }) => films.map(({ end }) => end))));
    const all: Replayer[] = [];
    for (const { item, scene, films } of parts) all.push(new Replayer(item, scene, films, cursor, { caption: several ? item.variant : "", led_by: all[0] }));
    return all.map(({ element }) => element);
  });
}
