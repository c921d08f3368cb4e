// The running server: found, started, watched over and started anew. Knows nothing of previews or commands; they ask it.

import { accessSync, constants } from "node:fs";
import { homedir } from "node:os";

import * as vscode from "vscode";
import {
  CloseAction,
  ErrorAction,
  type ErrorHandler,
  LanguageClient,
  type LanguageClientOptions,
  type Location,
  type Middleware,
  type NotificationType,
  type Position,
  type RequestType,
  State,
  type StaticFeature,
  TransportKind,
} from "vscode-languageclient/node";

import { Limit } from "./limit.ts";
import { type Located, locate } from "./locate.ts";

/** What the server is doing; `reason` says why where it is down. */
export interface SessionState {
  kind: "starting" | "running" | "down";
  reason?: string;
}

/** Where the documents lie that the server is told of. */
const SCHEMES = ["file", "untitled"];

/** A crash that comes back this often within this time is no accident. */
const CRASHES = { most: 4, within: 3 * 60_000 };

/** For requests that are wanted in any case: without any token the library would count one parameter more. */
const NEVER = new vscode.CancellationTokenSource().token;

/** Whether a file may be run, as far as the platform tells. */
function runs(file: string): boolean {
  try {
    accessSync(file, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

export class Session implements vscode.Disposable {
  readonly #extension: string;
  readonly #middleware: Middleware;
  readonly #log = vscode.window.createOutputChannel("Scene", { log: true });
  readonly #changed = new vscode.EventEmitter<SessionState>();
  readonly #listeners: ((client: LanguageClient) => void)[] = [];
  #client: LanguageClient | undefined;
  #state: SessionState = { kind: "down" };

  readonly onState = this.#changed.event;

  constructor(extension: string, middleware: Middleware) {
    this.#extension = extension;
    this.#middleware = middleware;
  }

  get state(): SessionState {
    return this.#state;
  }

  /** Whether the server runs and is told of such a document. */
  serves(document: vscode.TextDocument): boolean {
    return this.#state.kind === "running" && SCHEMES.includes(document.uri.scheme);
  }

  /** What the server calls itself, once it runs. */
  get version(): string | undefined {
    return this.#client?.initializeResult?.serverInfo?.version;
  }

  /** Where the server is, by the settings as they are now. */
  locate(): Located {
    const setting = vscode.workspace.getConfiguration("scenec").get("server.path", "");
    const machine = { platform: process.platform, path: process.env.PATH ?? "", home: homedir(), runs };
    return locate(setting.trim(), this.#extension, machine);
  }

  async start(): Promise<void> {
    const server = this.locate();
    if (!server.found) {
      this.#become({ kind: "down", reason: server.reason });
      void this.#complain(server.reason);
      return;
    }
    this.#log.info(`starting ${server.file} (from ${server.origin})`);
    const client = new LanguageClient("scenec", "Scene", serverOptions(server.file), this.#options());
    client.registerFeature(KNOWS_COMMANDS);
    client.onDidChangeState(event => this.#follow(client, event.newState));
    for (const listener of this.#listeners) {
      listener(client);
    }
    this.#client = client;
    try {
      await client.start();
    } catch (error) {
      this.#fail(client, `The server did not start: ${error instanceof Error ? error.message : error}`);
    }
  }

  async stop(): Promise<void> {
    const client = this.#client;
    this.#client = undefined;
    if (client !== undefined && client.state !== State.Stopped) {
      await client.stop().catch(error => this.#log.warn(`the server did not stop in good order: ${error}`));
    }
  }

  async restart(): Promise<void> {
    await this.stop();
    await this.start();
  }

  /** Calls back with every such notification, whichever process it comes from. */
  onNotification<P>(type: NotificationType<P>, handle: (params: P) => void): void {
    const listen = (client: LanguageClient) => void client.onNotification(type, handle);
    this.#listeners.push(listen);
    if (this.#client !== undefined) {
      listen(this.#client);
    }
  }

  /** Asks the server; undefined where there is none, or it has been told not to bother, or it fails. */
  async request<P, R>(type: RequestType<P, R, void>, params: P, token = NEVER): Promise<R | undefined> {
    const client = this.#client;
    if (client?.state !== State.Running) {
      return undefined;
    }
    try {
      return await client.sendRequest<R>(type.method, params, token);
    } catch (error) {
      if (!token.isCancellationRequested) {
        this.#log.warn(`${type.method}: ${error instanceof Error ? error.message : error}`);
      }
      return undefined;
    }
  }

  /** A file's name as the server writes it. */
  uri(uri: vscode.Uri): string {
    return this.#client?.code2ProtocolConverter.asUri(uri) ?? uri.toString();
  }

  /** An edit of the server's in the words of the editor. */
  async edit(edit: Parameters<LanguageClient["protocol2CodeConverter"]["asWorkspaceEdit"]>[0]) {
    return this.#client?.protocol2CodeConverter.asWorkspaceEdit(edit);
  }

  /** Shows places that the server found in the editor's own list. */
  async showPlaces(uri: string, place: Position, places: Location[]): Promise<void> {
    const convert = this.#client?.protocol2CodeConverter;
    if (convert !== undefined) {
      await vscode.commands.executeCommand(
        "editor.action.showReferences",
        convert.asUri(uri),
        convert.asPosition(place),
        places.map(it => convert.asLocation(it)),
      );
    }
  }

  showLog(): void {
    this.#log.show();
  }

  dispose(): void {
    void this.stop();
    this.#changed.dispose();
    this.#log.dispose();
  }

  #options(): LanguageClientOptions {
    return {
      documentSelector: SCHEMES.map(scheme => ({ language: "scene", scheme })),
      outputChannel: this.#log,
      initializationOptions: vscode.workspace.getConfiguration("scenec"),
      middleware: this.#middleware,
      errorHandler: this.#errorHandler(),
      markdown: { supportHtml: false },
    };
  }

  #errorHandler(): ErrorHandler {
    const crashes = new Limit(CRASHES.most, CRASHES.within);
    return {
      error: () => ({ action: ErrorAction.Continue }),
      closed: () => {
        if (crashes.allows(Date.now())) {
          this.#log.warn("the server ended by itself; starting it anew");
          return { action: CloseAction.Restart };
        }
        const reason = `The server ended ${CRASHES.most + 1} times within three minutes, and is left alone now.`;
        this.#become({ kind: "down", reason });
        void this.#complain(reason);
        return { action: CloseAction.DoNotRestart, handled: true };
      },
    };
  }

  #follow(client: LanguageClient, state: State): void {
    if (client !== this.#client) {
      return;
    }
    if (state === State.Running) {
      this.#become({ kind: "running" });
    } else if (state === State.Starting) {
      this.#become({ kind: "starting" });
    } else if (this.#state.kind !== "down") {
      this.#become({ kind: "down", reason: "The server has stopped." });
    }
  }

  #fail(client: LanguageClient, reason: string): void {
    if (client === this.#client) {
      this.#become({ kind: "down", reason });
      void this.#complain(reason);
    }
  }

  #become(state: SessionState): void {
    this.#state = state;
    this.#changed.fire(state);
  }

  async #complain(reason: string): Promise<void> {
    this.#log.error(reason);
    const [settings, restart, log] = ["Open Settings", "Restart", "Show Log"] as const;
    const choice = await vscode.window.showErrorMessage(`Scene: ${reason}`, settings, restart, log);
    if (choice === settings) {
      await vscode.commands.executeCommand("workbench.action.openSettings", "scenec.server.path");
    } else if (choice === restart) {
      await this.restart();
    } else if (choice === log) {
      this.showLog();
    }
  }
}

/** Tells the server that its lenses may name the commands of this extension. */
const KNOWS_COMMANDS: StaticFeature = {
  fillClientCapabilities(capabilities) {
    capabilities.experimental = { ...capabilities.experimental, scenec: { commands: true } };
  },
  initialize() {},
  getState: () => ({ kind: "static" }),
  clear() {},
};

function serverOptions(file: string) {
  return { command: file, args: ["lsp"], transport: TransportKind.stdio };
}
