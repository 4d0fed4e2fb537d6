// SPDX-License-Identifier: MIT
// ES modules as they are: no Babel, Node's own loader (--experimental-vm-modules in scripts/test.mjs).
export default {
  transform: {},
  testEnvironment: 'node',
  testMatch: ['<rootDir>/tests/js/**/*.test.js'],
  modulePathIgnorePatterns: ['<rootDir>/build/', '<rootDir>/dist/'],
  testTimeout: 120_000,
  // Two browsers or two npm installations at a time are too much for a small machine.
  maxWorkers: 2,
};
