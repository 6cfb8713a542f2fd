import {Box3, Matrix4, type PerspectiveCamera, Vector3} from "three";

/** Width of the view relative to its content: labels need space, and parts move beyond their initial places. */
const room = 1.3;
const [right, upward, backward, corner] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];

const corners = ({min, max}: Box3): Vector3[] =>
  [0, 1, 2, 3, 4, 5, 6, 7].map((i) => new Vector3(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z));

/** Returns position and target of a camera that looks along `eye` and shows a box as large as possible. */
export function aimAt(box: Box3, eye: Vector3, {up, fov, aspect}: PerspectiveCamera): {position: Vector3; target: Vector3} {
  new Matrix4().lookAt(eye, new Vector3(), up).extractBasis(right, upward, backward);
  const middle = box.getCenter(new Vector3()), tall = Math.tan((0.5 * fov * Math.PI) / 180) / room, wide = tall * aspect, own = corners(box).map((one) => one.sub(middle));
  const halfway = (axis: Vector3) => { const at = own.map((one) => one.dot(axis)); return 0.5 * (Math.min(...at) + Math.max(...at)); };
  const target = middle.clone().addScaledVector(right, halfway(right)).addScaledVector(upward, halfway(upward)), shift = target.clone().sub(middle);
  const far = Math.max(...own.map((one) => {
    corner.copy(one).sub(shift);
    return corner.dot(backward) + Math.max(Math.abs(corner.dot(right)) / wide, Math.abs(corner.dot(upward)) / tall);
  }));
  return {position: target.clone().addScaledVector(backward, far), target};
}
