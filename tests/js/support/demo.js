// SPDX-License-Identifier: MIT
// The demo page, built and served, and what its tests do with it.
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { expect } from '@jest/globals';
import { load } from '../../../dist/index.js';
import { launch, openPage } from './browser.js';
import { execute, root } from './paths.js';
import { serve } from './server.js';

/** Where pictures go, to be looked at. */
export const screenshots = join(root, 'tests/js/screenshots');

/** Text and edges may come out a shade different; what a control changes is much more pixels than this. */
export const few = 50;

/** Builds and opens the page; `name` tells the builds of test files apart that run at a time. */
export async function openDemo(name, options = {}) {
  mkdirSync(screenshots, { recursive: true });
  const folder = join(root, 'build/demo-tests', name);
  const vite = join(root, 'node_modules/.bin/vite');
  const config = ['-c', 'web/demo/vite.config.ts', '--outDir', folder, '--logLevel', 'warn'];
  const built = execute(vite, ['build', ...config], { cwd: root });
  expect({ status: built.status, stderr: built.stderr }).toMatchObject({ status: 0 });
  const kdm = await load();
  const server = await serve(folder);
  const browser = await launch();
  const { page, errors } = await openPage(browser, `${server.address}/`, options);

  const waitFor = (condition) => page.waitForFunction(condition, null, { timeout: 60_000 });
  const settled = () => waitFor(() => ['done', 'error'].includes(document.body.dataset.state));
  const busyThenSettled = async (action) => {
    await page.evaluate(() => (document.body.dataset.state = 'waiting'));
    await action();
    await settled();
  };
  const file = (path, mesh) => ({
    name: path,
    mimeType: 'application/octet-stream',
    buffer: Buffer.from(kdm.formatMesh(mesh, path.split('.').at(-1))),
  });
  return {
    page,
    errors,
    kdm,
    browser,
    address: server.address,
    waitFor,
    /** The page has a result, or says why not. */
    settled,
    /** All is known of the input. */
    inspected: () => waitFor(() => document.body.dataset.inspection === 'done'),
    busyThenSettled,
    text: (selector) => page.locator(selector).innerText(),
    file,
    /** Hands the page a file: as Playwright has it, or a name and a mesh. */
    choose: (...args) =>
      busyThenSettled(() =>
        page.locator('#file').setInputFiles(args.length > 1 ? file(...args) : args[0]),
      ),
    /** A picture once it stays as it is: sharp edges come a little later than faces. */
    picture: async (selector) => {
      // From the same place each time: rims of elements are smoothed differently half a pixel on.
      await page.locator(selector).evaluate((found) => found.scrollIntoView({ block: 'center' }));
      let last = null;
      for (let shots = 0; shots < 10; ++shots) {
        await page.waitForTimeout(300);
        const now = await page.locator(selector).screenshot();
        if (last?.equals(now)) break;
        last = now;
      }
      return last;
    },
    /** What a table of numbers says. */
    fact: async (table, head) => {
      const header = page.getByRole('rowheader', { name: head, exact: true });
      return page.locator(`#${table} tr`).filter({ has: header }).locator('td').innerText();
    },
    close: async () => {
      await browser.close();
      await server.close();
    },
  };
}
