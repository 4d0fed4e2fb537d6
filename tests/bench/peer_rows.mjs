// SPDX-License-Identifier: MIT
// What README's tables of peers say, and how: the programs that make the tables and the test that reads them share it.

export const damageCommand = 'npm run bench -- --peers --readme';
export const equalCommand = 'npm run bench -- --equal MODEL... --readme';

/** Whose results stand in the table of damaged inputs. */
export const damageEngines = ['kdmanifold', 'meshoptimizer remesh 128', 'manifold-3d'];
export const damages = [
  'closed and clean',
  'five overlapping parts',
  'five holes',
  '30 % of the faces turned',
  'torn apart into single faces',
  'every ninth face twice',
];

/** A cell: a result, or the reason why there is none. */
export function damageCell({ refused, twoManifold, off, triangles, milliseconds }) {
  if (refused !== undefined) return `refused (${refused})`;
  const solid = twoManifold ? '2-manifold' : 'not manifold';
  const size = Math.abs(off).toFixed(2);
  const percent = `${off < 0 && Number(size) > 0 ? '−' : '+'}${size} %`;
  return `${solid}, ${percent}, ${triangles.toLocaleString('en')} triangles, ${milliseconds} ms`;
}

/** What a cell says. */
export function readDamageCell(cell) {
  const refused = /^refused \((\w+)\)$/.exec(cell)?.[1];
  if (refused !== undefined) return { refused };
  const pattern = /^(2-manifold|not manifold), ([+−])([\d.]+) %, ([\d,]+) triangles, (\d+) ms$/;
  const [, solid, sign, size, triangles, milliseconds] = pattern.exec(cell) ?? [];
  return {
    twoManifold: solid === '2-manifold',
    off: (sign === '−' ? -1 : 1) * Number(size),
    triangles: Number(triangles?.replaceAll(',', '')),
    milliseconds: Number(milliseconds),
  };
}

/** The ways to the same mesh that stand beside each other for every model of the other table. */
export const equalWays = [
  'kdmanifold, within 0.1 %',
  'meshoptimizer remesh and simplify, as many triangles',
  'the same, equal rms',
  'the same, equal largest',
  'manifold-3d simplify, as many triangles',
];

/** A row of that table. Distances are shares of the diagonal; `stages` are shares of the time. */
export function equalRow({ model, way, refused, triangles, largest, rms, ...rest }) {
  const { twoManifold, crossings, milliseconds, stages = {} } = rest;
  const parts = Object.entries(stages).map(([name, part]) => `${name} ${Math.round(100 * part)} %`);
  const cells =
    refused === undefined
      ? {
          triangles: triangles.toLocaleString('en'),
          'largest, %': (100 * largest).toFixed(3),
          'rms, %': (100 * rms).toFixed(4),
          '2-manifold': twoManifold ? 'yes' : 'no',
          crossings: crossings.toLocaleString('en'),
          time: [`${milliseconds} ms`, parts.join(', ')].filter(Boolean).join(': '),
        }
      : {
          triangles: refused,
          ...Object.fromEntries(equalNumbers.map((name) => [name, ''])),
        };
  return { model, 'made by': way, ...cells };
}

const equalNumbers = ['largest, %', 'rms, %', '2-manifold', 'crossings', 'time'];

/** What a row says. */
export function readEqualRow(row) {
  const { model, 'made by': way, triangles } = row;
  if (!/^[\d,]+$/.test(triangles)) return { model, way, refused: triangles };
  const [, milliseconds, parts = ''] = /^(\d+) ms(?:: (.+))?$/.exec(row.time) ?? [];
  const stages = [...parts.matchAll(/(\w+) (\d+) %/g)].map(([, name, part]) => [name, part / 100]);
  const number = (text) => Number(text.replaceAll(',', ''));
  return {
    ...{ model, way, triangles: number(triangles) },
    ...{ largest: number(row['largest, %']) / 100, rms: number(row['rms, %']) / 100 },
    ...{ twoManifold: row['2-manifold'] === 'yes', crossings: number(row.crossings) },
    ...{ milliseconds: Number(milliseconds), stages: Object.fromEntries(stages) },
  };
}
