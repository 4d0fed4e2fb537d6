// SPDX-License-Identifier: MIT
// Starts an instance of a compiled module, with memory of its own.
import type { CreateModule, ThreadSettings } from './kdmanifold.js';

/** @internal Starts the module with the glue that belongs to it. */
export function instantiate<Raw>(
  create: CreateModule<Raw>,
  module: WebAssembly.Module,
  settings?: ThreadSettings,
): Promise<Raw> {
  return new Promise((resolve, reject) => {
    create({
      ...settings,
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
