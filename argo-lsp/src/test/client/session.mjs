// Types in a program of a thousand lines with a language server, and prints the measured times as JSON.
// node session.mjs FOLDER KEYS COMMAND…, where FOLDER has node_modules, KEYS is a number, and COMMAND starts the server.
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [folder, keys, ...command] = process.argv.slice(2);
const require = createRequire(join(folder, "package.json"));
const { createProtocolConnection, StreamMessageReader, StreamMessageWriter } = require("vscode-languageserver-protocol/node");

const project = mkdtempSync(join(tmpdir(), "argo-lsp-"));
const file = join(project, "robot.asl");
const uri = pathToFileURL(file).href;
writeFileSync(join(project, "robot.mas2j"), "MAS robot { agents: robot agentArchClass argo.Arch; }");
writeFileSync(join(project, "percepts"), "dist(front|left|right, cm 0..400)\nlight(left|right, % 0..100)\n");

const PLAN = (i) => [
  `// plan ${i}`, `+!go${i}(Speed) : dist(front, Cm) & Cm > ${i % 400} & not light(left, 0) <-`, `    argo.act(speed(Speed));`,
  `    .wait(100);`, `    !go${(i + 1) % 160}(Speed).`, "",
];
const lines = ["!go0(10).", "", ...Array.from({ length: 166 }, (_, i) => PLAN(i)).flat()].slice(0, 1000);
const TYPED = "\n+!turn(Side) : light(Side, L) & L > 50 <-\n    argo.act(turn(Side));\n    !go1(20).\n";

const begun = performance.now();
const server = spawn(command[0], command.slice(1), { stdio: ["pipe", "pipe", "pipe"] });
let errors = "";
server.stderr.on("data", (it) => (errors += it));
const connection = createProtocolConnection(new StreamMessageReader(server.stdout), new StreamMessageWriter(server.stdin));

let version = 0;
let waiting;
let stale = 0;
connection.onNotification("textDocument/publishDiagnostics", (said) => {
  if (said.version < version) stale++;
  else if (waiting) waiting(said.diagnostics);
});
connection.onNotification("window/logMessage", (it) => (errors += it.message));
connection.onNotification("window/showMessage", (it) => (errors += it.message));
connection.listen();

await connection.sendRequest("initialize", {
  processId: process.pid, rootUri: pathToFileURL(project).href,
  capabilities: { textDocument: { completion: { completionItem: { snippetSupport: true } } } },
});
await connection.sendNotification("initialized", {});
const startMs = performance.now() - begun;

const diagnosed = () => new Promise((done) => (waiting = (it) => ((waiting = undefined), done(it))));
let text = lines.join("\n") + "\n";
writeFileSync(file, text);
let answer = diagnosed();
await connection.sendNotification("textDocument/didOpen", { textDocument: { uri, languageId: "agentspeak", version: ++version, text } });
const first = await answer;
const openMs = performance.now() - begun;

await new Promise((done) => setTimeout(done, 2000)); // a user looks at a file before typing

const times = [];
async function replace(line, character, length, put) {
  const at = performance.now();
  answer = diagnosed();
  connection.sendNotification("textDocument/didChange", {
    textDocument: { uri, version: ++version },
    contentChanges: [{ range: { start: { line, character }, end: { line, character: character + length } }, text: put }],
  });
  const found = await answer;
  times.push(performance.now() - at);
  return found;
}

const position = (offset, typed) => {
  const before = TYPED.slice(0, typed).split("\n");
  return { line: offset + before.length - 1, character: before.at(-1).length };
};
const memory = () => Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${server.pid}/status`, "utf8"))?.[1] ?? 0) / 1024;

const MIDDLE = 497; // an empty line between two plans
let typed = 0;
let last = first;
const megabytes = [];
for (let key = 0; key < Number(keys); key++) {
  if (typed === TYPED.length) {
    const end = position(MIDDLE, typed);
    connection.sendNotification("textDocument/didChange", {
      textDocument: { uri, version: ++version },
      contentChanges: [{ range: { start: { line: MIDDLE, character: 0 }, end }, text: "" }],
    });
    typed = 0;
  }
  const { line, character } = position(MIDDLE, typed);
  last = await replace(line, character, 0, TYPED[typed++]);
  const here = { textDocument: { uri }, position: position(MIDDLE, typed) };
  if (key % 10 === 0) await connection.sendRequest("textDocument/completion", here);
  if (key % 25 === 0) await connection.sendRequest("textDocument/hover", here);
  if (key % 100 === 0) await connection.sendRequest("textDocument/documentSymbol", { textDocument: { uri } });
  if (key % 500 === 0) megabytes.push(Math.round(memory()));
}
await connection.sendRequest("shutdown");
const exit = new Promise((done) => server.on("exit", done));
await connection.sendNotification("exit");
const status = await exit;
rmSync(project, { recursive: true });

const sorted = times.toSorted((a, b) => a - b);
const part = (share) => Math.round(sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] * 10) / 10;
console.log(JSON.stringify({
  lines: lines.length, keys: times.length, startMs: Math.round(startMs), openMs: Math.round(openMs), medianMs: part(0.5), p95Ms: part(0.95), p99Ms: part(0.99),
  worstMs: part(1), stale, megabytes, status, first: first.length, last: last.length, errors,
}));
