// SPDX-License-Identifier: MIT
// The name of the method that `using` calls.

/** Node 20 has the symbol, not every browser has. */
export const dispose: typeof Symbol.dispose = Symbol.dispose ?? Symbol.for('Symbol.dispose');
