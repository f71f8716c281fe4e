// A command line, and a button that copies it.
import { h } from "../dom";
import type { Report } from "../data";
import { shell } from "../format";

/** The clipboard, or where the browser keeps that from files the old way. */
export async function copy(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = h("textarea", { class: "unseen", "aria-hidden": "true" }, text);
    document.body.append(area);
    area.select();
    const copied = document.execCommand("copy");
    area.remove();
    return copied;
  }
}

export function copy_button(line: string): HTMLElement {
  const button = h("button", { type: "button", class: "copy", "aria-label": `Copy ${line}` }, "Copy");
  button.addEventListener("click", () => {
    void copy(line).then((copied) => {
      button.textContent = copied ? "Copied" : "Select it by hand";
    });
  });
  return h("span", { role: "status" }, button);
}

export function command(line: string): HTMLElement {
  return h("div", { class: "command" }, h("code", {}, line), copy_button(line));
}

/** A scene file is asked for by its path, which is its case's name. */
const is_file = (variant: string): boolean => variant.endsWith(".json") || variant.includes("/");

const case_word = (scenario: string, variant: string): string => (is_file(variant) ? variant : variant ? `${scenario}:${variant}` : scenario);

/** Of the line that made the report: options that choose or judge runs, with their values. */
const kept: Record<string, number> = { "--converged": 0, "--ensemble": 1, "--engine": 1, "--dt": 1 };

/** What makes the numbers of one case again. */
export function case_command({ command }: Report, scenario: string, variant: string): string {
  const options = command.flatMap((word, index) => (word in kept ? command.slice(index, index + 1 + (kept[word] ?? 0)) : []));
  return shell(["./plumb", "run", case_word(scenario, variant), ...options]);
}

export interface OneRun {
  scenario: string;
  variant: string;
  engine: string; // as --engine takes it
  setting: string; // key=value, or ""
  dt: string; // as --dt takes it
  converged?: boolean;
}

export function run_command({ scenario, variant, engine, setting, dt, converged = false }: OneRun): string {
  const entrant = setting ? `${engine}${engine.includes(":") ? "," : ":"}${setting}` : engine;
  const truth = converged ? ["--converged"] : [];
  return shell(["./plumb", "run", case_word(scenario, variant), "--engine", entrant, "--dt", dt, ...truth]);
}
