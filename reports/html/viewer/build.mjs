// Builds ../static from src: the program of the page, the layout of graphs, the styles, and the licences of what is bundled.
import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const out = join(here, "..", "static");
const { dependencies } = JSON.parse(readFileSync(join(here, "package.json"), "utf8"));

const common = { bundle: true, minify: true, target: "es2022", legalComments: "none", charset: "ascii" };
await build({
  ...common,
  entryPoints: { report: join(here, "src/main.tsx") },
  outdir: out,
  format: "iife",
  jsx: "automatic",
  jsxImportSource: "preact",
});
await build({ ...common, entryPoints: { layout: join(here, "src/layout-worker.ts") }, outdir: out, format: "iife" });
await build({ ...common, entryPoints: { report: join(here, "src/styles/report.css") }, outdir: out });

const licences = Object.keys(dependencies).map((name) => {
  const folder = join(here, "node_modules", name);
  const { version, license, homepage } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  const file = readdirSync(folder).find((each) => /^licen[cs]e/i.test(each));
  return `${name} ${version}\n${license}\n${homepage ?? ""}\n\n${readFileSync(join(folder, file), "utf8").trim()}\n`;
});
writeFileSync(join(out, "THIRD_PARTY_LICENSES"), licences.join(`\n${"-".repeat(100)}\n\n`));
writeFileSync(join(out, "sources.sha256"), `${sourcesHash()}\n`);

/** A hash of all that the bundle is made of: names and contents, as tests/reports/test_html.py makes it. */
function sourcesHash() {
  const names = readdirSync(join(here, "src"), { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name).slice(here.length + 1));
  const hash = createHash("sha256");
  for (const name of [...names, "build.mjs", "package-lock.json"].sort()) {
    hash
      .update(`${name}\0`)
      .update(readFileSync(join(here, name)))
      .update("\0");
  }
  return hash.digest("hex");
}
