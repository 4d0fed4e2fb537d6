// SPDX-License-Identifier: MIT
// Where the camera may stand: directions from the model, z up.
import { Vector3 } from 'three';

export const sides = {
  corner: new Vector3(-0.9, -1.5, 0.95),
  front: new Vector3(0, -1, 0),
  back: new Vector3(0, 1, 0),
  left: new Vector3(-1, 0, 0),
  right: new Vector3(1, 0, 0),
  // Not quite, so that the front is at the lower edge, or at the upper one.
  above: new Vector3(0, -1e-3, 1),
  below: new Vector3(0, -1e-3, -1),
};
export type Side = keyof typeof sides;
