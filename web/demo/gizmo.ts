// SPDX-License-Identifier: MIT
// A second model beside the input, with handles to move, turn and scale it.
import {
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  Vector3,
  type Camera,
  type BufferGeometry,
  type Plane,
} from 'three';
import type { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { TransformControls } from 'three/addons/controls/TransformControls.js';
import type { MeshInput } from 'kdmanifold';
import { toBufferGeometry } from 'kdmanifold/three';
import type { View } from './view';

/** What the handles do. */
export type GizmoMode = 'translate' | 'rotate' | 'scale';

const colour = '#62b6a5';

export class Gizmo {
  readonly #view: View;
  readonly #controls: TransformControls;
  // The model's centre lies at the object's origin, so that it turns about it.
  readonly #object: Mesh<BufferGeometry, MeshStandardMaterial>;
  #centre = new Vector3();

  /** `onMove` is called whenever the model has moved: `dragging` as long as it is not let go. */
  constructor(
    view: View,
    camera: Camera,
    orbit: OrbitControls,
    cut: Plane,
    onMove: (dragging: boolean) => void,
  ) {
    this.#view = view;
    this.#object = new Mesh(
      undefined,
      new MeshStandardMaterial({
        color: colour,
        flatShading: true,
        roughness: 0.7,
        transparent: true,
        opacity: 0.8,
        clippingPlanes: [cut],
      }),
    );
    this.#controls = new TransformControls(camera, view.element);
    this.#controls.addEventListener('change', () => view.common.draw());
    this.#controls.addEventListener('dragging-changed', ({ value }) => {
      orbit.enabled = value !== true;
    });
    this.#controls.addEventListener('objectChange', () => onMove(true));
    this.#controls.addEventListener('mouseUp', () => onMove(false));
  }

  /** Shows a model, as large and where it is, or none. */
  show(mesh: MeshInput | null): void {
    this.#object.geometry.dispose();
    this.#controls.detach();
    this.#object.removeFromParent();
    this.#controls.getHelper().removeFromParent();
    this.#view.element.classList.toggle('held', mesh !== null);
    if (mesh !== null) {
      const geometry = toBufferGeometry({ ...mesh, positions: Float32Array.from(mesh.positions) });
      geometry.computeBoundingBox();
      geometry.boundingBox?.getCenter(this.#centre);
      geometry.translate(-this.#centre.x, -this.#centre.y, -this.#centre.z);
      this.#object.geometry = geometry;
      this.#object.position.copy(this.#centre);
      this.#object.rotation.set(0, 0, 0);
      this.#object.scale.set(1, 1, 1);
      this.#view.root.add(this.#object);
      this.#view.scene.add(this.#controls.getHelper());
      this.#controls.attach(this.#object);
    }
    this.#view.common.draw();
  }

  /** Makes it as large as `radius`, with its centre at `place`. */
  fit(radius: number, place: Vector3): void {
    const { geometry } = this.#object;
    geometry.computeBoundingSphere();
    this.#object.scale.setScalar(radius / (geometry.boundingSphere?.radius ?? radius));
    this.#object.position.copy(place);
    this.#view.common.draw();
  }

  /** Chooses what the handles do. */
  setMode(mode: GizmoMode): void {
    this.#controls.setMode(mode);
    this.#view.common.draw();
  }

  /** Where its centre is, how it is turned (degrees) or scaled. */
  read(mode: GizmoMode): [number, number, number] {
    const { position, rotation, scale } = this.#object;
    if (mode === 'translate') return position.toArray();
    if (mode === 'scale') return scale.toArray();
    return [rotation.x, rotation.y, rotation.z].map((angle) => (angle * 180) / Math.PI) as Triple;
  }

  /** Sets the same. */
  write(mode: GizmoMode, [x, y, z]: Triple): void {
    const { position, rotation, scale } = this.#object;
    const radians = Math.PI / 180;
    if (mode === 'translate') position.set(x, y, z);
    else if (mode === 'scale') scale.set(x, y, z);
    else rotation.set(x * radians, y * radians, z * radians);
    this.#view.common.draw();
  }

  /** The transform of the model's own coordinates, column by column. */
  get transform(): number[] {
    this.#object.updateMatrix();
    const { x, y, z } = this.#centre;
    return this.#object.matrix.clone().multiply(new Matrix4().makeTranslation(-x, -y, -z)).elements;
  }
}

type Triple = [number, number, number];
