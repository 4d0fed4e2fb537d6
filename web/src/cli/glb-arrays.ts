// SPDX-License-Identifier: MIT
// The arrays of a GLB file: checked as src/cli/glb/accessor.cpp checks them, word for word, and then read by
// glTF Transform, which is loaded only here.
import { isObject, type GlbFile, type Json } from './glb-file.js';
import { KdManifoldError } from '../errors.js';

const [byte, unsignedByte, short, unsignedShort, unsignedInt, float] = [
  5120, 5121, 5122, 5123, 5125, 5126,
];
// No more elements are made of nothing: an accessor without bytes holds zeros.
const mostElements = 2 ** 28;

const sizeOf = (type: number): number =>
  type === byte || type === unsignedByte ? 1 : type === short || type === unsignedShort ? 2 : 4;

// What elements are: the type of a component, their number, whether other things may lie between elements.
interface Kind {
  type: number;
  components: number;
  maybeSpaced: boolean;
}

// What is handed to the library: complete, right, and nothing else.
type Definition = { [key: string]: unknown };

function checkBuffer(file: GlbFile, index: number, user: string): void {
  const buffer = file.element('buffers', index, user);
  if (index === 0 && !Object.hasOwn(buffer, 'uri')) return;
  let where = typeof buffer.uri === 'string' ? buffer.uri : '';
  if (where.startsWith('data:')) where = 'text';
  file.fail(
    `buffers[${index}] is not in the file${where && ` but in ${where}`}; only what is in it is read`,
  );
}

// Checks the elements that `json` (an accessor, or a part of a sparse one) refers to; adds their view to `views`.
function locate(
  file: GlbFile,
  json: Json,
  path: string,
  count: number,
  kind: Kind,
  views: Definition[],
): Definition {
  const index = file.whole(json, 'bufferView', path);
  const view = file.element('bufferViews', index, path);
  const viewPath = `bufferViews[${index}]`;
  checkBuffer(file, file.whole(view, 'buffer', viewPath), viewPath);
  const start = file.whole(view, 'byteOffset', viewPath, 0);
  const length = file.whole(view, 'byteLength', viewPath);
  if (start > file.binary.length || length > file.binary.length - start) {
    file.fail(`${viewPath} goes beyond the ${file.binary.length} bytes of binary data`);
  }
  const component = sizeOf(kind.type);
  const size = component * kind.components;
  const stride = (kind.maybeSpaced ? file.whole(view, 'byteStride', viewPath, 0) : 0) || size;
  const offset = file.whole(json, 'byteOffset', path, 0);
  if (((start % component) + (offset % component)) % component || stride % component) {
    file.fail(`${path} is not aligned to the size of its numbers`);
  }
  if (stride < size) file.fail(`${viewPath}.byteStride is less than an element`);
  if (
    count > 0 &&
    (offset > length ||
      length - offset < size ||
      count - 1 > Math.floor((length - offset - size) / stride))
  ) {
    file.fail(`${path} goes beyond ${viewPath}`);
  }
  views.push({ buffer: 0, byteOffset: start, byteLength: length, byteStride: stride });
  return { bufferView: views.length - 1, byteOffset: offset };
}

// Checks an accessor; the second one of the result holds the places of a sparse one.
function check(
  file: GlbFile,
  index: number,
  user: string,
  shape: string,
  types: number[],
  views: Definition[],
): Definition[] {
  const json = file.element('accessors', index, user);
  const path = `accessors[${index}]`;
  if (json.type !== shape) file.fail(`${path}.type is not ${shape}`);
  const type = file.whole(json, 'componentType', path);
  if (!types.includes(type)) file.fail(`${path}.componentType is ${type}, which cannot be here`);
  const count = file.whole(json, 'count', path);
  if (count > mostElements) file.fail(`${path}.count is too large`);
  const points = shape === 'VEC3';
  const kind = { type, components: points ? 3 : 1, maybeSpaced: points };
  const accessor: Definition = { componentType: type, type: shape, count, byteOffset: 0 };
  if (json.normalized === true) accessor.normalized = true;
  if (Object.hasOwn(json, 'bufferView')) {
    const place = locate(file, json, path, count, kind, views);
    if (count > 0) Object.assign(accessor, place);
  }
  if (!Object.hasOwn(json, 'sparse')) return [accessor];
  const places = checkSparse(file, json.sparse, `${path}.sparse`, count, kind, accessor, views);
  return [accessor, places];
}

function checkSparse(
  file: GlbFile,
  sparse: unknown,
  path: string,
  most: number,
  kind: Kind,
  accessor: Definition,
  views: Definition[],
): Definition {
  if (!isObject(sparse)) return file.fail(`${path} is no object`);
  const count = file.whole(sparse, 'count', path);
  if (count > most) file.fail(`${path}.count is larger than that of the accessor`);
  const part = (key: string): Json => {
    const found = sparse[key];
    return isObject(found) ? found : file.fail(`${path}.${key} is no object`);
  };
  const indices = part('indices');
  const componentType = file.whole(indices, 'componentType', `${path}.indices`);
  if (![unsignedByte, unsignedShort, unsignedInt].includes(componentType)) {
    file.fail(`${path}.indices.componentType is ${componentType}, which cannot be here`);
  }
  const places = locate(
    file,
    indices,
    `${path}.indices`,
    count,
    { type: componentType, components: 1, maybeSpaced: false },
    views,
  );
  const values = locate(
    file,
    part('values'),
    `${path}.values`,
    count,
    { ...kind, maybeSpaced: false },
    views,
  );
  if (count > 0) {
    accessor.sparse = { count, indices: { ...places, componentType }, values };
  }
  return { ...(count > 0 && places), componentType, type: 'SCALAR', count };
}

async function loadLibrary(name: string): Promise<typeof import('@gltf-transform/core')> {
  try {
    return await import('@gltf-transform/core');
  } catch {
    throw new KdManifoldError(
      'IO_ERROR',
      `${name}: GLB files are read by the package @gltf-transform/core, which is not installed`,
    );
  }
}

// What is used of the library's type, whose declarations do not resolve everywhere.
interface LibraryAccessor {
  getArray(): ArrayLike<number> | null;
  getNormalized(): boolean;
  getComponentType(): number;
  getCount(): number;
  getElement(index: number, target: number[]): number[];
}

// Has the library read the accessors, each as an array.
async function read(
  file: GlbFile,
  accessors: Definition[],
  bufferViews: Definition[],
): Promise<ArrayLike<number>[]> {
  const { WebIO, Logger } = await loadLibrary(file.name);
  const io = new WebIO().setLogger(new Logger(Logger.Verbosity.SILENT));
  const json = {
    asset: { version: '2.0' },
    buffers: [{ uri: 'binary', byteLength: file.binary.length }],
    bufferViews,
    accessors,
  };
  const resources = { binary: file.binary as Uint8Array<ArrayBuffer> };
  const document = await io.readJSON({ json: json as never, resources });
  const found = document.getRoot().listAccessors() as unknown as LibraryAccessor[];
  return found.map((accessor) => {
    const array = accessor.getArray() ?? [];
    if (!accessor.getNormalized() || accessor.getComponentType() === float) return array;
    const scaled = new Float64Array(array.length);
    for (let i = 0; i < accessor.getCount(); ++i) {
      scaled.set(accessor.getElement(i, [0, 0, 0]), 3 * i);
    }
    return scaled;
  });
}

async function readArray(
  file: GlbFile,
  index: number,
  user: string,
  shape: string,
  types: number[],
): Promise<ArrayLike<number>> {
  const views: Definition[] = [];
  const accessors = check(file, index, user, shape, types, views);
  const [array, places = []] = await read(file, accessors, views);
  const count = accessors[0]?.count as number;
  for (let i = 0; i < places.length; ++i) {
    if ((places[i] ?? 0) < count) continue;
    file.fail(
      `accessors[${index}].sparse.indices has ${places[i]}, but there are ${count} elements`,
    );
  }
  return array ?? [];
}

/** Reads points of floats or (normalised) integers, three numbers each. `user` refers to them. */
export const readPoints = (
  file: GlbFile,
  index: number,
  user: string,
): Promise<ArrayLike<number>> =>
  readArray(file, index, user, 'VEC3', [byte, unsignedByte, short, unsignedShort, float]);

/** Reads vertex numbers. */
export const readNumbers = (
  file: GlbFile,
  index: number,
  user: string,
): Promise<ArrayLike<number>> =>
  readArray(file, index, user, 'SCALAR', [unsignedByte, unsignedShort, unsignedInt]);
