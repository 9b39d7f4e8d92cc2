// The client of ARGO's language server, the way to its debugger, and commands that run things in a terminal.
const { existsSync } = require("node:fs");
const { join } = require("node:path");
const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

const LANGUAGES = [
  { scheme: "file", language: "agentspeak" },
  { scheme: "file", language: "mas2j" },
  { scheme: "file", pattern: "**/filters/**/*.{xml,json}" },
];

let client;

exports.activate = async (context) => {
  const own = join(context.extensionPath, "argo.jar");
  const register = (name, run) => context.subscriptions.push(vscode.commands.registerCommand(name, run));
  register("argo.run", runProject);
  register("argo.demo", () => inTerminal("ARGO demo", tool(own, "demo --view")));
  register("argo.ports", () => inTerminal("ARGO ports", tool(own, "ports")));
  register("argo.restart", () => client?.restart());
  const factory = { createDebugAdapterDescriptor: (session) => new vscode.DebugAdapterServer(session.configuration.port) };
  context.subscriptions.push(vscode.debug.registerDebugAdapterDescriptorFactory("argo", factory));
  await start(own);
};

exports.deactivate = () => client?.stop();

async function start(own) {
  const jar = jarOf(own);
  if (!jar) {
    const open = "Settings";
    const message = "There is no argo.jar: put it into lib/ of the project, or name it in the setting argo.jar.";
    if ((await vscode.window.showErrorMessage(message, open)) === open)
      vscode.commands.executeCommand("workbench.action.openSettings", "argo.jar");
    return;
  }
  // a quick start matters more to a server of texts than the speed that a compiler reaches after minutes
  const args = ["-XX:+UseSerialGC", "-Xmx512m", "-jar", jar, "lsp"];
  client = new LanguageClient("argo", "ARGO", { command: setting("java"), args }, {
    documentSelector: LANGUAGES,
    synchronize: { fileEvents: vscode.workspace.createFileSystemWatcher("**/{*.asl,*.mas2j,*.ino,percepts,filters/**}") },
  });
  await client.start();
}

const setting = (name) => vscode.workspace.getConfiguration("argo").get(name);

const folder = () => vscode.workspace.workspaceFolders?.[0]?.uri.fsPath;

/** The setting, the project's own, or the one in this extension; undefined: there is none. */
const jarOf = (own) => [setting("jar"), folder() && join(folder(), "lib", "argo.jar"), own].find((it) => it && existsSync(it));

const tool = (own, command) => `${setting("java")} -jar "${jarOf(own)}" ${command}`;

function inTerminal(name, command) {
  const terminal = vscode.window.terminals.find((it) => it.name === name) ?? vscode.window.createTerminal({ name, cwd: folder() });
  terminal.show();
  terminal.sendText(command);
}

async function runProject() {
  await vscode.workspace.saveAll(false);
  const has = (file) => folder() && existsSync(join(folder(), file));
  const wrapper = process.platform === "win32" ? "gradlew.bat" : "./gradlew";
  const build = has("pom.xml") ? "mvn -q compile exec:exec" : has("gradlew") ? `${wrapper} -q --console=plain run` : "gradle -q run";
  inTerminal("ARGO project", setting("run") || build);
}
