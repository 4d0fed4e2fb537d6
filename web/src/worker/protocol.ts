// SPDX-License-Identifier: MIT
// What the two ends of the worker say to each other.
import type { Artefact } from '../artefact.js';
import type { Order, Outcome } from '../convert.js';
import type { ErrorCode } from '../errors.js';

/** To the worker: the compiled module, once unless it cannot be started, then one conversion after the other. */
export type Request = { type: 'start'; artefact: Artefact } | { type: 'order'; order: Order };

/** From the worker: `ready`, or `failed` if the module cannot be started, then for each conversion `progress`, and `done` or `failed`. */
export type Reply =
  | { type: 'ready' }
  | { type: 'progress'; fraction: number; phase: string }
  | { type: 'done'; outcome: Outcome }
  | { type: 'failed'; code: ErrorCode; message: string };

/** A worker of either kind, as the caller's end sees it. */
export interface WorkerPort {
  post(request: Request, transfer: ArrayBuffer[]): void;
  /** Sets who hears replies and who hears of the worker's end. */
  listen(onReply: (reply: Reply) => void, onDeath: (reason: string) => void): void;
  /** Whether the worker keeps the process alive (Node only). */
  hold(alive: boolean): void;
  /** Ends the worker. Resolves when it is gone, as far as that can be known. */
  terminate(): Promise<void>;
}
