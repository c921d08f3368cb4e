// Where the server is: the one that the settings name, the one that came with the extension, the one on the PATH. Knows
// nothing of the editor, so that a test can ask it about machines that do not exist.

import path from "node:path";

export interface Machine {
  platform: NodeJS.Platform;
  /** The variable PATH. */
  path: string;
  home: string;
  /** Whether this file is there and may be run. */
  runs(file: string): boolean;
}

export type Located =
  | { found: true; file: string; origin: "settings" | "extension" | "PATH" }
  | { found: false; reason: string };

/** The server, or why there is none. A setting that leads nowhere is told of, and never passed over. */
export function locate(setting: string, extension: string, machine: Machine): Located {
  const program = machine.platform === "win32" ? "scenec.exe" : "scenec";
  const paths = machine.platform === "win32" ? path.win32 : path.posix;
  if (setting !== "") {
    const file = setting.startsWith("~/") ? paths.join(machine.home, setting.slice(2)) : setting;
    if (!paths.isAbsolute(file)) {
      return { found: false, reason: `The setting scenec.server.path is not an absolute path: ${setting}` };
    }
    return machine.runs(file)
      ? { found: true, file, origin: "settings" }
      : {
          found: false,
          reason: `There is no program at ${file}, which the setting scenec.server.path names.`,
        };
  }
  const bundled = paths.join(extension, "server", program);
  if (machine.runs(bundled)) {
    return { found: true, file: bundled, origin: "extension" };
  }
  const folders = machine.path.split(paths.delimiter).filter(folder => paths.isAbsolute(folder));
  const file = folders.map(folder => paths.join(folder, program)).find(file => machine.runs(file));
  return file === undefined
    ? {
        found: false,
        reason: "This extension came without a server for this machine, and there is no scenec on the PATH.",
      }
    : { found: true, file, origin: "PATH" };
}
