// SPDX-License-Identifier: MIT
// Starts a worker: of the browser's kind or of Node's, whichever there is.
import { isNode, nodeModule, resolveAddress } from '../environment.js';
import type { WorkerOptions } from '../load-options.js';
import type { WorkerLike } from '../outside-types.js';
import { movedAddress, neighbour, nodeAddress } from '../package-address.js';
import { openAddress } from './open-address.js';
import type { Reply, WorkerPort } from './protocol.js';

const file = 'kdmanifold-worker.js';

/** Starts a worker. Rejects, with a reason for people, where there are none or they are not allowed. */
export async function openWorker(options: WorkerOptions): Promise<WorkerPort> {
  const { worker } = options;
  if (worker) return portOf(typeof worker === 'function' ? worker() : worker);
  return isNode() ? openThread(options) : portOf(await openWebWorker(options));
}

async function openThread({ workerUrl }: WorkerOptions): Promise<WorkerPort> {
  const { Worker } = await nodeModule<typeof import('node:worker_threads')>('worker_threads');
  const url = await (workerUrl === undefined ? nodeAddress(file) : resolveAddress(workerUrl));
  // The worker does not get the flags of the process: workers refuse some of them.
  const worker = new Worker(url, { execArgv: [] });
  let hear: (reply: Reply) => void = () => {};
  let mourn: (reason: string) => void = () => {};
  worker.on('message', (reply: Reply) => hear(reply));
  worker.on('error', (error) => mourn(String(error)));
  worker.on('exit', (status) => mourn(`it ended with status ${status}`));
  return {
    post: (request, transfer) => worker.postMessage(request, transfer),
    listen: (onReply, onDeath) => ((hear = onReply), (mourn = onDeath)),
    hold: (alive) => (alive ? worker.ref() : worker.unref()),
    terminate: () => worker.terminate().then(() => {}),
  };
}

async function openWebWorker({ workerUrl }: WorkerOptions): Promise<Worker> {
  if (typeof Worker !== 'function') throw new Error('there are no workers here');
  const moved = movedAddress(file);
  if (workerUrl !== undefined) return openAddress(await resolveAddress(workerUrl));
  if (moved !== null) return openAddress(new URL(moved));
  try {
    // Bundlers recognise this very form and bundle the worker.
    return new Worker(new URL('./kdmanifold-worker.js', import.meta.url), { type: 'module' });
  } catch (error) {
    const address = foreignAddress(error);
    if (address === null) throw error;
    return openAddress(address);
  }
}

/**
 * The address of a worker that may not be started since it is of another origin. What a bundler made of the
 * address stands nowhere but in the browser's message; without a bundler the file is beside this one.
 */
function foreignAddress(error: unknown): URL | null {
  if ((error as { name?: unknown } | null)?.name !== 'SecurityError') return null;
  const named = /https?:\/\/[^\s'"]+\.m?js[^\s'"]*/.exec(String(error))?.[0];
  const url = named === undefined ? neighbour(file) : new URL(named);
  return url.origin === globalThis.location.origin ? null : url;
}

/** Workers that were given to us and have been ended: they would never answer. */
const ended = new WeakSet<WorkerLike>();

function portOf(given: WorkerLike): WorkerPort {
  if (ended.has(given)) throw new Error('the worker given has been ended');
  const worker = given as Worker;
  return {
    post: (request, transfer) => worker.postMessage(request, transfer),
    listen(onReply, onDeath) {
      worker.onmessage = (event: MessageEvent<Reply>) => onReply(event.data);
      worker.onerror = (event) => onDeath(event.message || 'its script could not be loaded');
      worker.onmessageerror = () => onDeath('a message of the worker could not be read');
    },
    hold: () => {},
    terminate() {
      ended.add(given);
      worker.terminate();
      return Promise.resolve();
    },
  };
}
