// SPDX-License-Identifier: MIT
// `npm test`: sets up, checks format, lint and types, builds and runs all tests, cheapest first, and
// ends with the counts. `npm test -- PART...` runs some parts only.
import { mkdirSync, readFileSync } from 'node:fs';
import { builders, cmake } from './build.mjs';
import { root, setup, tryRun } from './run.mjs';

const counts = { passed: 0, failed: 0 };

// A check without tests of its own counts as one.
function check(title, command, args, options) {
  console.log(`\n== ${title}`);
  const passed = tryRun(command, args, options).status === 0;
  ++counts[passed ? 'passed' : 'failed'];
  if (!passed) console.error(`FAILED: ${title}`);
}

// GoogleTest in one process, its own JSON report for the counts.
function googleTest(title, program, environment = {}) {
  console.log(`\n== ${title}`);
  const report = `${program}.json`;
  const { status } = tryRun(program, ['--gtest_brief=1', `--gtest_output=json:${report}`], {
    env: environment,
  });
  try {
    const { tests, failures } = JSON.parse(readFileSync(report, 'utf8'));
    counts.passed += tests - failures;
    counts.failed += failures;
    if (status !== 0 && failures === 0) ++counts.failed;
  } catch {
    ++counts.failed; // it crashed before it could report
  }
}

function jest(title, args) {
  console.log(`\n== ${title}`);
  mkdirSync(`${root}/build`, { recursive: true });
  const report = `${root}/build/jest.json`;
  const { status } = tryRun(
    process.execPath,
    [
      '--experimental-vm-modules',
      '--no-warnings',
      'node_modules/jest/bin/jest.js',
      '--json',
      `--outputFile=${report}`,
      ...args,
    ],
    { stdio: ['ignore', 'ignore', 'inherit'] },
  );
  try {
    const { numPassedTests, numFailedTests } = JSON.parse(readFileSync(report, 'utf8'));
    counts.passed += numPassedTests;
    counts.failed += numFailedTests;
    if (status !== 0 && numFailedTests === 0) ++counts.failed;
  } catch {
    ++counts.failed;
  }
}

const parts = {
  lint() {
    check('format, lint and types', process.execPath, ['scripts/lint.mjs']);
  },
  // Every rule of the library and of the language, at a speed that bears it.
  sanitized() {
    cmake(
      'build/sanitized',
      [
        'CMAKE_BUILD_TYPE=Debug',
        // g++ 12 sees uninitialised members in its own <regex> once sanitizers are on.
        'CMAKE_CXX_FLAGS=-O1 -Wno-maybe-uninitialized',
        'KDM_SANITIZE=ON',
        'KDM_WERROR=ON',
        'KDM_BUILD_TESTS=ON',
      ],
      { targets: ['kdmanifold_tests'] },
    );
    googleTest('C++ tests, g++, sanitizers', `${root}/build/sanitized/tests/cpp/kdmanifold_tests`);
  },
  // The other compiler, optimised: the same bytes must come out.
  release() {
    cmake(
      'build/release',
      ['CMAKE_BUILD_TYPE=Release', 'CMAKE_CXX_COMPILER=clang++', 'KDM_BUILD_TESTS=ON'],
      { targets: ['kdmanifold_tests'] },
    );
    googleTest('C++ tests, clang++, optimised', `${root}/build/release/tests/cpp/kdmanifold_tests`);
  },
  javascript() {
    for (const build of ['native', 'wasm', 'package']) builders[build]();
    jest('JavaScript tests', []);
  },
};

setup('wasm', 'native', 'test');
const wanted = process.argv.length > 2 ? process.argv.slice(2) : Object.keys(parts);
for (const part of wanted) {
  if (!(part in parts)) {
    console.error(`test: unknown part '${part}' (${Object.keys(parts).join(', ')})`);
    process.exit(2);
  }
  parts[part]();
}
console.log(`\n${counts.passed} passed, ${counts.failed} failed`);
process.exit(counts.failed === 0 && counts.passed > 0 ? 0 : 1);
