// SPDX-License-Identifier: MIT
// `npm run readme-picture`: makes docs/before-after.png, the demo page's damaged knot and what became of it.
import { builders } from './build.mjs';
import { root, setup } from './run.mjs';

setup('wasm', 'test');
builders.package();
process.chdir(root);
const vite = await import('vite');
const { launch, openPage } = await import('../tests/js/support/browser.js');
const configFile = `${root}/web/demo/vite.config.ts`;
await vite.build({ configFile, logLevel: 'warn' });
const server = await vite.preview({ configFile, preview: { port: 0 } });
const browser = await launch();
try {
  const viewport = { width: 1500, height: 820 };
  const { page } = await openPage(browser, server.resolvedUrls.local[0], { viewport });
  await page.getByText('2-manifold').first().waitFor({ timeout: 120_000 });
  await page.getByLabel('Sharp edges').uncheck();
  // Painting and smooth movements come to their end.
  await page.waitForTimeout(3000);
  const views = await page.locator('canvas').first().boundingBox();
  await page.screenshot({
    path: `${root}/docs/before-after.png`,
    clip: { ...views, height: Math.min(views.height, viewport.height - views.y) },
  });
} finally {
  await browser.close();
  await server.close();
}
process.exit(0);
