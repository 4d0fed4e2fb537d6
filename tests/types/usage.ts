// SPDX-License-Identifier: MIT
// Compiled under `tsc --strict` against the packed package, never run: what must be legal, and, where an
// error is announced, what must not.
import {
  Grid,
  KdManifoldError,
  load,
  makeManifold,
  simplifyMesh,
  type BuildOptions,
  type Conversion,
  type ErrorCode,
  type MeshDefects,
  type MeshPart,
  type Mesh,
  type MeshInput,
  type ParsedMesh,
  type Report,
  type Simplification,
} from 'kdmanifold';
import {
  fromBufferGeometry,
  fromObject3D,
  toBufferGeometry,
  toMesh,
  type ObjectMesh,
  type Skipped,
  type SourcePart,
} from 'kdmanifold/three';
import {
  BoxGeometry,
  BufferGeometry,
  Group,
  InstancedMesh,
  Mesh as ThreeMesh,
  MeshBasicMaterial,
  type Material,
  type Object3D,
} from 'three';

const soup: MeshInput = { positions: new Float32Array(9) };
const indexed: MeshInput = { positions: new Float64Array(9), indices: new Uint16Array(3) };

const conversion: Conversion = await makeManifold(soup, {
  strategy: 'adaptive',
  tolerance: 0.05,
  inside: 'odd',
  quads: true,
  transfer: true,
  signal: new AbortController().signal,
  onProgress: (fraction, phase) => fraction < 1 || phase === 'done',
});
const report: Report = conversion.report;
const words: [boolean, number, number] = [
  report.output.twoManifold,
  report.grid.unresolvedLeaves,
  report.input.cancelledFaces,
];

const levels: Mesh[] = (await makeManifold(soup, { targetTriangles: [200, 100] })).levels;
const simplification: Simplification = await simplifyMesh(indexed, { error: 0.1 });
// @ts-expect-error: a distance is no flag
void simplifyMesh(indexed, { error: true });

const kdm = await load({ wasmUrl: 'https://example.org/kdmanifold.wasm' });
const options: BuildOptions = { strategy: 'median', depth: 12, pairing: 'trace' };
const grid: Grid = kdm.buildGrid(indexed, options);
const mesh: Mesh = grid.extract({ strict: 'embedded', linkError: 0.01 });
const triangles: Uint32Array = mesh.indices;
grid.simplify({ surfaceError: 0.01, onProgress: () => true }).removedSplits satisfies number;
const saved: Uint8Array = grid.save();
grid[Symbol.dispose]();
kdm.loadGrid(saved, 'part.kdgrid').delete();

{
  using scoped = kdm.buildGrid(soup);
  scoped.extract();
}

const bytes: Uint8Array = kdm.formatMesh(kdm.parseMesh('', 'obj'), 'stl');
const geometry: BufferGeometry = toBufferGeometry(mesh);
const box = fromBufferGeometry(new BoxGeometry());
kdm.describe(box);
toBufferGeometry(mesh, { from: box, attributes: ['uv'], seamTolerance: 0.001 });

const instanced = new InstancedMesh(new BoxGeometry(), [new MeshBasicMaterial()], 3);
const group: Object3D = new Group().add(instanced, new ThreeMesh());
const from: ObjectMesh = fromObject3D(group, { onlyVisible: false });
fromObject3D(new BufferGeometry());
const converted: Conversion = await makeManifold(from);
const shown: ThreeMesh = toMesh(converted.mesh, from, { attributes: [] });
const materials: Material[] = from.source.materials;
const part: SourcePart | undefined = from.source.parts[0];
const skipped: Skipped[] = from.skipped;
const warnings: string[] = kdm.parseMesh('', 'obj').warnings.map(({ message }) => message);
warnings.join();
const shell: ParsedMesh = kdm.thicken(soup, 0.1);
const defects: MeshDefects = kdm.analyze(soup, { selfIntersections: true });
const loop: Uint32Array | undefined = defects.boundaryLoops[0];
const piece: MeshPart | undefined = defects.parts[0];
const handles: number | null = piece?.genus ?? null;

try {
  grid.extract();
} catch (error) {
  const code: ErrorCode | undefined = error instanceof KdManifoldError ? error.code : undefined;
  if (code === 'DELETED') throw error;
}

// @ts-expect-error positions are needed
await makeManifold({ indices: new Uint32Array(3) });
await makeManifold({ positions: [0, 0, 0], indices: [0, 0, 0] }, { check: true });
// @ts-expect-error big numbers are none
await makeManifold({ positions: new BigInt64Array(3) });
// @ts-expect-error no such strategy
kdm.buildGrid(soup, { strategy: 'best' });
// @ts-expect-error no such option
grid.extract({ depth: 3 });
// @ts-expect-error no such option
toBufferGeometry(mesh, { source: box });
// @ts-expect-error a mesh without source
toMesh(mesh, soup);
// @ts-expect-error grids come from buildGrid
new Grid();

export { bytes, geometry, handles, levels, loop, shell, simplification, triangles, words };
export { materials, part, shown, skipped };
