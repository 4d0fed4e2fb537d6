// SPDX-License-Identifier: MIT
// Types that come from outside of the language, written so that the package's types hold without the
// DOM's and without Node's, and with every TypeScript from 5.0 on.

/** An address, as text or as a `URL`. */
export type Address = string | { readonly href: string };

/** An `AbortSignal`, or what behaves like one. */
export interface Signal {
  /** Whether it has been aborted already. */
  readonly aborted: boolean;
  /** What it was aborted with. */
  readonly reason?: unknown;
  /** @hidden */
  addEventListener(type: 'abort', listener: () => void): void;
  /** @hidden */
  removeEventListener(type: 'abort', listener: () => void): void;
}

/** A `Worker` of a browser, or what behaves like one. */
export interface WorkerLike {
  /** @hidden */
  postMessage(message: unknown, transfer: ArrayBuffer[]): void;
  /** @hidden */
  terminate(): void;
}

/** A `WebAssembly.Module`, where TypeScript knows of such. */
export type CompiledModule = typeof globalThis extends {
  WebAssembly: { Module: abstract new (...values: never[]) => infer Module };
}
  ? Module
  : never;

/** A `Float32Array` with memory of its own (from TypeScript 5.7 on `Float32Array<ArrayBuffer>`). */
export type OwnFloat32Array = ReturnType<Float32Array['slice']>;

/** A `Float64Array` with memory of its own. */
export type OwnFloat64Array = ReturnType<Float64Array['slice']>;

/** A `Uint32Array` with memory of its own. */
export type OwnUint32Array = ReturnType<Uint32Array['slice']>;

/** A `Uint8Array` with memory of its own. */
export type OwnUint8Array = ReturnType<Uint8Array['slice']>;

declare global {
  interface SymbolConstructor {
    /** What `using` calls; declared here for TypeScript without the library "ESNext.Disposable". */
    readonly dispose: unique symbol;
  }
}
