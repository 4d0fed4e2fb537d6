// SPDX-License-Identifier: MIT
// Tries one bundler in a fresh folder: installs it and the packed package, builds, and runs the page.
import { spawn, spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));

/** Packs the package as it is in dist/, into a folder. Returns the path. */
export function pack(folder) {
  const printed = run(
    ['npm', 'pack', '--json', '--ignore-scripts', '--pack-destination', folder],
    root,
  );
  return join(folder, JSON.parse(printed.out)[0].filename);
}

/**
 * Tries a case of cases.mjs. `launch` starts a browser, `serve` a server of a folder. Returns {versions, built,
 * warnings, outcomes, wasm, workers, problems}: what was installed; how often the build said "warning"; what the
 * application told; which addresses WebAssembly came from; how many workers each page had; what went wrong.
 */
export async function tryCase(trial, packed, { launch, serve, latest = false }) {
  const folder = mkdtempSync(join(tmpdir(), 'kdmanifold-bundler-'));
  try {
    const versions = install(trial, packed, folder, latest);
    const environment = { ...process.env, ...trial.environment, CI: '1' };
    let said = '';
    if (trial.build) {
      const { out, err, status } = run(trial.build, folder, environment);
      said = out + err;
      if (status !== 0) return { versions, problems: [`build: status ${status}\n${said}`] };
    }
    const warnings = (said.match(/^.*\bwarn(ing)?\b.*$/gim) ?? []).filter(
      (line) => !(trial.hints ?? []).some((hint) => hint.test(line)),
    );
    if (trial.programs) {
      const results = trial.programs.map((program) => run(program, folder, environment));
      const problems = results.flatMap(({ err, status }) => (status || err ? [err] : []));
      return { versions, warnings, outcomes: results.map(({ out }) => parse(out)), problems };
    }
    const site = trial.server
      ? await startServer(trial.server, folder, environment)
      : await serve(join(folder, trial.folder));
    try {
      const visits = [];
      for (const path of trial.paths ?? ['/'])
        visits.push(await visit(site.address + path, launch));
      return {
        versions,
        warnings,
        outcomes: visits.map(({ outcome }) => outcome),
        workers: visits.map(({ workers }) => workers),
        wasm: visits.flatMap(({ wasm }) => wasm),
        problems: visits.flatMap(({ problems }) => problems),
      };
    } finally {
      await site.close();
    }
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

function run([command, ...args], cwd, env = process.env) {
  const { status, stdout, stderr, error } = spawnSync(command, args, {
    cwd,
    env,
    encoding: 'utf8',
    maxBuffer: 1 << 28,
    timeout: 600_000,
  });
  if (error) throw error;
  return { status, out: stdout, err: stderr };
}

const parse = (text) => {
  try {
    return JSON.parse(text);
  } catch {
    return { error: `no outcome: '${text}'` };
  }
};

function install({ packages, files }, packed, folder, latest) {
  const known = JSON.parse(readFileSync(new URL('./versions.json', import.meta.url), 'utf8'));
  const wanted = Object.entries(packages).map(([name, key]) => {
    const newest = latest && !/\d$/.test(key);
    return `${name}@${newest ? 'latest' : known[key]}`;
  });
  writeFileSync(join(folder, 'package.json'), '{ "private": true, "type": "module" }\n');
  const { status, err } = run(
    ['npm', 'install', '--no-audit', '--no-fund', '--prefer-offline', packed, ...wanted],
    folder,
  );
  if (status !== 0) throw new Error(`npm install ${wanted.join(' ')}: ${err}`);
  for (const [path, text] of Object.entries(files)) {
    mkdirSync(dirname(join(folder, path)), { recursive: true });
    writeFileSync(join(folder, path), text);
  }
  return Object.keys(packages).map(
    (name) =>
      `${name} ${JSON.parse(readFileSync(join(folder, 'node_modules', name, 'package.json'), 'utf8')).version}`,
  );
}

const freePort = () =>
  new Promise((resolve) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });

async function startServer(command, cwd, env) {
  const port = await freePort();
  const [program, ...args] = command.map((word) => (word === 'PORT' ? String(port) : word));
  const child = spawn(program, args, {
    cwd,
    env,
    detached: true,
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  let said = '';
  for (const stream of [child.stdout, child.stderr]) stream.on('data', (text) => (said += text));
  const address = `http://127.0.0.1:${port}`;
  const close = async () => {
    try {
      process.kill(-child.pid, 'SIGKILL');
    } catch {
      // It has ended by itself.
    }
  };
  for (let i = 0; i < 300; ++i) {
    try {
      await fetch(address);
      return { address, close };
    } catch {
      await new Promise((resolve) => setTimeout(resolve, 200));
    }
  }
  await close();
  throw new Error(`${command.join(' ')} does not answer: ${said}`);
}

async function visit(address, launch) {
  const browser = await launch();
  try {
    const wasm = [];
    const problems = [];
    let workers = 0;
    const page = await browser.newPage();
    page.on('worker', () => ++workers);
    page.on('request', (request) => {
      if (/\.wasm/.test(request.url())) wasm.push(new URL(request.url()).pathname);
    });
    page.on('requestfailed', (request) => problems.push(`${request.url()}: failed`));
    page.on('response', (response) => {
      if (response.status() >= 400) problems.push(`${response.url()}: ${response.status()}`);
    });
    page.on('pageerror', (error) => problems.push(String(error)));
    page.on('console', (message) => {
      if (['error', 'warning'].includes(message.type())) problems.push(message.text());
    });
    await page.goto(address);
    await page
      .waitForFunction(`document.title.startsWith('{')`, null, { timeout: 60_000 })
      .catch((error) => problems.push(String(error)));
    return { outcome: parse(await page.title()), wasm, workers, problems };
  } finally {
    await browser.close();
  }
}
