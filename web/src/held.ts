// SPDX-License-Identifier: MIT
// What a handle of WebAssembly memory holds until it is deleted or forgotten.
import type { Health } from './call.js';
import { KdManifoldError } from './errors.js';

/** What frees handles that were forgotten. */
export type Registry = FinalizationRegistry<{ delete(): void }>;

/** An object in WebAssembly memory, for the one handle that owns it. */
export class Held<Raw extends { delete(): void }> {
  #raw: Raw | null;
  readonly #name: string;

  /** `name` says in errors what it is. */
  constructor(
    owner: object,
    raw: Raw,
    name: string,
    readonly registry: Registry,
    readonly health: Health,
  ) {
    this.#raw = raw;
    this.#name = name;
    registry.register(owner, raw, this);
  }

  /** Returns the object; throws `DELETED` once it has been freed. */
  get(): Raw {
    if (this.#raw === null) {
      throw new KdManifoldError('DELETED', `this ${this.#name} has been deleted`);
    }
    return this.#raw;
  }

  /** Frees the object, unless that was done, or the instance has broken. */
  free(): void {
    if (this.#raw === null) return;
    this.registry.unregister(this);
    if (!this.health.broken) this.#raw.delete();
    this.#raw = null;
  }
}
