// SPDX-License-Identifier: MIT
// `npm run build [native] [wasm] [package]`: the native command line to build/native, the
// WebAssembly module to build/wasm, the npm package (with the module) to dist/. Compiles only what is
// out of date.
import { copyFileSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { delimiter } from 'node:path';
import { pathToFileURL } from 'node:url';
import { bundlePackage } from './bundle.mjs';
import { jobs, root, run, setup, tool } from './run.mjs';

/** Configures a CMake folder where needed and builds it. */
export function cmake(folder, settings, { targets = [], ...options } = {}) {
  configure(folder, settings, options);
  const chosen = targets.flatMap((target) => ['--target', target]);
  run('cmake', ['--build', folder, '-j', jobs, ...chosen], { env: options.env });
}

/**
 * Configures a CMake folder, from nothing: CMake keeps settings that are no longer given, and the
 * compiler it found first. Does nothing where the folder is as wanted already.
 */
export function configure(folder, settings, { wrapper = [], env = {} } = {}) {
  const [command, ...args] = [
    ...wrapper,
    ...['cmake', '-S', '.', '-B', folder, '-G', 'Ninja'],
    ...settings.map((setting) => `-D${setting}`),
  ];
  const path = `${root}/${folder}`;
  const stamp = `${path}/kdm-settings.txt`;
  const wanted = [root, command, ...args, ...compilerEnvironment({ ...process.env, ...env })];
  if (existsSync(`${path}/build.ninja`) && read(stamp) === wanted.join('\n')) return;
  for (const name of ['kdm-settings.txt', 'CMakeCache.txt', 'CMakeFiles']) {
    rmSync(`${path}/${name}`, { recursive: true, force: true });
  }
  mkdirSync(path, { recursive: true });
  run(command, args, { env });
  writeFileSync(stamp, wanted.join('\n'));
}

/** The variables that CMake and Emscripten read when a folder is configured, and never again. */
const compilerEnvironment = (env) =>
  Object.entries(env)
    .filter(([name]) => /^(CC|CXX|(C|CPP|CXX|LD)FLAGS|CMAKE_.*|EM_.*|NODE_PATH)$/.test(name))
    .map(([name, value]) => `${name}=${value}`)
    .sort();

const read = (path) => (existsSync(path) ? readFileSync(path, 'utf8') : '');

/**
 * What the optimiser of Debian's Emscripten needs in order to find Debian's acorn, wherever Node
 * itself comes from. To be asked after set-up, which brings acorn along with Emscripten.
 */
export function emscriptenEnvironment(libraries = '/usr/share/nodejs') {
  if (!existsSync(`${libraries}/acorn`)) return {};
  const given = process.env.NODE_PATH;
  return { NODE_PATH: given ? [given, libraries].join(delimiter) : libraries };
}

/** What Emscripten makes; `threaded` not by all of its versions (wasm/CMakeLists.txt). */
const wasmFiles = [
  ...['kdmanifold.js', 'kdmanifold.wasm', 'kdmanifold-tools.js', 'kdmanifold-tools.wasm'],
];
const threaded = [
  ...['kdmanifold-threads.js', 'kdmanifold-threads.wasm', 'kdmanifold-threads.worker.js'],
];

export const builders = {
  native() {
    setup('native');
    cmake('build/native', ['CMAKE_BUILD_TYPE=Release', 'KDM_UNITY=ON'], {
      targets: ['kdmanifold_cli'],
    });
  },
  wasm() {
    setup('wasm');
    cmake('build/wasm', ['CMAKE_BUILD_TYPE=Release', 'KDM_UNITY=ON', 'KDM_BUILD_WASM=ON'], {
      wrapper: ['emcmake'],
      env: emscriptenEnvironment(),
      targets: ['kdm_wasm', 'kdm_wasm_tools', 'kdm_wasm_threads'],
    });
  },
  /** The wrapper, file by file, with the module: for what the package is made of, and for tests of its parts. */
  wrapper() {
    builders.wasm();
    rmSync(`${root}/build/js`, { recursive: true, force: true });
    tool('tsc', ['-p', 'tsconfig.build.json']);
    const made = `${root}/build/wasm/wasm`;
    const there = threaded.filter((name) => existsSync(`${made}/${name}`));
    for (const name of [...wasmFiles, ...there]) {
      copyFileSync(`${made}/${name}`, `${root}/build/js/${name}`);
    }
  },
  /** From nothing, so that no file stays in the package whose source is gone. */
  package() {
    builders.wrapper();
    rmSync(`${root}/dist`, { recursive: true, force: true });
    bundlePackage();
  },
};

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const wanted = process.argv.length > 2 ? process.argv.slice(2) : Object.keys(builders);
  for (const name of wanted) {
    if (!(name in builders)) {
      console.error(`build: unknown part '${name}' (${Object.keys(builders).join(', ')})`);
      process.exit(2);
    }
    builders[name]();
  }
}
