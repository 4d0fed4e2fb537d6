// SPDX-License-Identifier: MIT
// A GLB file: a JSON text that describes a scene, and the bytes of its arrays. Taken apart as
// src/cli/glb/container.cpp does, word for word; what is right goes to a library (cli-glb-arrays.ts).
import { KdManifoldError } from '../errors.js';

/** An object of the JSON, before anything about it is known. */
export type Json = Record<string, unknown>;

/** The two parts of a file. */
export class GlbFile {
  /** What messages call the file. */
  readonly name: string;
  json: Json = {};
  /** Empty if there is none. */
  binary: Uint8Array = new Uint8Array();

  constructor(name: string) {
    this.name = name;
  }

  fail(message: string): never {
    throw new KdManifoldError('PARSE_ERROR', `${this.name}: ${message}`);
  }

  /** Returns a member of `json` that must be a list or missing; `path` is what messages call `json`. */
  list(json: Json, key: string, path: string): unknown[] {
    const found = Object.hasOwn(json, key) ? json[key] : [];
    return Array.isArray(found) ? found : this.fail(`${path}: ${key} is no list`);
  }

  /** Returns element `index` of a list at the top, which must be an object. `user` refers to it. */
  element(key: string, index: number, user: string): Json {
    const all = this.list(this.json, key, 'the JSON');
    if (index >= all.length) {
      this.fail(`${user} refers to ${key}[${index}], but there are ${all.length}`);
    }
    const found = all[index];
    return isObject(found) ? found : this.fail(`${key}[${index}] is no object`);
  }

  /** Returns a number that must be whole; `path` is what messages call it. */
  number(value: unknown, path: string): number {
    if (typeof value === 'number' && Number.isSafeInteger(value) && value >= 0) return value;
    return this.fail(`${path} is no whole number from 0 on`);
  }

  /** Returns a member that must be a whole number; `missing` if there is none. */
  whole(json: Json, key: string, path: string, missing?: number): number {
    if (missing !== undefined && !Object.hasOwn(json, key)) return missing;
    return this.number(json[key], `${path}.${key}`);
  }
}

export const isObject = (value: unknown): value is Json =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

const headerBytes = 12; // magic, version, length
const chunkHeaderBytes = 8; // length, type
const jsonChunk = 0x4e4f534a;
const binaryChunk = 0x004e4942;

// Returns the bytes of the chunk at `at`, which must be of the type.
function chunk(
  file: GlbFile,
  bytes: Uint8Array,
  at: number,
  type: number,
  what: string,
): Uint8Array {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length - at < chunkHeaderBytes || view.getUint32(at + 4, true) !== type) {
    file.fail(`byte ${at}: ${what} should follow`);
  }
  const length = view.getUint32(at, true);
  const begin = at + chunkHeaderBytes;
  if (length > bytes.length - begin) {
    file.fail(
      `byte ${at}: ${what} of ${length} bytes should follow, but the file ends at byte ${bytes.length}`,
    );
  }
  return bytes.subarray(begin, begin + length);
}

function parseJson(file: GlbFile, text: Uint8Array): Json {
  try {
    const json: unknown = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(text));
    if (isObject(json)) return json;
  } catch {
    // As below.
  }
  return file.fail('byte 20: the JSON is malformed');
}

// What says how things look, where light is, or how they move changes no mesh at rest.
const changesNoMesh =
  /^(KHR_materials_|KHR_texture_|EXT_texture_|MSFT_texture_|KHR_lights_|EXT_lights_|KHR_animation_|KHR_xmp|KHR_mesh_quantization)/;

function checkExtensions(file: GlbFile): void {
  for (const name of file.list(file.json, 'extensionsRequired', 'the JSON')) {
    if (typeof name !== 'string') return file.fail('extensionsRequired holds what is no text');
    if (name === 'KHR_draco_mesh_compression') {
      file.fail(
        'it is compressed by KHR_draco_mesh_compression; save it without compression, as ' +
          "'npx @gltf-transform/cli copy IN.glb OUT.glb' does",
      );
    }
    if (name === 'EXT_meshopt_compression' || name === 'KHR_meshopt_compression') {
      file.fail(`it is compressed by ${name}; save it without compression`);
    }
    if (!changesNoMesh.test(name)) {
      file.fail(`it needs the extension ${name}, which is not supported`);
    }
  }
}

/** Takes the file apart. Throws if it is none, or if it needs what is not supported here. */
export function openGlb(bytes: Uint8Array, name: string): GlbFile {
  const file = new GlbFile(name);
  const begin = String.fromCharCode(...bytes.subarray(0, 4));
  if (begin.startsWith('{')) file.fail('it is a .gltf file; .glb files are supported');
  if (begin !== 'glTF') file.fail("byte 0: a GLB file begins with 'glTF'");
  if (bytes.length < headerBytes) file.fail(`the file ends at byte ${bytes.length}`);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const version = view.getUint32(4, true);
  if (version !== 2) file.fail(`byte 4: it is of version ${version}; 2 is supported`);
  const length = view.getUint32(8, true);
  if (length > bytes.length) {
    file.fail(`byte 8: the file should have ${length} bytes, but has ${bytes.length}`);
  }
  const used = bytes.subarray(0, Math.max(length, headerBytes));
  const text = chunk(file, used, headerBytes, jsonChunk, 'a chunk of JSON');
  file.json = parseJson(file, text);
  const next = headerBytes + chunkHeaderBytes + text.length;
  if (next < used.length) {
    file.binary = chunk(file, used, next, binaryChunk, 'a chunk of binary data');
  }
  checkExtensions(file);
  return file;
}
