// SPDX-License-Identifier: MIT
// Walks the nodes of a scene of a GLB file and collects its triangles, as src/cli/glb/read.cpp does: the same sums in
// the same order, so that the same numbers come out.
import { readNumbers, readPoints } from './glb-arrays.js';
import { isObject, openGlb, type GlbFile, type Json } from './glb-file.js';
import type { MeshInput, Warning } from '../types.js';

/** What is read of a file: all meshes of the scene, where its nodes put them, and what was left out. */
export interface GlbScene {
  mesh: MeshInput;
  warnings: Warning[];
}

type Matrix = number[]; // column by column
// Beyond this the library refuses coordinates.
const furthest = 1e150;
const identity: Matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

function product(a: Matrix, b: Matrix): Matrix {
  return Array.from({ length: 16 }, (_, i) => {
    const row = i % 4;
    const column = i - row;
    let sum = 0;
    for (let k = 0; k < 4; ++k) sum += (a[4 * k + row] ?? 0) * (b[column + k] ?? 0);
    return sum;
  });
}

function determinant(matrix: Matrix): number {
  const m = (i: number): number => matrix[i] ?? 0;
  return (
    m(0) * (m(5) * m(10) - m(9) * m(6)) -
    m(4) * (m(1) * m(10) - m(9) * m(2)) +
    m(8) * (m(1) * m(6) - m(5) * m(2))
  );
}

// Where a node puts its children and its mesh.
function localMatrix(file: GlbFile, node: Json, path: string): Matrix {
  const numbers = <T extends number[]>(key: string, standard: T): T => {
    if (!Object.hasOwn(node, key)) return standard;
    const found = node[key];
    const { length } = standard;
    if (
      Array.isArray(found) &&
      found.length === length &&
      found.every((n) => typeof n === 'number')
    ) {
      return found as T;
    }
    return file.fail(`${path}.${key} is no list of ${length} numbers`);
  };
  if (Object.hasOwn(node, 'matrix')) return numbers('matrix', identity);
  const t = numbers<[number, number, number]>('translation', [0, 0, 0]);
  const [x, y, z, w] = numbers<[number, number, number, number]>('rotation', [0, 0, 0, 1]);
  const s = numbers<[number, number, number]>('scale', [1, 1, 1]);
  return [
    (1 - 2 * (y * y + z * z)) * s[0],
    2 * (x * y + w * z) * s[0],
    2 * (x * z - w * y) * s[0],
    0,
    2 * (x * y - w * z) * s[1],
    (1 - 2 * (x * x + z * z)) * s[1],
    2 * (y * z + w * x) * s[1],
    0,
    2 * (x * z + w * y) * s[2],
    2 * (y * z - w * x) * s[2],
    (1 - 2 * (x * x + y * y)) * s[2],
    0,
    t[0],
    t[1],
    t[2],
    1,
  ];
}

// Cuts strips (5) and fans (6) into triangles, as the specification of glTF numbers their corners.
function* cut(corners: ArrayLike<number>, mode: number): Generator<[number, number, number]> {
  const corner = (i: number): number => corners[i] ?? 0;
  for (let i = 0; i + 2 < corners.length; i += mode === 4 ? 3 : 1) {
    if (mode === 4) yield [corner(i), corner(i + 1), corner(i + 2)];
    else if (mode === 5) yield [corner(i), corner(i + 1 + (i % 2)), corner(i + 2 - (i % 2))];
    else yield [corner(i + 1), corner(i + 2), corner(0)];
  }
}

// A list of numbers that grows without one object a number.
class Numbers<T extends Float64Array | Uint32Array> {
  length = 0;
  #array: T;
  readonly #make: (length: number) => T;

  constructor(make: (length: number) => T) {
    this.#make = make;
    this.#array = make(1024);
  }

  push(a: number, b: number, c: number): void {
    if (this.length + 3 > this.#array.length) {
      const larger = this.#make(2 * this.#array.length);
      larger.set(this.#array);
      this.#array = larger;
    }
    this.#array[this.length++] = a;
    this.#array[this.length++] = b;
    this.#array[this.length++] = c;
  }

  finish(): T {
    return this.#array.slice(0, this.length) as T;
  }
}

interface Visit {
  node: number;
  user: string;
  parent: Matrix;
}

// Vertices of the result, one after the other.
interface Placed {
  first: number;
  count: number;
}

class Collector {
  readonly #file: GlbFile;
  readonly #positions = new Numbers((length) => new Float64Array(length));
  readonly #indices = new Numbers((length) => new Uint32Array(length));
  readonly #visited = new Set<number>();
  #leftOut = 0; // primitives
  #skins = false;

  constructor(file: GlbFile) {
    this.#file = file;
  }

  async collect(): Promise<GlbScene> {
    const file = this.#file;
    const { length } = file.list(file.json, 'nodes', 'the JSON');
    if (length === 0) {
      const count = file.list(file.json, 'meshes', 'the JSON').length;
      for (let i = 0; i < count; ++i) await this.#addMesh(i, 'the JSON', identity);
    }
    await this.#walk(this.#roots(length));
    return this.#finish();
  }

  // The nodes of the scene; without a scene all that are no children.
  #roots(nodeCount: number): Visit[] {
    const file = this.#file;
    if (file.list(file.json, 'scenes', 'the JSON').length === 0) {
      const children = new Set<number>();
      for (let i = 0; i < nodeCount; ++i) {
        const path = `nodes[${i}]`;
        for (const child of this.#children(file.element('nodes', i, path), path)) {
          children.add(child);
        }
      }
      return Array.from({ length: nodeCount }, (_, node) => node)
        .filter((node) => !children.has(node))
        .map((node) => ({ node, user: 'the JSON', parent: identity }));
    }
    const scene = file.whole(file.json, 'scene', 'the JSON', 0);
    const path = `scenes[${scene}]`;
    return file.list(file.element('scenes', scene, 'the JSON'), 'nodes', path).map((node) => ({
      node: file.number(node, `${path}.nodes`),
      user: path,
      parent: identity,
    }));
  }

  #children(node: Json, path: string): number[] {
    const file = this.#file;
    return file.list(node, 'children', path).map((child) => file.number(child, `${path}.children`));
  }

  // Parents before children, children in their order.
  async #walk(roots: Visit[]): Promise<void> {
    const file = this.#file;
    const stack = roots.reverse();
    for (let visit = stack.pop(); visit !== undefined; visit = stack.pop()) {
      const node = file.element('nodes', visit.node, visit.user);
      const path = `nodes[${visit.node}]`;
      if (this.#visited.has(visit.node)) file.fail(`${path} has two parents`);
      this.#visited.add(visit.node);
      const world = product(visit.parent, localMatrix(file, node, path));
      if (Object.hasOwn(node, 'mesh')) {
        await this.#addMesh(file.whole(node, 'mesh', path), path, world);
      }
      if (Object.hasOwn(node, 'skin')) this.#skins = true;
      for (const child of this.#children(node, path).reverse()) {
        stack.push({ node: child, user: path, parent: world });
      }
    }
  }

  async #addMesh(index: number, user: string, world: Matrix): Promise<void> {
    const file = this.#file;
    const path = `meshes[${index}]`;
    const primitives = file.list(file.element('meshes', index, user), 'primitives', path);
    const placed = new Map<number, Placed>(); // what primitives of a mesh share is added once
    for (const [i, primitive] of primitives.entries()) {
      const name = `${path}.primitives[${i}]`;
      if (!isObject(primitive)) return file.fail(`${name} is no object`);
      await this.#addPrimitive(primitive, name, world, placed);
    }
  }

  async #addPrimitive(
    json: Json,
    path: string,
    world: Matrix,
    placed: Map<number, Placed>,
  ): Promise<void> {
    const file = this.#file;
    const mode = file.whole(json, 'mode', path, 4);
    if (mode > 6) file.fail(`${path}.mode is ${mode}, which does not exist`);
    const { attributes } = json;
    if (mode < 4 || !isObject(attributes) || !Object.hasOwn(attributes, 'POSITION')) {
      ++this.#leftOut;
      return;
    }
    const accessor = file.whole(attributes, 'POSITION', `${path}.attributes`);
    const { first, count } =
      placed.get(accessor) ?? (await this.#place(accessor, path, world, placed));
    const corners = await this.#cornersOf(json, path, count);
    if (mode === 4 && corners.length % 3 !== 0) {
      file.fail(`${path} has ${corners.length} corners, which is no multiple of 3`);
    }
    const mirrored = determinant(world) < 0;
    for (const [a, b, c] of cut(corners, mode)) {
      this.#indices.push(first + a, first + (mirrored ? c : b), first + (mirrored ? b : c));
    }
  }

  async #cornersOf(json: Json, path: string, count: number): Promise<ArrayLike<number>> {
    const file = this.#file;
    if (!Object.hasOwn(json, 'indices')) return Uint32Array.from({ length: count }, (_, i) => i);
    const corners = await readNumbers(file, file.whole(json, 'indices', path), path);
    for (let i = 0; i < corners.length; ++i) {
      if ((corners[i] ?? 0) < count) continue;
      file.fail(`${path}: index ${corners[i]} is out of range, there are ${count} vertices`);
    }
    return corners;
  }

  async #place(
    accessor: number,
    path: string,
    world: Matrix,
    placed: Map<number, Placed>,
  ): Promise<Placed> {
    const points = await readPoints(this.#file, accessor, path);
    const added = { first: this.#positions.length / 3, count: points.length / 3 };
    if (added.first + added.count > 0x7fffffff) this.#file.fail('it has 2^31 vertices or more');
    const at = (row: number, x: number, y: number, z: number): number =>
      (world[row] ?? 0) * x +
      (world[row + 4] ?? 0) * y +
      (world[row + 8] ?? 0) * z +
      (world[row + 12] ?? 0);
    for (let i = 0; i < points.length; i += 3) {
      const [x, y, z] = [points[i] ?? 0, points[i + 1] ?? 0, points[i + 2] ?? 0];
      const [a, b, c] = [at(0, x, y, z), at(1, x, y, z), at(2, x, y, z)];
      if (!(Math.max(Math.abs(a), Math.abs(b), Math.abs(c)) <= furthest)) {
        this.#file.fail(`${path}: vertex ${i / 3} lies at no finite place`);
      }
      this.#positions.push(a, b, c);
    }
    placed.set(accessor, added);
    return added;
  }

  #finish(): GlbScene {
    const file = this.#file;
    const warnings: Warning[] = [];
    const warn = (message: string): void => void warnings.push({ code: 'NOT_READ', message });
    if (this.#leftOut > 0) {
      warn(`${this.#leftOut} primitives without triangles (points or lines) are left out`);
    }
    if (this.#skins) warn('skins are left out: meshes are as they were modelled');
    for (const used of file.list(file.json, 'extensionsUsed', 'the JSON')) {
      if (used === 'EXT_mesh_gpu_instancing') {
        warn('EXT_mesh_gpu_instancing is left out: meshes are there once a node');
      }
    }
    return {
      mesh: { positions: this.#positions.finish(), indices: this.#indices.finish() },
      warnings,
    };
  }
}

/**
 * Reads the default scene of a GLB file: triangles, strips and fans; what is mirrored is turned back. Without a scene
 * all nodes are read, without nodes all meshes. `name` is what messages call the file.
 */
export const readGlb = (bytes: Uint8Array, name: string): Promise<GlbScene> =>
  new Collector(openGlb(bytes, name)).collect();
