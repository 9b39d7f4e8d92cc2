// Prints the scopes that Visual Studio Code's reader of grammars gives to the words of a text: node grammar.mjs FOLDER EXTENSION < TEXT.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

const [folder, extension] = process.argv.slice(2);
const require = createRequire(join(folder, "package.json"));
const { Registry, parseRawGrammar, INITIAL } = require("vscode-textmate");
const oniguruma = require("vscode-oniguruma");

await oniguruma.loadWASM(readFileSync(require.resolve("vscode-oniguruma/release/onig.wasm")).buffer);
const grammars = { "source.agentspeak": "agentspeak", "source.mas2j": "mas2j" };
const registry = new Registry({
  onigLib: Promise.resolve({
    createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
    createOnigString: (text) => new oniguruma.OnigString(text),
  }),
  loadGrammar: async (scope) => {
    const file = join(extension, "syntaxes", `${grammars[scope]}.tmLanguage.json`);
    return parseRawGrammar(readFileSync(file, "utf8"), file);
  },
});
const grammar = await registry.loadGrammar("source.agentspeak");
let state = INITIAL;
for (const line of readFileSync(0, "utf8").trimEnd().split("\n")) {
  const read = grammar.tokenizeLine(line, state);
  state = read.ruleStack;
  for (const token of read.tokens) {
    const word = line.slice(token.startIndex, token.endIndex).trim();
    if (word) console.log(`${word} ${token.scopes.at(-1).replace(/\.agentspeak$/, "")}`);
  }
}
