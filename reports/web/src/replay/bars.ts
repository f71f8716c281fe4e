// Where the energy is: a bar for each engine, in three parts.
import { h } from "../dom";
import { number } from "../format";
import type { Film } from "./film";

const parts = ["linear", "rotational", "potential"] as const;

export class Bars {
  readonly element: HTMLElement;
  private readonly rows: { film: Film; row: HTMLElement; segments: HTMLElement[]; sum: HTMLElement }[];
  private readonly floor: number; // J, from which potential energy is counted
  private readonly span: number; // J, a whole bar

  constructor(films: Film[]) {
    const ranges = films.map((film) => film.energy_range());
    this.floor = Math.min(...ranges.map(({ floor }) => floor));
    this.span = Math.max(...ranges.map(({ top }) => top)) - this.floor || 1;
    this.rows = films.map((film) => {
      const segments = parts.map((part) => h("i", { class: part, style: `background-color: ${film.engine.color}` }));
      const sum = h("span", { class: "sum" });
      const row = h("div", { class: "bar" }, h("span", {}, film.engine.label), h("span", { class: "track", "aria-hidden": "true" }, ...segments), sum);
      return { film, row, segments, sum };
    });
    const key = h("p", { class: "key" }, ...parts.flatMap((part) => [h("i", { class: part }), part]), " (from its lowest)");
    this.element = h("div", { class: "bars" }, h("strong", {}, "Energy"), ...this.rows.map(({ row }) => row), key);
  }

  show(films: Film[]): void {
    for (const { film, row, segments, sum } of this.rows) {
      row.hidden = !films.includes(film);
      if (row.hidden) continue;
      const energy = film.energy();
      const joules = [energy.linear, energy.rotational, energy.potential - this.floor];
      segments.forEach((segment, k) => (segment.style.width = `${(100 * Math.max(0, joules[k] ?? 0)) / this.span}%`));
      sum.textContent = number(joules.reduce((a, b) => a + b), "J");
    }
  }
}
