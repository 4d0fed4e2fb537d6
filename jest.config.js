// SPDX-License-Identifier: MIT
// ES modules as they are: no Babel, Node's own loader (--experimental-vm-modules in scripts/test.mjs).
const common = {
  transform: {},
  testEnvironment: 'node',
  modulePathIgnorePatterns: ['<rootDir>/build/', '<rootDir>/dist/'],
};

export default {
  projects: [
    { ...common, testMatch: ['<rootDir>/tests/js/**/*.test.js'] },
    // Once more with the oldest three.js that package.json allows, for tests and adapter alike.
    {
      ...common,
      displayName: 'oldest three',
      testMatch: ['<rootDir>/tests/js/three*.test.js'],
      moduleNameMapper: { '^three$': 'three-oldest' },
      globals: { oldestThree: true },
    },
  ],
  testTimeout: 120_000,
  // Two browsers or two npm installations at a time are too much for a small machine.
  maxWorkers: 2,
};
