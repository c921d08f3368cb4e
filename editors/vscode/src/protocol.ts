// What the server offers beyond the Language Server Protocol. docs/editor.md describes it for other editors.

import {
  NotificationType,
  type Position,
  type Range,
  RequestType,
  type TextDocumentIdentifier,
  type WorkspaceEdit,
} from "vscode-languageclient/node";

import type { Camera, View } from "./shared/camera.ts";
import type { Size } from "./shared/fit.ts";

export type Quality = "draft" | "full";

export interface RenderParams {
  textDocument: TextDocumentIdentifier;
  /** Comes back in each frame. */
  id: number;
  /** The largest size that is of use; null for the file's own. */
  size: Size | null;
  /** In place of the file's own camera. */
  camera: Camera | null;
  quality: Quality;
  /** An edit lets it go on, with the text as it was. */
  despiteEdits: boolean;
}

export interface RenderResult {
  outcome: "done" | "cancelled" | "broken" | "failed";
  device: string | null;
  milliseconds: number | null;
  camera: View | null;
  error: { message: string; code?: string; range: Range | null } | null;
}

export interface Frame {
  uri: string;
  id: number;
  pass: number;
  final: boolean;
  width: number;
  height: number;
  /** Base64. */
  png: string;
}

export interface PickParams {
  textDocument: TextDocumentIdentifier;
  /** From 0 to 1 from the upper left corner. */
  x: number;
  y: number;
  camera: Camera | null;
}

export interface Picked {
  uri: string;
  name: string;
  /** The statement that made the object. */
  range: Range;
  selectionRange: Range;
}

export interface OutlineParams {
  textDocument: TextDocumentIdentifier;
  position: Position;
  size: Size | null;
  camera: Camera | null;
}

export interface Outline {
  name: string;
  /** Base64; transparent but for the outline. */
  png: string;
}

export interface ServerStatus {
  state: "ready" | "starting" | "restarting" | "down";
  device: string | null;
  milliseconds: number | null;
  message: string | null;
}

interface DocumentParams {
  textDocument: TextDocumentIdentifier;
}

export const render = new RequestType<RenderParams, RenderResult, void>("scene/render");
export const pick = new RequestType<PickParams, Picked | null, void>("scene/pick");
export const outline = new RequestType<OutlineParams, Outline | null, void>("scene/outline");
export const plan = new RequestType<DocumentParams, { markdown: string }, void>("scene/plan");
export const writeCamera = new RequestType<DocumentParams & { camera: Camera }, WorkspaceEdit | null, void>(
  "scene/writeCamera",
);
export const frame = new NotificationType<Frame>("scene/frame");
export const status = new NotificationType<ServerStatus>("scene/status");
