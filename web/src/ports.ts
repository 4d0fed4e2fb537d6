// SPDX-License-Identifier: MIT
// Starts a worker: of the browser's kind or of Node's, whichever there is.
import { isNode, nodeModule } from './environment.js';
import type { Reply, WorkerPort } from './protocol.js';

/** Starts a worker. Resolves to null where there are none or they are not allowed. */
export async function openWorker(): Promise<WorkerPort | null> {
  try {
    return isNode() ? await openThread() : openWebWorker();
  } catch {
    return null;
  }
}

async function openThread(): Promise<WorkerPort> {
  const { Worker } = await nodeModule<typeof import('node:worker_threads')>('worker_threads');
  // The worker does not get the flags of the process: workers refuse some of them.
  const worker = new Worker(new URL('./worker.js', import.meta.url), { execArgv: [] });
  let hear: (reply: Reply) => void = () => {};
  let mourn: (reason: string) => void = () => {};
  worker.on('message', (reply: Reply) => hear(reply));
  worker.on('error', (error) => mourn(String(error)));
  worker.on('exit', (status) => mourn(`it ended with status ${status}`));
  return {
    post: (request, transfer) => worker.postMessage(request, transfer),
    listen: (onReply, onDeath) => ((hear = onReply), (mourn = onDeath)),
    hold: (alive) => (alive ? worker.ref() : worker.unref()),
    terminate: () => void worker.terminate(),
  };
}

function openWebWorker(): WorkerPort | null {
  if (typeof Worker !== 'function') return null;
  // Bundlers recognise this very form and bundle the worker.
  const worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
  return {
    post: (request, transfer) => worker.postMessage(request, transfer),
    listen(onReply, onDeath) {
      worker.onmessage = (event: MessageEvent<Reply>) => onReply(event.data);
      worker.onerror = (event) => onDeath(event.message || 'the worker could not be started');
      worker.onmessageerror = () => onDeath('a message of the worker could not be read');
    },
    hold: () => {},
    terminate: () => worker.terminate(),
  };
}
