// Tasks that check whole folders by the program itself; the problem matcher `$scenec` reads what they print.

import * as vscode from "vscode";

import type { Session } from "./server/session.ts";

const OPTIONS = { check: [], "check and fix": ["--fix"] } as const;

type Name = keyof typeof OPTIONS;

export class Tasks implements vscode.TaskProvider {
  readonly #session: Session;

  constructor(session: Session) {
    this.#session = session;
  }

  register(): vscode.Disposable {
    return vscode.tasks.registerTaskProvider("scenec", this);
  }

  provideTasks(): vscode.Task[] {
    const folders = vscode.workspace.workspaceFolders ?? [];
    const names = Object.keys(OPTIONS) as Name[];
    return folders.flatMap(folder =>
      names.flatMap(name => this.#task({ type: "scenec", task: name }, folder) ?? []),
    );
  }

  resolveTask(task: vscode.Task): vscode.Task | undefined {
    return this.#task(task.definition, task.scope);
  }

  #task(definition: vscode.TaskDefinition, scope: vscode.Task["scope"]): vscode.Task | undefined {
    const server = this.#session.locate();
    const options = Object.hasOwn(OPTIONS, definition.task) ? OPTIONS[definition.task as Name] : undefined;
    if (!server.found || options === undefined || scope === undefined) {
      return undefined;
    }
    const paths: string[] = Array.isArray(definition.paths) ? definition.paths.map(String) : [];
    const args = ["check", "--output-format", "concise", "--color", "never", ...options, "--", ...paths];
    const run = new vscode.ProcessExecution(server.file, args);
    return new vscode.Task(definition, scope, definition.task, "scenec", run, "$scenec");
  }
}
