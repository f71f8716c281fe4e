// Takes every chart of a page as a picture of its own, without a browser:
//
//   node pictures.cjs PAGE.html FOLDER
//
// The page draws itself as it does for paper, in a document that knows no layout; so a chart is here as it is there.
import { mkdirSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { drawn } from "./drawn";
import { picture } from "./picture";

function main([page, folder]: string[]): void {
  if (!page || !folder) throw new Error("PAGE.html and FOLDER are needed");
  const { figures, palette } = drawn(readFileSync(page, "utf8"));
  mkdirSync(folder, { recursive: true });
  const names = new Set<string>();
  for (const figure of figures) {
    const { name, text } = picture(figure, palette);
    const file = join(folder, `${name}${names.has(name) ? `-${names.size}` : ""}.svg`);
    names.add(name);
    writeFileSync(`${file}.part`, text);
    renameSync(`${file}.part`, file);
  }
  if (!names.size) throw new Error(`${page} has no charts`);
  console.log(`${figures.length} pictures in ${folder}`);
}

try {
  main(process.argv.slice(2));
} catch (error) {
  console.error((error as Error).message);
  process.exitCode = 1;
}
