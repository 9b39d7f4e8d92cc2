// Debugs a driving agent. Stops it at a breakpoint, reads its beliefs and variables, takes a step, and continues. Prints the results as
// JSON. If the agent is paused at the beginning, as in a replay, it first continues to the breakpoint. It then runs on when the session
// ends.
// node session.mjs FOLDER PORT FILE LINE, where FOLDER has node_modules, and the agent's program FILE has a step in LINE.
import { createRequire } from "node:module";
import { join } from "node:path";

const [folder, port, path, line] = process.argv.slice(2);
const { DebugClient } = createRequire(join(folder, "package.json"))("@vscode/debugadapter-testsupport");

const client = new DebugClient("node", "none", "argo");
await client.start(Number(port));
const capabilities = (await client.initializeRequest({ adapterID: "argo", linesStartAt1: true, pathFormat: "path" })).body;
const initialized = client.waitForEvent("initialized");
await client.attachRequest({});
await initialized;
const breakpoints = (await client.setBreakpointsRequest({ source: { path }, breakpoints: [{ line: Number(line) }, { line: 999 }] })).body
  .breakpoints;
await client.setExceptionBreakpointsRequest({ filters: [] });
const threads = (await client.threadsRequest()).body.threads;
process.on("unhandledRejection", (refused) => {
  console.error(refused.stack, JSON.stringify(stops));
  process.exit(1);
});
const stops = [];
const stopped = async (request) => {
  const event = client.waitForEvent("stopped", 20_000);
  await request();
  stops.push((await event).body);
};
await stopped(() => client.configurationDoneRequest());
const threadId = stops[0].threadId;
const stood = stops[0].reason === "pause";
if (stood) await stopped(() => client.continueRequest({ threadId }));
const frames = (await client.stackTraceRequest({ threadId })).body.stackFrames;
const scopes = (await client.scopesRequest({ frameId: frames[0].id })).body.scopes;
const variables = {};
for (const scope of scopes) {
  variables[scope.name] = (await client.variablesRequest({ variablesReference: scope.variablesReference })).body.variables;
}
const evaluate = async (expression) => {
  try {
    return (await client.evaluateRequest({ expression, frameId: frames[0].id })).body.result;
  } catch (refused) {
    return `refused: ${refused.message}`;
  }
};
const answers = [];
for (const formula of ["X", "dist(f,D) & D == X", "dist(f,1)", ".print(X)", "dist("]) answers.push(await evaluate(formula));
await client.setBreakpointsRequest({ source: { path }, breakpoints: [] });
await stopped(() => client.nextRequest({ threadId }));
const after = (await client.stackTraceRequest({ threadId })).body.stackFrames;
let late;
if (!stood) {
  const continued = client.waitForEvent("continued");
  await client.continueRequest({ threadId });
  await continued;
  await stopped(() => client.pauseRequest({ threadId }));
  late = await client.evaluateRequest({ expression: "X", frameId: frames[0].id }).then(() => "answered", (refused) => refused.message);
}
await client.disconnectRequest({});
console.log(JSON.stringify({ capabilities, breakpoints, threads, stops, frames, variables, answers, after, late }));
client.disconnect?.();
process.exit(0);
