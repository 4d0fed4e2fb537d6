// SPDX-License-Identifier: MIT
// The page's end of the worker that measures.
import type { FileMesh, MeshInput } from 'kdmanifold';
import type { Heat, Surface } from './measure';
import type { Counts, ReferenceName, Reply, Request } from './measure.worker';

type Question = Request extends infer R
  ? R extends { id: number }
    ? Omit<R, 'id'>
    : never
  : never;

/** What is measured, one thing after the other. */
export class Measurer {
  #worker: Worker | null = null;
  readonly #known = new Map<ReferenceName, Surface>();
  readonly #waiting = new Map<
    number,
    { resolve: (value: never) => void; reject: (reason: unknown) => void }
  >();
  #asked = 0;

  /** Sets what others are measured against. */
  keep(name: ReferenceName, mesh: MeshInput): void {
    const surface = surfaceOf(mesh);
    this.#known.set(name, surface);
    this.#worker?.postMessage({ type: 'keep', name, surface } satisfies Request);
  }

  /** How far points all over a mesh are from a reference. */
  heat(mesh: MeshInput, to: ReferenceName): Promise<Heat> {
    return this.#ask({ type: 'heat', to, surface: surfaceOf(mesh) });
  }

  /** The largest distance between points of a mesh and a reference, both ways, in model units. */
  apart(mesh: MeshInput, to: ReferenceName): Promise<number> {
    return this.#ask({ type: 'apart', to, surface: surfaceOf(mesh) });
  }

  /** Parts, tunnels, cavities and the like of a mesh. */
  count(mesh: MeshInput): Promise<Counts> {
    return this.#ask({ type: 'count', surface: surfaceOf(mesh) });
  }

  /** The mesh of a file. */
  read(file: File): Promise<FileMesh> {
    return this.#ask({ type: 'read', file });
  }

  /** Stops what is under way: all that wait are told so. */
  stop(): void {
    if (this.#waiting.size > 0) this.#end(new DOMException('stopped', 'AbortError'));
  }

  #ask<T>(question: Question): Promise<T> {
    const worker = (this.#worker ??= this.#open());
    const id = ++this.#asked;
    return new Promise<T>((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      worker.postMessage({ ...question, id });
    });
  }

  #open(): Worker {
    // Bundlers recognise this very form and bundle the worker.
    const worker = new Worker(new URL('./measure.worker.ts', import.meta.url), { type: 'module' });
    worker.onmessage = ({ data }: MessageEvent<Reply>) => {
      const waiting = this.#waiting.get(data.id);
      this.#waiting.delete(data.id);
      if ('error' in data) waiting?.reject(new Error(data.error));
      else waiting?.resolve(data.value as never);
    };
    worker.onerror = (event) => this.#end(new Error(event.message || 'nothing could be measured'));
    for (const [name, surface] of this.#known) {
      worker.postMessage({ type: 'keep', name, surface } satisfies Request);
    }
    return worker;
  }

  #end(reason: unknown): void {
    this.#worker?.terminate();
    this.#worker = null;
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    for (const { reject } of waiting) reject(reason);
  }
}

function surfaceOf({ positions, indices }: MeshInput): Surface {
  return {
    positions: ArrayBuffer.isView(positions) ? positions : Float64Array.from(positions),
    indices:
      indices instanceof Uint32Array || indices instanceof Uint16Array
        ? indices
        : indices
          ? Uint32Array.from(indices)
          : null,
  };
}
