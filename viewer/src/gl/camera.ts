// From the state's view to the matrices of the shaders.

import { Matrix4, Vector3 } from 'three';
import type { View } from '../scene/frames';
import type { State } from '../state';
import type { Vec3 } from '../light/samples';

const degrees = Math.PI / 180;

/** Half the picture's width and height, the square's being 1. */
export function extent(width: number, height: number): [number, number] {
  return width >= height ? [width / height, 1] : [1, height / width];
}

/** A vector turned about the vertical, from +z towards +x. */
export function aboutVertical([x, y, z]: Vec3, angle_deg: number): Vec3 {
  const [sin, cos] = [Math.sin(angle_deg * degrees), Math.cos(angle_deg * degrees)];
  return [x * cos + z * sin, y, z * cos - x * sin];
}

/** World to clip coordinates, before any shift within a pixel. */
export function toClip(view: View, state: State, [ex, ey]: [number, number]): Matrix4 {
  const turn = new Matrix4()
    .makeRotationY((state.view.azimuth_deg - state.spin_deg) * degrees)
    .multiply(new Matrix4().makeRotationX(-state.view.elevation_deg * degrees));
  const target = new Vector3(...view.target);
  const away = new Vector3(...view.position).sub(target).applyMatrix4(turn);
  const up = new Vector3(0, 1, 0).applyMatrix4(turn);
  const place = target.clone().add(away);
  const pose = new Matrix4().lookAt(place, target, up).setPosition(place);
  const half = view.half / state.view.zoom;
  const lens = new Matrix4();
  if (view.parallel) {
    lens.makeOrthographic(-half * ex, half * ex, half * ey, -half * ey, view.near, view.far);
  } else {
    const side = half * view.near;
    lens.makePerspective(-side * ex, side * ex, side * ey, -side * ey, view.near, view.far);
  }
  return lens.multiply(pose.invert());
}

/** Shifts the picture so that a place of it, in clip coordinates, comes to lie in the middle, and enlarges it about there. */
export function centredOn(clip: Matrix4, [x, y]: [number, number], enlarge: number): Matrix4 {
  return new Matrix4().makeScale(enlarge, enlarge, 1).multiply(new Matrix4().makeTranslation(-x, -y, 0)).multiply(clip);
}
