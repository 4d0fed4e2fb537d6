// SPDX-License-Identifier: MIT
// Starts a worker and hands it the compiled module, or finds out why that cannot be.
import { isNode } from '../environment.js';
import type { Source } from '../load-options.js';
import type { Artefact } from '../artefact.js';
import { compile } from '../load.js';
import { openWorker } from './ports.js';
import type { WorkerPort } from './protocol.js';

/** A worker that is ready, or the reason why there is none. */
export type Start = { port: WorkerPort } | { reason: string };

// Milliseconds that a worker may take from its start to its first word, its script's loading included.
const patience = 60_000;

/** Starts one worker, with so many threads, while the module is compiled. Rejects if the module cannot be had. */
export async function start(source: Source, threads: number): Promise<Start> {
  const violations = watchPolicy();
  const compiling = compile(source, threads);
  compiling.catch(() => {}); // told below
  let port: WorkerPort | undefined;
  try {
    // The script is loaded while the module is compiled.
    port = await openWorker(source);
    const artefact = await Promise.race([compiling, deathOf(port)]);
    let refusal = await greet(port, artefact);
    // Where there can be no threads after all, one does the same.
    if (refusal !== null && artefact.threads > 1) {
      refusal = await greet(port, await compile(source, 1));
    }
    if (refusal !== null) throw new Error(refusal);
    return { port };
  } catch (error) {
    void port?.terminate();
    await compiling; // its failure is the one to tell
    return {
      reason: violations.reason() ?? (error instanceof Error ? error.message : String(error)),
    };
  } finally {
    violations.end();
  }
}

const ignore = (): void => {};

/** Rejects if the worker dies before it is greeted. */
function deathOf(port: WorkerPort): Promise<never> {
  return new Promise((_, reject) => port.listen(ignore, (reason) => reject(new Error(reason))));
}

/** Resolves to null when the worker is ready, or to what it says why not; rejects if it says nothing. */
function greet(port: WorkerPort, artefact: Artefact): Promise<string | null> {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(
      () => reject(new Error(`it did not answer; is its script kdmanifold/worker?`)),
      patience,
    );
    const settle = (act: () => void): void => {
      clearTimeout(timer);
      act();
    };
    port.listen(
      (reply) =>
        settle(() =>
          resolve(
            reply.type === 'ready'
              ? null
              : 'message' in reply
                ? reply.message
                : `it said ${reply.type}`,
          ),
        ),
      (reason) => settle(() => reject(new Error(reason))),
    );
    try {
      port.post({ type: 'start', artefact }, []);
    } catch (error) {
      settle(() => reject(error));
    }
  });
}

/** Listens for what a page's content-security policy forbids meanwhile: the worker itself is not told. */
function watchPolicy(): { reason(): string | null; end(): void } {
  const { document } = globalThis as { document?: Document };
  if (isNode() || document === undefined) return { reason: () => null, end: ignore };
  let found: string | null = null;
  const hear = (event: SecurityPolicyViolationEvent): void => {
    const { effectiveDirective, blockedURI } = event;
    if (!/^(worker|script|child)-src/.test(effectiveDirective)) return;
    found = `the content-security policy's ${effectiveDirective} does not allow ${blockedURI || 'it'}`;
  };
  document.addEventListener('securitypolicyviolation', hear);
  return {
    reason: () => found,
    end: () => document.removeEventListener('securitypolicyviolation', hear),
  };
}
