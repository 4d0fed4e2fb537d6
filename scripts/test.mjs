// SPDX-License-Identifier: MIT
// `npm test`: sets up, checks format, lint and types, builds and runs all tests, cheapest first, and
// ends with the counts. `npm test -- PART...` runs some parts only; `npm test -- quick` is for daily
// work: one compiler, and without the slow tests, which tests/slow.json lists.
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync } from 'node:fs';
import { builders, cmake, configure } from './build.mjs';
import { jobs, root, setup, tryRun } from './run.mjs';

const counts = { passed: 0, failed: 0 };
const failures = []; // what they were, told again at the end

function fail(what) {
  ++counts.failed;
  failures.push(what);
  console.error(`FAILED: ${what}`);
}

// A check without tests of its own counts as one.
function check(title, command, args, options) {
  console.log(`\n== ${title}`);
  if (tryRun(command, args, options).status === 0) ++counts.passed;
  else fail(title);
}

// GoogleTest, more shares of the tests than processors, so that none of these waits for the slowest;
// its own JSON reports for the counts.
async function googleTest(title, program, { without = [] } = {}) {
  console.log(`\n== ${title}`);
  const chosen = `--gtest_filter=*${without.length > 0 ? `-${without.join(':')}` : ''}`;
  const shards = 8 * Number(jobs);
  const runShard = async (shard) => {
    const report = `${program}.${shard}.json`;
    rmSync(report, { force: true });
    const child = spawn(program, ['--gtest_brief=1', chosen, `--gtest_output=json:${report}`], {
      cwd: root,
      stdio: 'inherit',
      env: { ...process.env, GTEST_TOTAL_SHARDS: shards, GTEST_SHARD_INDEX: shard },
    });
    const status = await new Promise((resolve) => {
      child.on('exit', resolve);
      child.on('error', resolve);
    });
    const share = `${title}, share ${shard} of ${shards}`;
    if (!existsSync(report)) return fail(`${share}: crashed (${status})`);
    const suites = JSON.parse(readFileSync(report, 'utf8')).testsuites;
    const tests = suites.flatMap(({ testsuite }) => testsuite);
    const failed = tests.filter((test) => test.failures);
    counts.passed += tests.length - failed.length;
    for (const { classname, name } of failed) fail(`${title}: ${classname}.${name}`);
    if (status !== 0 && failed.length === 0) fail(`${share}: exit code ${status}`);
  };
  const left = Array.from({ length: shards }, (_, shard) => shard);
  const work = async () => {
    while (left.length > 0) await runShard(left.shift());
  };
  await Promise.all(Array.from({ length: Number(jobs) }, work));
}

function jest(title, args) {
  console.log(`\n== ${title}`);
  mkdirSync(`${root}/build`, { recursive: true });
  const report = `${root}/build/jest.json`;
  rmSync(report, { force: true });
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
  if (!existsSync(report)) return fail(`${title}: crashed (${status})`);
  const { numPassedTests, testResults } = JSON.parse(readFileSync(report, 'utf8'));
  counts.passed += numPassedTests;
  const tests = testResults.flatMap(({ assertionResults }) => assertionResults);
  const failed = tests.filter((test) => test.status === 'failed');
  for (const { fullName } of failed) fail(`${title}: ${fullName}`);
  if (status !== 0 && failed.length === 0) fail(`${title}: exit code ${status}`);
}

// Every rule of the library and of the language, at a speed that bears it.
const sanitized = [
  'build/sanitized',
  [
    // Asserts are on, and reports name lines; a debugger's tables would take a tenth of the time.
    'CMAKE_BUILD_TYPE=None',
    'CMAKE_CXX_COMPILER=clang++',
    'CMAKE_CXX_FLAGS=-O1 -gline-tables-only',
    'KDM_UNITY=ON',
    'KDM_SANITIZE=ON',
    'KDM_BUILD_TESTS=ON',
  ],
];

// What threads share, under ThreadSanitizer.
const threads = [
  'build/threads',
  [
    'CMAKE_BUILD_TYPE=None',
    'CMAKE_CXX_COMPILER=clang++',
    'CMAKE_CXX_FLAGS=-O1 -gline-tables-only',
    'KDM_UNITY=ON',
    'KDM_SANITIZE_THREADS=ON',
    'KDM_BUILD_CLI=OFF',
    'KDM_BUILD_TESTS=ON',
  ],
];

// The other compiler, optimised: the same bytes must come out.
const release = [
  'build/release',
  ['CMAKE_BUILD_TYPE=Release', 'KDM_UNITY=ON', 'KDM_WERROR=ON', 'KDM_BUILD_TESTS=ON'],
];

const oneDefinition = ['build/odr', ['CMAKE_BUILD_TYPE=None', 'KDM_ODR=ON']];

const parts = {
  lint() {
    check('format, lint and types', process.execPath, ['scripts/lint.mjs']);
  },
  async sanitized() {
    cmake(...sanitized, { targets: ['kdmanifold_tests', 'kdm_fuzz_smoke'] });
    await googleTest(
      'C++ tests, clang++, sanitizers',
      `${root}/build/sanitized/tests/cpp/kdmanifold_tests`,
    );
    check('fuzz targets, a few seconds', `${root}/build/sanitized/tests/fuzz/kdm_fuzz_smoke`, []);
  },
  async threads() {
    cmake(...threads, { targets: ['kdmanifold_thread_tests'] });
    await googleTest(
      'C++ tests of threads, clang++, ThreadSanitizer',
      `${root}/build/threads/tests/cpp/kdmanifold_thread_tests`,
    );
  },
  // Reads the compile commands of the sanitized build.
  tidy() {
    configure(...sanitized);
    // The library and the command line, each room as one file, and what is in no room.
    const sources = ['(kdmanifold|cli_parts)\\.dir/Unity/.*', 'src/.*\\.cpp$'];
    check(
      'clang-tidy',
      'run-clang-tidy',
      ['-quiet', '-j', jobs, '-p', 'build/sanitized', ...sources],
      {
        stdio: ['ignore', 'inherit', 'ignore'],
      },
    );
  },
  // No function, class or template of one name may be two: which is linked would be chance.
  odr() {
    cmake(...oneDefinition, { targets: ['kdmanifold_cli'] });
    check('one definition of each name', process.execPath, ['tests/odr/check.mjs', 'build/odr']);
  },
  async release() {
    cmake(...release, { targets: ['kdmanifold_tests'] });
    await googleTest(
      'C++ tests, g++, optimised',
      `${root}/build/release/tests/cpp/kdmanifold_tests`,
    );
  },
  // Compares with the command line of the optimised build.
  javascript() {
    cmake(...release, { targets: ['kdmanifold_cli'] });
    builders.package();
    jest('JavaScript tests', []);
  },
};

// Shorter forms of the above, which therefore are no parts of the whole.
const extras = {
  async quick() {
    const slow = JSON.parse(readFileSync(`${root}/tests/slow.json`, 'utf8'));
    parts.lint();
    cmake(...release, { targets: ['kdmanifold_tests', 'kdmanifold_cli'] });
    await googleTest(
      'C++ tests but the slow ones, g++, optimised',
      `${root}/build/release/tests/cpp/kdmanifold_tests`,
      { without: slow.cpp },
    );
    builders.package();
    jest('JavaScript tests but the slow ones', [
      '--testPathIgnorePatterns',
      ...slow.js.map((name) => `tests/js/${name}\\.test\\.js`),
    ]);
  },
};

setup('wasm', 'native', 'test');
const wanted = process.argv.length > 2 ? process.argv.slice(2) : Object.keys(parts);
for (const part of wanted) {
  const known = { ...parts, ...extras };
  if (!(part in known)) {
    console.error(`test: unknown part '${part}' (${Object.keys(known).join(', ')})`);
    process.exit(2);
  }
  await known[part]();
}
for (const what of failures) console.log(`FAILED: ${what}`);
console.log(`\n${counts.passed} passed, ${counts.failed} failed`);
process.exit(counts.failed === 0 && counts.passed > 0 ? 0 : 1);
