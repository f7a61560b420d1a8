// Directions by their angles, in the local frame of a surface.

import type { Vec3 } from './light/samples';

const degrees = Math.PI / 180;

/** A unit vector at theta from the normal and phi from the x axis towards y, in degrees. */
export function fromAngles(theta_deg: number, phi_deg: number): Vec3 {
  const sin = Math.sin(theta_deg * degrees);
  return [sin * Math.cos(phi_deg * degrees), sin * Math.sin(phi_deg * degrees), Math.cos(theta_deg * degrees)];
}

/** theta and phi in degrees, phi from 0 to 360. */
export function toAngles([x, y, z]: Vec3): { theta_deg: number; phi_deg: number } {
  const phi = Math.atan2(y, x) / degrees;
  return { theta_deg: Math.atan2(Math.hypot(x, y), z) / degrees, phi_deg: phi < 0 ? phi + 360 : phi };
}
