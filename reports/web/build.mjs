// Bundles src/ into one self-contained page, and pictures/ into a program for Node.js that saves the page's charts as SVG
// files. With a second argument also writes both as C++ functions.
//
//   node build.mjs [page.html] [page.cpp]
import { build } from "esbuild";
import { existsSync } from "node:fs";
import { readFile, writeFile, mkdir } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));

async function bundle(entry, options = {}) {
  const result = await build({
    entryPoints: [join(here, entry)],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: "es2020",
    charset: "ascii",
    legalComments: "eof",
    logLevel: "warning",
    ...options,
  });
  return result.outputFiles[0].text.trim();
}

/** The rows of the tables of reports/glossary.md, a copy of which may stand here: [word, meaning], without markup. */
async function glossary() {
  const file = [join(here, "glossary.md"), join(here, "..", "glossary.md")].find((file) => existsSync(file));
  const plain = (cell) => cell.replaceAll("`", "").replaceAll("*", "").replace(/\[(.*?)\]\(.*?\)/g, "$1").trim();
  const rows = (await readFile(file, "utf8")).matchAll(/^\| (.+?) \| (.+) \|$/gm);
  return [...rows].map(([, word, meaning]) => [plain(word), plain(meaning)]).filter(([word]) => word !== "word");
}

/** Replaces a marker; a function as replacement keeps `$&` in the text as it is. */
function insert(page, mark, text) {
  if (page.split(mark).length !== 2) throw new Error(`page.html must contain ${mark} once`);
  return page.replace(mark, () => text);
}

/** A C++ function that returns the text, joined from pieces because compilers limit the length of a literal. */
function as_cpp(name, text) {
  const pieces = [];
  let piece = "";
  for (const character of text) {
    if (piece.length >= 8000) {
      pieces.push(piece);
      piece = "";
    }
    piece += character;
  }
  pieces.push(piece);
  const literals = pieces.map((text) => `    R"plumb~(${text})plumb~",`).join("\n");
  return `std::string_view ${name}() {
  static const std::string_view pieces[] = {
${literals}
  };
  static const std::string text = [] {
    std::string whole;
    for (const std::string_view piece : pieces) whole += piece;
    return whole;
  }();
  return text;
}
`;
}

const source = (functions) => `#include "reports/writers/html.h"

#include <string>

namespace plumb {

${functions.join("\n")}
}  // namespace plumb
`;

const [html_file = join(here, "dist", "page.html"), cpp_file] = process.argv.slice(2);
const style = await bundle("src/style.css");
// "</script" inside a string of the bundle would end the element.
const define = { PLUMB_GLOSSARY: JSON.stringify(await glossary()) };
const script = (await bundle("src/main.ts", { define })).replaceAll("</script", "<\\/script");
let page = await readFile(join(here, "src", "page.html"), "utf8");
page = insert(page, "/*style*/", style);
page = insert(page, "/*script*/", script);
if (page.split("<!--plumb-data-->").length !== 2) throw new Error("the page must contain <!--plumb-data--> once");
await mkdir(dirname(html_file), { recursive: true });
await writeFile(html_file, page);
const pictures = await bundle("pictures/pictures.ts", { platform: "node", format: "cjs", target: "node18" });
await writeFile(join(dirname(html_file), "pictures.cjs"), pictures);
if (cpp_file) await writeFile(cpp_file, source([as_cpp("page_template", page), as_cpp("picture_program", pictures)]));
