// SPDX-License-Identifier: MIT
// The main module with several threads, and what these run. This file becomes kdmanifold-threads.js, in one
// piece: threads are workers that are started from it.
import { isNode, nodeModule } from '../environment.js';
import { instantiate } from '../instantiate.js';
import createModule from '../kdmanifold-threads.js';
import type { RawModule } from '../kdmanifold.js';
import { openAddress } from '../worker/open-address.js';

type NodeThreads = typeof import('node:worker_threads');

// By its name in browsers, by its data in Node, a worker knows that it is a thread.
const threadName = 'em-pthread';

/** A thread as Emscripten's glue sees it, which takes it for a `Worker`. */
class Thread {
  /** Set by the glue. */
  onmessage: (event: { data: unknown }) => void = () => {};
  readonly #worker: Worker | import('node:worker_threads').Worker;

  constructor(node: NodeThreads | null, onError: (error: unknown) => void) {
    const hear = (data: unknown): void => this.onmessage({ data });
    const address = new URL(import.meta.url);
    if (node === null) {
      const worker = openAddress(address, threadName);
      worker.onmessage = ({ data }) => hear(data);
      worker.onerror = ({ message }) => onError(new Error(message || 'a thread was not started'));
      this.#worker = worker;
    } else {
      const worker = new node.Worker(address, { execArgv: [], workerData: threadName });
      worker.on('message', hear);
      worker.on('error', onError);
      this.#worker = worker;
    }
  }

  postMessage(message: unknown): void {
    this.#worker.postMessage(message);
  }

  /** Lets Node end while the thread waits. */
  unref(): void {
    if ('unref' in this.#worker) this.#worker.unref();
  }

  terminate(): void {
    void this.#worker.terminate();
  }
}

/**
 * Starts an instance whose calls share their work among so many threads, and resolves when all are there: calls block
 * the calling thread, and none can be started meanwhile. `end` ends those threads.
 */
export async function startThreads(
  module: WebAssembly.Module,
  count: number,
): Promise<{ raw: RawModule; end: () => void }> {
  const node = isNode() ? await nodeModule<NodeThreads>('worker_threads') : null;
  const threads: Thread[] = [];
  const end = (): void => threads.forEach((thread) => thread.terminate());
  try {
    const raw = await new Promise<Awaited<ReturnType<typeof createModule>>>((resolve, reject) => {
      class Started extends Thread {
        constructor() {
          super(node, reject);
          threads.push(this);
        }
      }
      instantiate(createModule, module, { helpers: count - 1, Worker: Started }).then(
        resolve,
        reject,
      );
    });
    raw.setThreadCount(count);
    for (const thread of threads) {
      thread.postMessage({ lostThreads: raw._kdm_lost_threads() });
      thread.unref();
    }
    return { raw, end };
  } catch (error) {
    end();
    throw error;
  }
}

interface ThreadScope {
  name?: string;
  self: unknown;
  onmessage: (event: { data: Message }) => void;
  postMessage: (message: unknown) => void;
}

/** Of `startThreads`, or of the glue, whose first brings the memory. */
type Message =
  { lostThreads: number } | { lostThreads?: undefined; wasmMemory?: WebAssembly.Memory };

/** Handles messages as Emscripten does, whose code is imported here and sets `onmessage`. */
async function makeHandler(scope: ThreadScope): Promise<(data: Message) => void> {
  await import('../kdmanifold-threads.worker.js');
  const handle = scope.onmessage;
  let memory: WebAssembly.Memory;
  let lostThreads = 0;
  return (data) => {
    if (data.lostThreads !== undefined) {
      lostThreads = data.lostThreads;
      return;
    }
    if (data.wasmMemory) memory = data.wasmMemory;
    try {
      handle({ data });
    } catch (error) {
      Atomics.store(new Int32Array(memory.buffer), lostThreads / 4, 1);
      throw error;
    }
  };
}

/** Works as a thread, if this is one. */
async function serve(): Promise<void> {
  const scope = globalThis as unknown as ThreadScope;
  if (isNode()) {
    const node = await nodeModule<NodeThreads>('worker_threads');
    const { parentPort } = node;
    if (parentPort === null || node.workerData !== threadName) return;
    scope.self = globalThis;
    scope.postMessage = (message) => parentPort.postMessage(message);
    parentPort.on('message', await makeHandler(scope));
  } else if (scope.name === threadName) {
    // What comes before the handler is there waits for it.
    const ready = makeHandler(scope);
    const receive = ({ data }: { data: Message }): void =>
      void ready.then((handle) => handle(data));
    scope.onmessage = receive;
    await ready;
    scope.onmessage = receive;
  }
}

void serve();
