// SPDX-License-Identifier: MIT
// What somebody may have meant who typed a word that does not exist, as src/cli/suggest.cpp finds it.

// Nothing stands beside the table of changes.
const entry = (row: number[], j: number): number => row[j] ?? Infinity;

// How many letters are put in, left out or replaced, or change places with their neighbours.
function distance(a: string, b: string): number {
  let before: number[] = [];
  let last = Array.from({ length: b.length + 1 }, (_, j) => j);
  for (let i = 1; i <= a.length; ++i) {
    const row = [i];
    for (let j = 1; j <= b.length; ++j) {
      const replaced = entry(last, j - 1) + (a[i - 1] === b[j - 1] ? 0 : 1);
      let least = Math.min(entry(last, j) + 1, entry(row, j - 1) + 1, replaced);
      if (i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1]) {
        least = Math.min(least, entry(before, j - 2) + 1);
      }
      row.push(least);
    }
    before = last;
    last = row;
  }
  return entry(last, b.length);
}

/**
 * Returns the word that is likely meant, or nothing: the one that the fewest changes lead to (at most a third of the
 * letters, but one always), or else the first that begins with what is typed, or else has it somewhere.
 */
export function nearest(typed: string, words: readonly string[]): string | undefined {
  const letters = Buffer.from(typed).toString('latin1'); // bytes, as they count natively
  if (letters === '' || letters.length > 64) return undefined;
  let least = Math.max(1, Math.floor(letters.length / 3)) + 1;
  let best: string | undefined;
  for (const word of words) {
    const changes = distance(letters, word);
    if (changes < least) {
      least = changes;
      best = word;
    }
  }
  if (best !== undefined || letters.length < 3) return best;
  return (
    words.find((word) => word.startsWith(letters)) ?? words.find((word) => word.includes(letters))
  );
}

/** Returns "; did you mean WORD?", or "". */
export function didYouMean(typed: string, words: readonly string[]): string {
  const near = nearest(typed, words);
  return near === undefined ? '' : `; did you mean ${near}?`;
}
