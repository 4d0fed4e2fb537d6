// SPDX-License-Identifier: MIT

/** What a table of figures says of a row: that all holds, or what does not. */
export const verdictOf = (faults) => (faults.length === 0 ? 'ok' : `FAILS: ${faults.join(', ')}`);
