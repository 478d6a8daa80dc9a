// Bundles src/ and the three libraries into cadgen/viewer/page/static: script and style sheet of the page, those that `cadgen edit`
// adds, and the licences.
// Run `npm ci` first: it installs exactly what package-lock.json names, and compares every package with its hash.
import { build } from "esbuild";
import { readFileSync, writeFileSync } from "node:fs";

const out = "../cadgen/viewer/page/static";
const common = { bundle: true, minify: true, charset: "utf8", legalComments: "none", logLevel: "warning" };

await build({ ...common, entryPoints: ["src/main.js"], outfile: `${out}/page.js`, format: "iife", target: "es2022" });
await build({ ...common, entryPoints: ["src/page.css"], outfile: `${out}/page.css`, target: ["chrome109", "safari16"] });
await build({ ...common, entryPoints: ["src/edit/main.js"], outfile: `${out}/edit.js`, format: "iife", target: "es2022" });
await build({ ...common, entryPoints: ["src/edit.css"], outfile: `${out}/edit.css`, target: ["chrome109", "safari16"] });

for (const name of ["page.js", "page.css", "edit.js", "edit.css"]) {
  // Inline in HTML: nothing in them may end its element. A line break at the end would be outside of the hash.
  const text = readFileSync(`${out}/${name}`, "utf8").trimEnd();
  if (/<\/(script|style)|<!--/i.test(text)) {
    writeFileSync(`${out}/${name}`, text.replace(/<\/(script|style)/gi, "<\\/$1").replace(/<!--/g, "<\\!--"));
  } else {
    writeFileSync(`${out}/${name}`, text);
  }
}

const { dependencies } = JSON.parse(readFileSync("package.json", "utf8"));
const licences = Object.keys(dependencies).map((name) => {
  const { version, license } = JSON.parse(readFileSync(`node_modules/${name}/package.json`, "utf8"));
  return `${name} ${version} (${license})\n\n${readFileSync(`node_modules/${name}/LICENSE`, "utf8").trim()}\n`;
});
writeFileSync(`${out}/LICENSES.txt`, `The page's script contains these libraries.\n\n${licences.join(`\n${"-".repeat(72)}\n\n`)}`);
