// SPDX-License-Identifier: MIT
// Models as scenes are made of, written as OBJ files: many loose parts, open, doubled and crossing, the same in every
// run.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { randomNumbers } from './shared.mjs';

/** Points and faces that parts are added to; every part keeps corners of its own. */
class Scene {
  lines = [];
  #points = 0;

  /** Adds a part: points, and faces as lists of their numbers from 0 on. */
  add(points, faces) {
    for (const point of points) this.lines.push(`v ${point.map((x) => x.toFixed(5)).join(' ')}`);
    for (const face of faces)
      this.lines.push(`f ${face.map((i) => i + this.#points + 1).join(' ')}`);
    this.#points += points.length;
  }
}

/** Where a part stands: turned at random, moved to `middle`. */
function placer(random, middle) {
  const [a, b, c] = [random(), random(), random()].map((x) => 2 * Math.PI * x);
  const turn = ([x, y], angle) => [
    Math.cos(angle) * x - Math.sin(angle) * y,
    Math.sin(angle) * x + Math.cos(angle) * y,
  ];
  return ([x, y, z]) => {
    [x, y] = turn([x, y], a);
    [y, z] = turn([y, z], b);
    [z, x] = turn([z, x], c);
    return [x + middle[0], y + middle[1], z + middle[2]];
  };
}

/** A rectangle of `rows` by `columns` quads, bent into place by `at`; `wrap` joins its first and last column. */
function sheet(rows, columns, at, wrap = false) {
  const across = wrap ? columns : columns + 1;
  const points = [];
  for (let row = 0; row <= rows; ++row) {
    for (let column = 0; column < across; ++column) points.push(at(row / rows, column / columns));
  }
  const number = (row, column) => row * across + (column % across);
  const faces = [];
  for (let row = 0; row < rows; ++row) {
    for (let column = 0; column < columns; ++column) {
      faces.push([
        number(row, column),
        number(row, column + 1),
        number(row + 1, column + 1),
        number(row + 1, column),
      ]);
    }
  }
  return [points, faces];
}

const boxFaces = [
  [0, 2, 3, 1],
  [4, 5, 7, 6],
  [0, 1, 5, 4],
  [2, 6, 7, 3],
  [0, 4, 6, 2],
  [1, 3, 7, 5],
];
const boxPoints = (size) =>
  Array.from({ length: 8 }, (_, i) => size.map((s, k) => s * (((i >> k) & 1) - 0.5)));

const backs = (faces) => faces.flatMap((face) => [face, [...face].reverse()]);

/** 1,200 parts of furniture: closed and lidless boxes, open bowls, doubled panels, bars; some cross each other. */
function kitchen(scene) {
  const random = randomNumbers(11);
  for (let i = 0; i < 1200; ++i) {
    const middle = [10 * random(), 6 * random(), 3 * random()];
    const place = i % 3 === 0 ? placer(random, middle) : (p) => p.map((x, k) => x + middle[k]);
    const size = [0, 1, 2].map(() => 0.08 + 0.5 * random());
    const kind = i % 5;
    if (kind === 0) scene.add(boxPoints(size).map(place), boxFaces);
    if (kind === 1) scene.add(boxPoints(size).map(place), boxFaces.slice(1));
    if (kind === 2) {
      const [points, faces] = sheet(
        10,
        16,
        (v, u) => {
          const [ring, turn] = [Math.sin((Math.PI / 2) * (0.02 + 0.98 * v)), 2 * Math.PI * u];
          const up = 1 - Math.cos((Math.PI / 2) * v);
          return [size[0] * ring * Math.cos(turn), size[0] * ring * Math.sin(turn), size[1] * up];
        },
        true,
      );
      scene.add(points.map(place), faces);
    }
    if (kind === 3) {
      const [points, faces] = sheet(8, 8, (v, u) => [
        size[0] * u,
        size[1] * v,
        0.03 * Math.sin(5 * u),
      ]);
      scene.add(points.map(place), backs(faces));
    }
    if (kind === 4) {
      const bar = (v, u) => {
        const turn = 2 * Math.PI * u;
        return [0.02 * Math.cos(turn), 0.02 * Math.sin(turn), size[2] * v];
      };
      const [points, faces] = sheet(6, 12, bar, true);
      scene.add(points.map(place), faces);
    }
  }
}

/** Quads by themselves, which enclose nothing: what a plant's leaves are made of. */
function leaves(scene) {
  const random = randomNumbers(12);
  for (let i = 0; i < 1500; ++i) {
    const place = placer(
      random,
      [0, 1, 2].map(() => 4 * random()),
    );
    scene.add(
      ...placed(
        sheet(1, 1, (v, u) => [0.3 * u, 0.15 * v, 0]),
        place,
      ),
    );
  }
}

/** Trunks that are closed, and round them bent leaves, each with its back. */
function foliage(scene) {
  const random = randomNumbers(13);
  for (let tree = 0; tree < 4; ++tree) {
    const foot = [3 * (tree % 2), 3 * (tree >> 1), 0];
    scene.add(
      boxPoints([0.3, 0.3, 2]).map((p) => p.map((x, k) => x + foot[k])),
      boxFaces,
    );
    for (let i = 0; i < 400; ++i) {
      const [turn, out, up] = [2 * Math.PI * random(), 0.3 + random(), 0.5 + 1.5 * random()];
      const middle = [foot[0] + out * Math.cos(turn), foot[1] + out * Math.sin(turn), up];
      const [points, faces] = placed(
        sheet(4, 2, (v, u) => [0.2 * v, 0.1 * u, 0.04 * v * v]),
        placer(random, middle),
      );
      scene.add(points, backs(faces));
    }
  }
}

/** A game's asset: closed shapes and sheets, every face with its back. */
function doubled(scene) {
  const random = randomNumbers(14);
  for (let i = 0; i < 300; ++i) {
    const middle = [4 * random(), 4 * random(), 4 * random()];
    const place = placer(random, middle);
    const size = 0.1 + 0.3 * random();
    const ball = (v, u) => {
      const [up, turn] = [Math.PI * (0.02 + 0.96 * v), 2 * Math.PI * u];
      return [
        size * Math.sin(up) * Math.cos(turn),
        size * Math.sin(up) * Math.sin(turn),
        size * Math.cos(up),
      ];
    };
    const [points, faces] = placed(sheet(10, 16, ball, true), place);
    // Two in three have lids on both ends.
    if (i % 3 > 0) {
      faces.push(Array.from({ length: 16 }, (_, k) => 15 - k));
      faces.push(Array.from({ length: 16 }, (_, k) => 160 + k));
    }
    scene.add(points, backs(faces));
  }
}

const placed = ([points, faces], place) => [points.map(place), faces];

/** Writes the models into a folder; returns their files. */
export function writeSoups(folder) {
  return Object.entries({ kitchen, leaves, foliage, doubled }).map(([name, build]) => {
    const scene = new Scene();
    build(scene);
    const file = join(folder, `${name}.obj`);
    writeFileSync(file, `${scene.lines.join('\n')}\n`);
    return file;
  });
}
