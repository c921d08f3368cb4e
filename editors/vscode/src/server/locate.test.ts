import assert from "node:assert/strict";
import { test } from "node:test";

import { type Located, locate, type Machine } from "./locate.ts";

const LINUX = { platform: "linux", path: "/usr/bin:bin::/opt/bin", home: "/home/ada" } as const;

function check(
  setting: string,
  files: string[],
  machine: Omit<Machine, "runs">,
  expect: Located | RegExp,
): void {
  const extension = machine.platform === "win32" ? "C:\\ext" : "/ext";
  const found = locate(setting, extension, { ...machine, runs: file => files.includes(file) });
  if (expect instanceof RegExp) {
    assert.ok(!found.found);
    assert.match(found.reason, expect);
  } else {
    assert.deepEqual(found, expect);
  }
}

test("a setting comes first and is never passed over", () => {
  const files = ["/my/scenec", "/ext/server/scenec", "/opt/bin/scenec", "/home/ada/bin/scenec"];
  check("/my/scenec", files, LINUX, { found: true, file: "/my/scenec", origin: "settings" });
  check("~/bin/scenec", files, LINUX, { found: true, file: "/home/ada/bin/scenec", origin: "settings" });
  check("/wrong/scenec", files, LINUX, /\/wrong\/scenec.*scenec\.server\.path/);
  check("bin/scenec", files, LINUX, /not an absolute path/);
});

test("the extension's own server comes before the one on the path", () => {
  const files = ["/ext/server/scenec", "/opt/bin/scenec"];
  check("", files, LINUX, { found: true, file: "/ext/server/scenec", origin: "extension" });
  check("", files.slice(1), LINUX, { found: true, file: "/opt/bin/scenec", origin: "PATH" });
  check("", ["bin/scenec", "scenec"], LINUX, /no scenec on the PATH/);
});

test("Windows has its own names", () => {
  const windows = { platform: "win32", path: "C:\\Windows;D:\\tools", home: "C:\\Users\\ada" } as const;
  check("", ["C:\\ext\\server\\scenec.exe"], windows, {
    found: true,
    file: "C:\\ext\\server\\scenec.exe",
    origin: "extension",
  });
  check("", ["D:\\tools\\scenec.exe"], windows, {
    found: true,
    file: "D:\\tools\\scenec.exe",
    origin: "PATH",
  });
});
