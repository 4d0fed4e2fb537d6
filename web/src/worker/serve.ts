// SPDX-License-Identifier: MIT
// The worker's end of the protocol: a module worker in browsers, a worker thread in Node. This file
// becomes kdmanifold-worker.js, in one piece, which needs no other file of the package.
import { open } from '../artefact.js';
import { buffersOf, fulfil, type Kept } from '../convert.js';
import { isNode, nodeModule } from '../environment.js';
import { KdManifoldError } from '../errors.js';
import type { KdManifold } from '../library.js';
import type { Reply, Request } from './protocol.js';

// TypeScript knows the types of a page or of a worker, never both at a time.
interface WorkerScope {
  onmessage: (event: MessageEvent<Request>) => void;
  postMessage(reply: Reply, transfer: ArrayBuffer[]): void;
}

type Post = (reply: Reply, transfer?: ArrayBuffer[]) => void;

// Milliseconds between reports of progress: often enough for a smooth bar, and at no cost.
const progressInterval = 30;

function serve(post: Post): (request: Request) => Promise<void> {
  let library: KdManifold | undefined;
  const kept: Kept = {};
  return async (request) => {
    try {
      if (request.type === 'start') {
        library = await open(request.artefact);
        post({ type: 'ready' });
        return;
      }
      let reported = 0;
      const onProgress = (fraction: number, phase: string): void => {
        const now = performance.now();
        if (now - reported < progressInterval && fraction < 1) return;
        reported = now;
        post({ type: 'progress', fraction, phase });
      };
      const outcome = fulfil(library as KdManifold, request.order, onProgress, kept);
      outcome.report.thread = 'worker';
      post({ type: 'done', outcome }, buffersOf(outcome.mesh, ...outcome.levels));
    } catch (error) {
      const known = error instanceof KdManifoldError;
      post({
        type: 'failed',
        code: known ? error.code : 'INTERNAL',
        message: known ? error.message : String(error),
      });
    }
  };
}

// No await at the top: bundlers' workers do not all allow it. Until Node's module is there, messages wait.
if (isNode()) {
  void nodeModule<typeof import('node:worker_threads')>('worker_threads').then(({ parentPort }) => {
    const handle = serve((reply, transfer) => parentPort?.postMessage(reply, transfer));
    parentPort?.on('message', (request: Request) => void handle(request));
  });
} else {
  const scope = globalThis as unknown as WorkerScope;
  const handle = serve((reply, transfer = []) => scope.postMessage(reply, transfer));
  scope.onmessage = (event) => void handle(event.data);
}
