// SPDX-License-Identifier: MIT
// What is tried out in a bare machine: that `npm start` serves the page and that tests pass.
import { createServer } from 'node:net';
import { setTimeout as pause } from 'node:timers/promises';

/** Where the clone lies in the machine. */
export const checkout = '/root/kdmanifold';

const patience = 60 * 60 * 1000; // milliseconds, for either

/** Seconds until `npm start` serves the whole page; then it must end as by Ctrl+C. */
export async function secondsOfStart(machine, options) {
  const port = await freePort();
  const env = { PORT: String(port) };
  return during(machine, 'npm start', { ...options, env }, async (ended, child) => {
    const began = performance.now();
    let status;
    void ended.then((value) => (status = value));
    while (!(await answers(`http://localhost:${port}/`))) {
      if (status !== undefined) throw new Error(`npm start ended: ${status}`);
      await pause(500);
    }
    const seconds = (performance.now() - began) / 1000;
    process.kill(-child.pid, 'SIGINT'); // the whole group, as a terminal does
    const outcome = await Promise.race([ended, pause(20_000, 'never', { ref: false })]);
    if (outcome === 'never') throw new Error('npm start does not end at Ctrl+C');
    return seconds;
  });
}

/** Seconds of the JavaScript tests. */
export async function secondsOfTest(machine, options) {
  const began = performance.now();
  const status = await during(machine, 'npm test -- javascript', options, (ended) => ended);
  if (status !== 0) throw new Error(`npm test ended: ${status}`);
  return (performance.now() - began) / 1000;
}

/** Whether the page is there, its program with it. */
async function answers(address) {
  try {
    const page = await fetch(address);
    const text = await page.text();
    const program = text.match(/<script type="module"[^>]* src="([^"]+)"/)?.[1];
    if (!page.ok || !text.includes('<title>kdmanifold') || program === undefined) return false;
    return (await fetch(new URL(program, address))).ok;
  } catch {
    return false;
  }
}

/** A port that nobody listens on. */
function freePort() {
  return new Promise((resolve) => {
    const server = createServer().listen(0, 'localhost', () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}

/**
 * Runs a command in the checkout, and `work` beside it, which gets a promise of the command's status.
 * When `work` is done, or `signal` interrupts, nothing of the command is left.
 */
async function during(machine, command, { log, env, signal }, work) {
  const script = `cd ${checkout} && ${command}`;
  const child = machine.start(['sh', '-c', script], { env, stdio: ['ignore', log, log] });
  const ended = new Promise((resolve) =>
    child.on('exit', (status, killer) => resolve(killer ?? status)),
  );
  const stop = () => child.kill('SIGKILL');
  signal.addEventListener('abort', stop);
  const tooLate = setTimeout(stop, patience);
  try {
    signal.throwIfAborted();
    return await work(ended, child);
  } finally {
    clearTimeout(tooLate);
    signal.removeEventListener('abort', stop);
    stop();
    await ended;
  }
}
