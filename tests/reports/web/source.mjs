// A source of the page as a module, for what needs no browser.
import { build } from "esbuild";
import { fileURLToPath } from "node:url";

export async function source(name) {
  const entry = fileURLToPath(new URL(`../src/${name}`, import.meta.url));
  const bundle = await build({ entryPoints: [entry], bundle: true, write: false, format: "esm" });
  return import(`data:text/javascript;base64,${Buffer.from(bundle.outputFiles[0].text).toString("base64")}`);
}
