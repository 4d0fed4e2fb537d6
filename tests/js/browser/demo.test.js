// SPDX-License-Identifier: MIT
// The demo page as a visitor meets it, in Chromium: built, served, under its own strict policy.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { differentPixels, openPage } from '../support/browser.js';
import { few, openDemo, screenshots } from '../support/demo.js';
import { cube, faults, together, torus } from '../support/meshes.js';

let demo;
let page;
let kdm;
let settled;
let inspected;
let busyThenSettled;
let text;
let file;
let choose;
let fact;

beforeAll(async () => {
  demo = await openDemo('demo');
  ({ page, kdm, settled, inspected, busyThenSettled, text, file, choose, fact } = demo);
}, 180_000);

afterAll(() => demo?.close());

afterEach(() => expect(demo.errors).toEqual([]));

test('starts with a damaged sample already repaired', async () => {
  await settled();
  await inspected();
  expect(await text('#verdict')).toBe('Closed · 2-manifold · 1 part · 1 tunnel');
  expect(await text('#input-name')).toMatch(/^Damaged knot, [\d,]+ triangles$/);
  expect(await text('#output-name')).toMatch(/[\d,]+ triangles/);
  expect(await text('#story')).toMatch(
    /^The input has 1 part; it is open .* turned the wrong way, [\d,]+ faces are doubled/,
  );
  expect(await text('#remedy')).toMatch(
    /^Done about it: [\d,]+ faces turned, 8 holes closed by patches, .* copies of faces left out/,
  );
  await page.waitForTimeout(300);
  await page.screenshot({ path: join(screenshots, 'start.png') });
});

test('a sample may be chosen; numbers tell of it', async () => {
  for (const details of ['.numbers', '#more']) await page.locator(`${details} summary`).click();
  await busyThenSettled(() => page.locator('#sample').selectOption({ index: 1 }));
  await inspected();
  expect(await text('#verdict')).toMatch(/^Closed · 2-manifold · 1 part · \d+ tunnels$/);
  expect(await text('#input-name')).toMatch(/Bracket.*900 triangles/);
  expect(await fact('input-facts', 'Parts')).toBe('5');
  expect(await fact('output-facts', '2-manifold')).toBe('yes');
  expect(await fact('grid-facts', 'Build')).toMatch(/^[\d.]+ s$/);
  expect(await text('#story')).toMatch(
    /^The input has 5 parts and is closed; \d+ faces cross each other\.$/,
  );
  expect(await page.locator('#gaps').isVisible()).toBe(false);
});

test('both views show something, and not the same', async () => {
  const shot = (id) => page.locator(id).screenshot();
  const [input, output] = [await shot('#input-view'), await shot('#output-view')];
  const empty = 4000; // bytes of an image of one colour with a caption
  expect(input.length).toBeGreaterThan(empty);
  expect(output.length).toBeGreaterThan(empty);
});

test('a chosen file is converted', async () => {
  await choose('ring.stl', torus());
  expect(await text('#verdict')).toBe('Closed · 2-manifold · 1 part · 1 tunnel');
  expect(await text('#input-name')).toBe('ring.stl, 1,024 triangles');
});

test('the sample that was shown before a file can be chosen again', async () => {
  const menu = page.locator('#sample');
  expect(await menu.evaluate((select) => select.selectedIndex)).toBe(-1);
  await busyThenSettled(() => menu.selectOption({ index: 1 }));
  expect(await text('#input-name')).not.toContain('ring.stl');
  await choose('ring.stl', torus());
  await busyThenSettled(() => menu.selectOption({ index: 1 }));
  expect(await text('#input-name')).not.toContain('ring.stl');
});

// A cube without one of its triangles, with another one twice and one of no area, and beside it a
// cube inside out.
function broken() {
  const { positions, indices } = cube();
  const doubled = indices.subarray(6, 9);
  const open = { positions, indices: [...indices.subarray(3), ...doubled, 0, 0, 1] };
  const inverted = cube(2, [3, 0, 0]);
  return together(open, { ...inverted, indices: inverted.indices.slice().reverse() });
}
const legend = () => page.locator('#legend label').allInnerTexts();
const switchOf = (kind) => page.locator(`#legend input[data-kind="${kind}"]`);

test('defects are told in words, counted and painted, each kind to be switched off', async () => {
  await choose('broken.obj', broken());
  await inspected();
  expect(await text('#story')).toBe(
    'The input has 2 parts; it is open (3 edges round 1 hole), 3 edges have three or more faces, ' +
      '12 faces are turned the wrong way, 1 face is doubled, 1 face has no area, ' +
      'and 2 faces cross each other.',
  );
  expect(await text('#remedy')).toMatch(
    /^Done about it: 12 faces turned, .* 1 copy of a face left out/,
  );
  expect(await legend()).toEqual([
    'Open edges (3)',
    'Edges of three or more faces (3)',
    'Faces turned the wrong way (12)',
    'Doubled faces (1)',
    'Faces without area (1)',
    'Crossing faces (2)',
    expect.stringMatching(/^New faces that close holes \(\d+\)$/),
  ]);
  await page.screenshot({ path: join(screenshots, 'defects.png') });
  const picture = () => demo.picture('#input-view');
  const painted = await picture();
  for (const kind of ['open', 'crowded', 'flipped']) {
    await switchOf(kind).uncheck();
    expect(await differentPixels(page, await picture(), painted)).toBeGreaterThan(few);
    await switchOf(kind).check();
  }
  expect(await differentPixels(page, await picture(), painted)).toBeLessThan(few);
});

test('what closes holes is painted on the result', async () => {
  const picture = () => demo.picture('#output-view');
  const painted = await picture();
  await switchOf('invented').uncheck();
  expect(await differentPixels(page, await picture(), painted)).toBeGreaterThan(few);
  await switchOf('invented').check();
  expect(await differentPixels(page, await picture(), painted)).toBeLessThan(few);
});

test('what is switched off stays off with the next model', async () => {
  await switchOf('open').uncheck();
  const { positions, indices } = cube();
  await choose('open.stl', { positions, indices: indices.slice(6) });
  await inspected();
  expect(await text('#story')).toBe('The input has 1 part; it is open (4 edges round 1 hole).');
  expect(await switchOf('open').isChecked()).toBe(false);
  await switchOf('open').check();
});

test('a clean model has nothing painted on it', async () => {
  await choose('cube.off', cube());
  await inspected();
  expect(await text('#story')).toBe('The input has 1 part and is closed and free of defects.');
  expect(await page.locator('#legend').isVisible()).toBe(false);
  // What is asked for, and what came of it.
  expect(await text('#size-hint')).toMatch(/^The result aims to stay within [\d.]+ % of the model/);
  const measured = Number((await text('#distance-hint')).match(/at most ([\d.]+) %/)[1]);
  expect(measured).toBeLessThan(0.2);
});

test('what is missing is painted on the input, and said first', async () => {
  // A square that stands on a cube and bounds nothing.
  const { positions, indices } = cube();
  const fin = [-0.5, 0, 1, 0.5, 0, 1, 0.5, 0, 2, -0.5, 0, 2];
  const mesh = {
    positions: Float32Array.from([...positions, ...fin]),
    indices: Uint32Array.from([...indices, 8, 9, 10, 8, 10, 11]),
  };
  await choose('fin.ply', mesh);
  await inspected();
  expect(await text('#warnings li:first-child')).toMatch(/missing from the result/);
  // The fin reaches 1 above the cube; the diagonal is that of the cube, of which the fin is no part.
  expect(await text('#distance-hint')).toMatch(/^Measured: at most [\d.]+ % of it apart\.$/);
  const measured = Number((await text('#distance-hint')).match(/[\d.]+/)[0]);
  expect(measured).toBeGreaterThan(20);
  expect(measured).toBeLessThan(35);
  const box = page.getByRole('checkbox', { name: 'Missing from the result (2)' });
  expect(await box.isChecked()).toBe(true);
  const painted = await page.locator('#stage').screenshot({ path: join(screenshots, 'lost.png') });
  await box.focus();
  await page.keyboard.press('Space');
  const bare = await page.locator('#stage').screenshot();
  expect(await differentPixels(page, painted, bare)).toBeGreaterThan(few);
  await page.keyboard.press('Space');
});

// What the table says once both sides have been counted.
async function changes() {
  await inspected();
  await demo.waitFor(() => !document.querySelector('#changes').innerText.includes('…'));
  const rows = page.locator('#changes tbody tr');
  return rows.evaluateAll((list) =>
    list.map((row) => [...row.children].map((cell) => cell.innerText).join(' | ')),
  );
}
const changed = () => page.locator('#changes .changed th').allInnerTexts();

test('what input and result consist of stands side by side', async () => {
  const inner = cube(0.5);
  const hollow = { ...inner, indices: inner.indices.slice().reverse() };
  // Two tubes that cross, and a cube with a hollow.
  const mesh = together(torus(), torus(32, 16, 2.5), cube(1, [9, 0, 0]), {
    ...hollow,
    positions: hollow.positions.map((value, i) => value + (i % 3 === 0 ? 9 : 0)),
  });
  await choose('sides.obj', mesh);
  expect(await changes()).toEqual([
    expect.stringMatching(/^Triangles \| 2,072 \| [\d,]+$/),
    'Parts | 4 | 3',
    'of them cavities | 1 | 1',
    'Tunnels | 2 | 1',
    'Holes | 0 | 0',
  ]);
  expect(await changed()).toEqual(['Parts', 'Tunnels']);
  expect(await text('#changes-hint')).toBe('');
});

test('what cannot be counted is not made up', async () => {
  await choose('broken.obj', broken());
  const told = await changes();
  expect(told.slice(1)).toEqual([
    'Parts | 2 | 2',
    'of them cavities | 0 | 0',
    'Tunnels | not known | 0',
    'Holes | 1 | 0',
  ]);
  expect(await changed()).toEqual(['Holes']);
  expect(await text('#changes-hint')).toBe(
    'Tunnels of the input cannot be counted: its faces are no oriented surface.',
  );
});

test('spots where the topology was given up are marked', async () => {
  await choose('crossing.ply', together(torus(), cube(2, [3, 0, 0])));
  await inspected();
  const name = /^Spots where the topology was given up \([\d,]+\)$/;
  const box = page.getByRole('checkbox', { name });
  const painted = await page.locator('#stage').screenshot();
  await box.uncheck();
  const bare = await page.locator('#stage').screenshot();
  expect(await differentPixels(page, painted, bare)).toBeGreaterThan(few);
  await box.check();
});

test('a new model does not wait for the inspection of the one before', async () => {
  // Twelve thousand triangles that all cross, in a corner: seventy million pairs to be looked at.
  const { positions, indices } = cube();
  const corners = Array.from({ length: 12_000 }, (_, i) => [
    1,
    1,
    1 + i * 1e-7,
    1.01,
    1,
    1,
    1,
    1.01,
    1,
  ]);
  const numbers = Array.from({ length: 36_000 }, (_, i) => 8 + i);
  const slow = { positions: [...positions, ...corners.flat()], indices: [...indices, ...numbers] };
  await page.locator('#file').setInputFiles(file('slow.ply', together(slow)));
  await page.waitForFunction(() => /crossings…/.test(document.querySelector('#story').innerText));
  await choose('ring.stl', torus());
  await inspected();
  expect(await text('#story')).toBe('The input has 1 part and is closed and free of defects.');
});

test('a dropped file is converted', async () => {
  const content = [...kdm.formatMesh(together(cube(2), cube(2, [1, 1, 1])), 'obj')];
  const transfer = await page.evaluateHandle((bytes) => {
    const data = new window.DataTransfer();
    data.items.add(new window.File([new Uint8Array(bytes)], 'two cubes.obj'));
    return data;
  }, content);
  await busyThenSettled(() => page.dispatchEvent('#stage', 'drop', { dataTransfer: transfer }));
  expect(await text('#verdict')).toBe('Closed · 2-manifold · 1 part');
  expect(await text('#input-name')).toBe('two cubes.obj, 24 triangles');
  await page.screenshot({ path: join(screenshots, 'dropped.png') });
});

test('strategy and depth change the result', async () => {
  await busyThenSettled(() => page.selectOption('#strategy', 'uniform'));
  expect(await page.locator('#depth').isVisible()).toBe(true);
  expect(await page.locator('#tolerance').isVisible()).toBe(false);
  const before = await fact('output-facts', 'Triangles');
  await busyThenSettled(() => page.locator('#depth').fill('12'));
  expect(await fact('output-facts', 'Triangles')).not.toBe(before);
  expect(await fact('grid-facts', 'Depth reached')).toBe('12');
  await busyThenSettled(() => page.selectOption('#strategy', 'adaptive'));
  expect(await page.locator('#tolerance').isVisible()).toBe(true);
});

test('wireframe, edges and cut change the picture, not the result', async () => {
  const picture = () => demo.picture('#stage');
  const plain = await picture();
  await page.locator('#wireframe').check();
  const wired = await picture();
  expect(await differentPixels(page, wired, plain)).toBeGreaterThan(few);
  await page.locator('#wireframe').uncheck();
  await page.locator('#cut').fill('50');
  expect(await differentPixels(page, await picture(), plain)).toBeGreaterThan(few);
  await page.screenshot({ path: join(screenshots, 'cut.png') });
  await page.locator('#cut').fill('0');
  expect(await differentPixels(page, await picture(), plain)).toBeLessThan(few);
  expect(await page.getAttribute('body', 'data-state')).toBe('done');
});

test('up may be another axis', async () => {
  const picture = () => demo.picture('#stage');
  // As is usual for OBJ.
  expect(await page.inputValue('#up')).toBe('y');
  // The page may have taken its final form after the model was first looked at.
  await page.locator('#reset-view').click();
  const before = await picture();
  await page.selectOption('#up', 'z');
  expect(await differentPixels(page, await picture(), before)).toBeGreaterThan(few);
  await page.selectOption('#up', 'y');
  expect(await differentPixels(page, await picture(), before)).toBeLessThan(few);
});

test('the view goes to a side and comes back', async () => {
  const picture = () => demo.picture('#input-view');
  const before = await picture();
  const seen = [before];
  for (const side of ['front', 'right', 'back', 'left', 'above', 'below']) {
    await page.locator(`[data-side="${side}"]`).click();
    const shot = await picture();
    expect(await differentPixels(page, shot, seen.at(-1))).toBeGreaterThan(few);
    seen.push(shot);
  }
  await page.locator('#reset-view').click();
  expect(await differentPixels(page, await picture(), before)).toBeLessThan(few);
});

test('the view turns by keyboard and comes back', async () => {
  const picture = () => demo.picture('#input-view');
  const before = await picture();
  await page.locator('#stage').focus();
  await page.keyboard.press('ArrowRight');
  expect(await differentPixels(page, await picture(), before)).toBeGreaterThan(few);
  await page.locator('#reset-view').click();
  expect(await differentPixels(page, await picture(), before)).toBeLessThan(few);
});

test.each(['obj', 'stl', 'ply'])('the result can be downloaded as %s', async (format) => {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.locator(`#save-${format}`).click(),
  ]);
  expect(download.suggestedFilename()).toBe(`two cubes-manifold.${format}`);
  const mesh = kdm.parseMesh(readFileSync(await download.path()), format);
  if (format === 'stl') expect(mesh.indices.length).toBeGreaterThan(0);
  else expect(faults(mesh)).toEqual([]);
});

test('an open mesh becomes a solid', async () => {
  const { positions, indices } = cube();
  await choose('open.ply', { positions, indices: indices.slice(3) });
  await inspected();
  expect(await text('#verdict')).toBe('Closed · 2-manifold · 1 part');
  expect(await text('#story')).toBe('The input has 1 part; it is open (3 edges round 1 hole).');
  expect(await text('#remedy')).toMatch(
    /^Done about it: 1 hole closed by patches(, which invented [\d.]+% of the area)?\.$/,
  );
  await page.screenshot({ path: join(screenshots, 'open.png') });
});

test('gaps can be closed more or less, where there are any', async () => {
  expect(await page.locator('#gaps').isVisible()).toBe(true);
  const area = async () => /invented ([\d.]+)%/.exec(await text('#remedy'))[1];
  await busyThenSettled(() => page.locator('#gaps').fill('20'));
  expect(await text('#gaps-value')).toBe('20 %');
  expect(await text('#remedy')).toMatch(/holes and gaps closed/);
  const little = await area();
  await busyThenSettled(() => page.locator('#gaps').fill('80'));
  expect(Number(await area())).not.toBe(Number(little));
  await choose('cube.off', cube());
  expect(await page.locator('#gaps').isVisible()).toBe(false);
});

test('parts can be left out', async () => {
  const inner = cube(0.5);
  const hollow = { ...inner, indices: inner.indices.slice().reverse() };
  await choose('parts.obj', together(cube(1), hollow, cube(0.5, [3, 0, 0])));
  expect(await text('#verdict')).toMatch(/3 parts$/);
  await busyThenSettled(() => page.selectOption('#parts', 'outer'));
  expect(await text('#verdict')).toMatch(/2 parts$/);
  expect(await text('#remedy')).toBe('Done about it: 1 part left out.');
  await busyThenSettled(() => page.selectOption('#parts', 'largest'));
  expect(await text('#verdict')).toMatch(/1 part$/);
  await busyThenSettled(() => page.selectOption('#parts', 'all'));
});

const square = () => ({ ...cube(), indices: cube().indices.slice(0, 6) });

test('what encloses nothing: the error is text on the page, and there are ways on', async () => {
  await choose('square.ply', square());
  expect(await text('#error-text')).toMatch(/^NOT_CLOSED: .*encloses nothing/);
  expect(await text('#verdict')).toBe('No result.');
  expect(await page.locator('#save-obj').isDisabled()).toBe(true);
  await page.screenshot({ path: join(screenshots, 'error.png') });
  await busyThenSettled(() => page.locator('#keep-open').click());
  expect(await page.locator('#error').isVisible()).toBe(false);
  expect(await text('#verdict')).toBe('Open · 2-manifold · 1 rim · 1 part');
  expect(await page.inputValue('#make')).toBe('sheet');
  expect(await page.locator('#parts').isVisible()).toBe(false);
  expect(await page.locator('#save-obj').isDisabled()).toBe(false);
  await busyThenSettled(() => page.selectOption('#make', 'solid'));
  expect(await page.locator('#error').isVisible()).toBe(true);
});

test('a thickness makes a shell of it, in per cent or in units', async () => {
  await busyThenSettled(() => page.getByRole('button', { name: 'Give it a thickness' }).click());
  expect(await page.inputValue('#make')).toBe('shell');
  expect(await text('#verdict')).toBe('Closed · 2-manifold · 1 part');
  // Of a square with sides of 2.
  expect(await text('#thickness-hint')).toBe("0.0283 in the model's units.");
  expect(await text('#remedy')).toMatch(/^Done about it: a shell 0\.0283 thick built around it/);
  await page.screenshot({ path: join(screenshots, 'shell.png') });
  await page.selectOption('#thickness-unit', 'units');
  expect(await page.inputValue('#thickness')).toBe('0.02828');
  await busyThenSettled(() => page.locator('#thickness').fill('0.2'));
  expect(await text('#thickness-hint')).toBe("7.07 % of the model's diagonal.");
  expect(await text('#remedy')).toMatch(/a shell 0\.2 thick/);
  await busyThenSettled(() => page.locator('#thickness').fill('0'));
  expect(await text('#error-text')).toBe('The thickness must be a number above 0.');
  expect(await page.locator('#ways').isVisible()).toBe(false);
  await page.locator('#thickness').fill('1');
  await page.selectOption('#thickness-unit', 'percent');
  await busyThenSettled(() => page.selectOption('#make', 'solid'));
});

test('by a rule for closed surfaces an open one is refused, and can be repaired', async () => {
  const { positions, indices } = cube();
  await busyThenSettled(() => page.selectOption('#inside', 'odd'));
  await choose('open.ply', { positions, indices: indices.slice(3) });
  expect(await text('#error-text')).toMatch(/^NOT_CLOSED: /);
  await busyThenSettled(() => page.locator('#repair').click());
  expect(await page.inputValue('#inside')).toBe('repair');
  expect(await text('#verdict')).toBe('Closed · 2-manifold · 1 part');
});

test('a file that is no mesh, and a file of an unknown type', async () => {
  await choose({ name: 'bad.obj', mimeType: 'text/plain', buffer: Buffer.from('v 1 2\n') });
  expect(await text('#error')).toMatch(/^PARSE_ERROR: bad\.obj.*1/);
  await choose({ name: 'part.step', mimeType: 'text/plain', buffer: Buffer.from('ISO') });
  expect(await text('#error')).toMatch(/^IO_ERROR: part\.step/);
});

test('after errors every sample still works', async () => {
  const count = await page.locator('#sample option').count();
  expect(count).toBeGreaterThanOrEqual(4);
  for (let i = 0; i < count; ++i) {
    await busyThenSettled(async () => {
      await page.locator('#sample').selectOption({ index: i });
    });
    expect(await page.locator('#error').isVisible()).toBe(false);
    expect(await text('#verdict')).toMatch(/^Closed · 2-manifold/);
  }
});

test('stop ends a long conversion', async () => {
  await page.selectOption('#strategy', 'uniform');
  await page.locator('#depth').fill('27');
  await page.locator('#cancel').click();
  await settled();
  expect(await text('#error')).toMatch(/^ABORTED/);
  await busyThenSettled(() => page.selectOption('#strategy', 'adaptive'));
  expect(await text('#verdict')).toMatch(/^Closed/);
});

test('stop ends the reading of a file', async () => {
  const rows = Array.from({ length: 400_000 }, (_, i) => `v ${i} ${i % 7} ${i % 11}\nf 1 2 3\n`);
  const buffer = Buffer.from(rows.join(''));
  await page.locator('#file').setInputFiles({ name: 'long.obj', mimeType: 'text/plain', buffer });
  await page.locator('#cancel').click();
  await settled();
  expect(await text('#error-text')).toMatch(/^ABORTED/);
  await choose('cube.off', cube());
  expect(await text('#verdict')).toMatch(/^Closed/);
});

test('dark and on a narrow screen', async () => {
  const { page: narrow, errors: narrowErrors } = await openPage(demo.browser, `${demo.address}/`, {
    viewport: { width: 400, height: 800 },
    colorScheme: 'dark',
  });
  await narrow.waitForFunction(() => document.body.dataset.state === 'done');
  const overflow = await narrow.evaluate(
    () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
  );
  expect(overflow).toBe(0);
  await narrow.waitForTimeout(300);
  await narrow.screenshot({ path: join(screenshots, 'narrow-dark.png'), fullPage: true });
  expect(narrowErrors).toEqual([]);
  await narrow.close();
});
