// SPDX-License-Identifier: MIT
// Starts a worker of a browser from wherever its script lies.

/** Starts a worker from an address. One of another origin may not be started, but imported by one that is. */
export function openAddress(url: URL, name = ''): Worker {
  const { origin } = globalThis.location;
  const options: WorkerOptions = { type: 'module', name };
  if (!/^https?:$/.test(url.protocol) || url.origin === origin) return new Worker(url, options);
  const code = new Blob([`import ${JSON.stringify(url.href)};`], { type: 'text/javascript' });
  const start = URL.createObjectURL(code);
  const worker = new Worker(start, options);
  // Long after it has been read.
  setTimeout(() => URL.revokeObjectURL(start), 60_000);
  return worker;
}
