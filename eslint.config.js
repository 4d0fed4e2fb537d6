// SPDX-License-Identifier: MIT
import js from '@eslint/js';
import ts from 'typescript-eslint';

const node = {
  AbortController: 'readonly',
  Buffer: 'readonly',
  URL: 'readonly',
  console: 'readonly',
  fetch: 'readonly',
  performance: 'readonly',
  process: 'readonly',
  setTimeout: 'readonly',
  clearTimeout: 'readonly',
};

export default ts.config(
  { ignores: ['build/', 'dist/', 'docs/api/', 'node_modules/'] },
  js.configs.recommended,
  ...ts.configs.recommended,
  {
    files: ['web/**/*.ts'],
    extends: [...ts.configs.strictTypeChecked],
    languageOptions: {
      parserOptions: { project: ['./tsconfig.json', './web/demo/tsconfig.json'] },
    },
    rules: {
      '@typescript-eslint/restrict-template-expressions': 'off',
      '@typescript-eslint/no-confusing-void-expression': 'off',
      '@typescript-eslint/no-invalid-void-type': 'off',
      '@typescript-eslint/no-unnecessary-type-parameters': 'off',
      // What a callback throws is handed on as it is.
      '@typescript-eslint/prefer-promise-reject-errors': ['error', { allowThrowingUnknown: true }],
      // The checks at the border doubt what the types promise, on purpose.
      '@typescript-eslint/no-unnecessary-condition': 'off',
    },
  },
  {
    rules: {
      eqeqeq: 'error',
      'no-var': 'error',
      'prefer-const': 'error',
      'no-console': ['error', { allow: ['log', 'warn', 'error'] }],
    },
  },
  {
    files: ['**/*.{js,mjs}'],
    languageOptions: { globals: node },
  },
  {
    // Parts of what Emscripten generates.
    files: ['wasm/*.js'],
    languageOptions: {
      globals: { LibraryManager: 'readonly', Module: 'readonly', mergeInto: 'readonly' },
    },
    rules: { '@typescript-eslint/no-unused-vars': 'off' },
  },
  {
    files: ['tests/js/**/*.js'],
    languageOptions: {
      globals: {
        ...node,
        TextEncoder: 'readonly',
        afterAll: 'readonly',
        afterEach: 'readonly',
        beforeAll: 'readonly',
        beforeEach: 'readonly',
        describe: 'readonly',
        document: 'readonly',
        expect: 'readonly',
        test: 'readonly',
        window: 'readonly',
      },
    },
  },
);
