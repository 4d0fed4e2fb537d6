// SPDX-License-Identifier: MIT
// Starts an instance of a compiled module, with memory of its own.
import type createModule from './kdmanifold.js';
import type { RawModule } from './kdmanifold.js';

/** @internal Starts the module with the glue that belongs to it. */
export function instantiate(
  create: typeof createModule,
  module: WebAssembly.Module,
): Promise<RawModule> {
  return new Promise((resolve, reject) => {
    create({
      instantiateWasm(imports, receive) {
        WebAssembly.instantiate(module, imports).then(
          (instance) => receive(instance, module),
          reject,
        );
        return {};
      },
    }).then(resolve, reject);
  });
}
