// SPDX-License-Identifier: MIT
// Boolean operations on the demo page: a second model, its handles and fields, rough and full results.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { differentPixels, openPage } from '../support/browser.js';
import { few, openDemo, screenshots } from '../support/demo.js';
import { cube, faults, volume } from '../support/meshes.js';

let demo;
let page;
let text;
let busyThenSettled;

beforeAll(async () => {
  demo = await openDemo('second');
  ({ page, text, busyThenSettled } = demo);
  await demo.choose('one.stl', cube(2));
  await page.locator('#second summary').click();
}, 180_000);

afterAll(() => demo?.close());

afterEach(() => expect(demo.errors).toEqual([]));

const field = (axis) => page.getByRole('spinbutton', { name: axis, exact: true });
const chooseSecond = (name, mesh) =>
  busyThenSettled(() => page.locator('#second-file').setInputFiles(demo.file(name, mesh)));
const choose = (operation) =>
  busyThenSettled(() => page.getByLabel('Make of the two').selectOption(operation));
const type = (axis, value) => busyThenSettled(() => field(axis).fill(String(value)));
// The mesh that is downloaded, and under which name.
async function download() {
  const [file] = await Promise.all([
    page.waitForEvent('download'),
    page.locator('#save-obj').click(),
  ]);
  const mesh = demo.kdm.parseMesh(readFileSync(await file.path()), 'obj');
  expect(faults(mesh)).toEqual([]);
  return { name: file.suggestedFilename(), volume: volume(mesh) };
}

test('two files give their union where they are', async () => {
  expect(await page.locator('#second-controls').isVisible()).toBe(false);
  await chooseSecond('two.stl', cube(2, [1, 1, 1]));
  expect(await text('#verdict')).toBe('Closed · 2-manifold · 1 part');
  expect(await text('#second-name')).toBe('and two.stl');
  expect(await text('#changes-input')).toBe('First model');
  expect(await field('x').inputValue()).toBe('1');
  const made = await download();
  expect(made.name).toBe('one-union.obj');
  expect(made.volume).toBeCloseTo(15, 1);
});

test.each([
  ['difference', 7],
  ['intersection', 1],
])('and their %s', async (operation, expected) => {
  await choose(operation);
  const made = await download();
  expect(made.name).toBe(`one-${operation}.obj`);
  expect(made.volume).toBeCloseTo(expected, 1);
});

test('fields move, turn and scale it', async () => {
  await type('x', 0.5);
  expect((await download()).volume).toBeCloseTo(1.5, 1);
  await type('y', 0);
  await type('z', 0);
  expect((await download()).volume).toBeCloseTo(6, 1);
  await page.getByRole('radio', { name: 'Turn' }).check();
  expect(await field('z').inputValue()).toBe('0');
  await type('z', 45);
  // A square turned by half a right angle, cut off by the side at x = 1, in a square from -1 to 1.
  const turned = (await download()).volume;
  expect(turned).toBeGreaterThan(5);
  expect(turned).toBeLessThan(6);
  await type('z', 90);
  expect((await download()).volume).toBeCloseTo(6, 1);
  await page.getByRole('radio', { name: 'Scale' }).check();
  expect(await field('y').inputValue()).toBe('1');
  await type('z', 0.5);
  expect((await download()).volume).toBeCloseTo(3, 1);
  await page.getByRole('radio', { name: 'Move' }).check();
  expect(await field('x').inputValue()).toBe('0.5');
});

test('what fields round stays exact along the other axes', async () => {
  await page.getByRole('radio', { name: 'Scale' }).check();
  await type('z', 0.50049);
  await page.getByRole('radio', { name: 'Move' }).check();
  await page.getByRole('radio', { name: 'Scale' }).check();
  expect(await field('z').inputValue()).toBe('0.5');
  await type('y', 1.5);
  await type('y', 1);
  await type('x', -1);
  await page.getByRole('radio', { name: 'Move' }).check();
  // Mirrored, and as high as it was.
  expect((await download()).volume).toBeCloseTo(3 * 1.00098, 3);
});

test('a field that is no number changes nothing', async () => {
  await field('x').fill('');
  expect(await field('x').getAttribute('aria-invalid')).toBe('true');
  await page.waitForTimeout(600);
  expect(await page.getAttribute('body', 'data-state')).toBe('done');
  expect((await download()).volume).toBeCloseTo(3, 1);
});

test('where nothing is left it is said', async () => {
  await type('x', 5);
  expect(await field('x').getAttribute('aria-invalid')).not.toBe('true');
  expect(await text('#error-text')).toMatch(/^EMPTY_RESULT: /);
  await type('x', 1);
  expect(await page.locator('#error').isVisible()).toBe(false);
});

// Where the handle that moves it along x ends: the rightmost spot of pure red.
async function handle() {
  const view = page.locator('#input-view');
  const picture = (await view.screenshot()).toString('base64');
  const spot = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(window.atob(base64), (char) => char.charCodeAt(0));
    const image = await window.createImageBitmap(new window.Blob([bytes]));
    const context = new window.OffscreenCanvas(image.width, image.height).getContext('2d');
    context.drawImage(image, 0, 0);
    const { data, width } = context.getImageData(0, 0, image.width, image.height);
    let found = [-1, -1];
    for (let i = 0; i < data.length; i += 4) {
      const x = (i / 4) % width;
      const red = data[i] > 240 && data[i + 1] < 10 && data[i + 2] < 10;
      if (red && x > found[0]) found = [x, Math.floor(i / 4 / width)];
    }
    return found;
  }, picture);
  const box = await view.boundingBox();
  return [box.x + spot[0] - 4, box.y + spot[1]];
}

test('dragging shows rough results at once, letting go the full one', async () => {
  await choose('difference');
  const full = await demo.picture('#output-view');
  const [x, y] = await handle();
  const top = (await page.locator('#stage').boundingBox()).y;
  const before = Number(await field('x').inputValue());
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 5; ++i) await page.mouse.move(x + 5 * i, y);
  await demo.waitFor(() => document.querySelector('#verdict').innerText.startsWith('Rough'));
  const rough = await demo.picture('#output-view');
  expect(await differentPixels(page, rough, full)).toBeGreaterThan(few);
  expect(await page.getAttribute('body', 'data-state')).toBe('dragging');
  expect(await page.locator('#save-obj').isVisible()).toBe(false);
  expect((await page.locator('#stage').boundingBox()).y).toBe(top);
  await page.screenshot({ path: join(screenshots, 'second-dragged.png') });
  await busyThenSettled(() => page.mouse.up());
  const after = Number(await field('x').inputValue());
  expect(after).toBeGreaterThan(before + 0.1);
  expect(await text('#verdict')).toBe('Closed · 2-manifold · 1 part');
  // It is 2 wide, 2 deep and 1 high.
  expect((await download()).volume).toBeCloseTo(8 - 2 * (2 - after), 1);
  await page.screenshot({ path: join(screenshots, 'second.png'), fullPage: true });
});

test('levels and distances go with the two as well', async () => {
  await page.locator('#heat').check();
  await page.locator('#heat-legend').waitFor();
  // Whatever the result has is a side of one of them.
  expect(Number(await text('#heat-2'))).toBeLessThan(0.01);
  await page.locator('#heat').uncheck();
});

test('it can be taken away', async () => {
  await busyThenSettled(() => page.getByRole('button', { name: 'Take it away' }).press('Enter'));
  expect(await page.locator('#second-controls').isVisible()).toBe(false);
  expect(await text('#changes-input')).toBe('Input');
  expect(await text('#second-name')).toBe('');
  const made = await download();
  expect(made.name).toBe('one-manifold.obj');
  expect(made.volume).toBeCloseTo(8, 2);
});

test('a file that is no mesh is refused, and a new first model drops the second', async () => {
  await page.locator('#second-file').setInputFiles({
    name: 'bad.obj',
    mimeType: 'text/plain',
    buffer: Buffer.from('v 1 2\n'),
  });
  await demo.waitFor(() => !document.querySelector('#error').hidden);
  expect(await text('#error-text')).toMatch(/^PARSE_ERROR: bad\.obj/);
  await busyThenSettled(() => page.locator('#second-sample').selectOption({ index: 6 }));
  expect(await text('#second-name')).toBe('and Cube');
  expect(await text('#verdict')).toMatch(/^Closed · 2-manifold/);
  await demo.choose('other.stl', cube(3));
  expect(await text('#second-name')).toBe('');
});

test('it fits on a narrow screen', async () => {
  const { page: narrow, errors } = await openPage(demo.browser, `${demo.address}/`, {
    viewport: { width: 390, height: 844 },
    colorScheme: 'dark',
  });
  const done = () => narrow.waitForFunction(() => document.body.dataset.state === 'done');
  await done();
  await narrow.locator('#second summary').click();
  await narrow.evaluate(() => (document.body.dataset.state = 'waiting'));
  await narrow.locator('#second-sample').selectOption({ index: 6 });
  await done();
  const overflow = await narrow.evaluate(
    () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
  );
  expect(overflow).toBe(0);
  await narrow.waitForTimeout(300);
  await narrow.screenshot({ path: join(screenshots, 'narrow-second.png'), fullPage: true });
  expect(errors).toEqual([]);
  await narrow.close();
});
