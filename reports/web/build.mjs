// Bundles src/ into one self-contained page; with a second argument also writes it as C++.
//
//   node build.mjs [page.html] [page.cpp]
import { build } from "esbuild";
import { readFile, writeFile, mkdir } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));

async function bundle(entry) {
  const result = await build({
    entryPoints: [join(here, "src", entry)],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: "es2020",
    charset: "ascii",
    legalComments: "eof",
    logLevel: "warning",
  });
  return result.outputFiles[0].text.trim();
}

/** A function as replacement, so that `$&` in the text stays what it is. */
function place(page, mark, text) {
  if (page.split(mark).length !== 2) throw new Error(`page.html must hold ${mark} once`);
  return page.replace(mark, () => text);
}

/** Compilers limit the length of one literal, not of an array of them. */
function as_cpp(page) {
  const pieces = [];
  let piece = "";
  for (const character of page) {
    if (piece.length >= 8000) {
      pieces.push(piece);
      piece = "";
    }
    piece += character;
  }
  pieces.push(piece);
  const literals = pieces.map((text) => `    R"plumb~(${text})plumb~",`).join("\n");
  return `#include "reports/writers/page.h"

#include <string>

namespace plumb {

std::string_view page_template() {
  static constexpr std::string_view pieces[] = {
${literals}
  };
  static const std::string page = [] {
    std::string whole;
    for (const std::string_view piece : pieces) whole += piece;
    return whole;
  }();
  return page;
}

}  // namespace plumb
`;
}

const [html_file = join(here, "dist", "page.html"), cpp_file] = process.argv.slice(2);
const style = await bundle("style.css");
// "</script" inside a string of the bundle would end the element.
const script = (await bundle("main.ts")).replaceAll("</script", "<\\/script");
let page = await readFile(join(here, "src", "page.html"), "utf8");
page = place(page, "/*style*/", style);
page = place(page, "/*script*/", script);
if (page.split("<!--plumb-data-->").length !== 2) throw new Error("the page must hold <!--plumb-data--> once");
await mkdir(dirname(html_file), { recursive: true });
await writeFile(html_file, page);
if (cpp_file) await writeFile(cpp_file, as_cpp(page));
