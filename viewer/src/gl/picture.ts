// The picture: one sample after another of the lights and of the pixels, until it stands as the program would render it.

import { FloatType, HalfFloatType, Matrix4, NearestFilter, RGBAFormat, Vector2, Vector3, Vector4, WebGLRenderTarget, type RawShaderMaterial, type WebGLRenderer } from 'three';
import { directionTo, normalise, pixelOffset, sampleIrradiance, sequencePoint, sunflower, type Vec3 } from '../light/samples';
import { BALL, PATCH } from '../scene/convex';
import { MAP, SCREEN } from '../scene/flat';
import { BALL_VIEW, patchAxes, patchView, SNAKE_VIEW, type View } from '../scene/frames';
import type { SkyTextures } from '../scene/environment';
import type { Body } from '../scene/body';
import type { State } from '../state';
import { aboutVertical, centredOn, extent, toClip } from './camera';
import { evaluation, filteredEvaluation, type Interpolation, type Source } from './library';
import { SRGB, type Primaries } from './display';
import { displayPass, material, meanPass, Pass, primaryUniforms } from './passes';
import { FILL_VERTEX, LIGHTS_MAX, SHADE } from './shade';
import type { Uniforms } from './upload';

const degrees = Math.PI / 180;

const FLAT = { ball: BALL, patch: PATCH, screen: SCREEN, map: MAP } as const;

/** What is evaluated: where the numbers come from, and their uniforms. */
export interface Evaluated {
  source: Source;
  interpolation: Interpolation;
  /** Whether a look-up stands for a piece of a light and of a pixel. */
  filtered: boolean;
  /** Whether tables are still made ready: one sample, of the middle of lights and pixels, is all that is drawn until then. */
  provisional: boolean;
  uniforms: Uniforms;
}

/** The text that evaluates, and what else it says of itself. */
export const evaluationOf = ({ source, interpolation, filtered }: Evaluated): string =>
  filtered ? `#define FILTERED\n${filteredEvaluation(source)}` : evaluation(source, interpolation);

/** What tells programs of one kind apart. */
export const keyOf = ({ source, interpolation, filtered }: Evaluated): string => `${source} ${filtered ? 'filtered' : interpolation === 'cubic' ? 'cubic' : 'linear'}`;

/** Largest angular diameter in degrees of a light that one filtered look-up stands for within 1e-2 of the luminance: as in the program. */
const ONE_LOOK_UP_DEG = 2;
/** Where in a pixel look-ups stand each for a quarter of it: more than one is for edges alone. */
const QUARTERS: [number, number][] = [[-0.25, -0.25], [0.25, 0.25], [0.25, -0.25], [-0.25, 0.25]];

export const floatTarget = (width: number, height: number, type: typeof FloatType | typeof HalfFloatType, depth = false): WebGLRenderTarget => {
  const target = new WebGLRenderTarget(width, height, { format: RGBAFormat, type, depthBuffer: depth });
  target.texture.minFilter = target.texture.magFilter = NearestFilter;
  return target;
};

export const byteTarget = (width: number, height: number): WebGLRenderTarget => {
  const target = new WebGLRenderTarget(width, height, { depthBuffer: false });
  target.texture.minFilter = target.texture.magFilter = NearestFilter;
  return target;
};

/** The camera of a shape before anyone turns it; null for pictures without one. */
export function viewOf(state: State, body: Body | null): View | null {
  switch (state.shape) {
    case 'ball':
      return BALL_VIEW;
    case 'patch':
      return patchView(state.patch);
    case 'snake':
      return SNAKE_VIEW;
    case 'model':
      return body?.view ?? BALL_VIEW;
    case 'screen':
    case 'map':
      return null;
  }
}

export class Picture {
  private readonly programs = new Map<string, Pass>();
  private readonly own: Uniforms = {
    u_output: { value: 0 },
    u_active: { value: 0 },
    u_lights: { value: 1 },
    u_sky: { value: 0 },
    u_sky_map: { value: null },
    u_sky_rows: { value: null },
    u_spin: { value: new Vector2(1, 0) },
    u_index: { value: 0 },
    u_light: { value: Array.from({ length: LIGHTS_MAX }, () => new Vector4()) },
    u_light_radius: { value: new Array(LIGHTS_MAX).fill(0) },
    u_pixel_share: { value: 0 },
    u_turn: { value: new Vector2(1, 0) },
    u_from_clip: { value: new Matrix4() },
    u_to_clip: { value: new Matrix4() },
    u_extent: { value: new Vector2(1, 1) },
    u_offset: { value: new Vector2() },
    u_size: { value: new Vector2(1, 1) },
    u_wi: { value: new Vector3(0, 0, 1) },
    u_tangent: { value: new Vector3() },
    u_bitangent: { value: new Vector3() },
    u_normal: { value: new Vector3() },
    u_half_width: { value: 1 },
    u_sample_normal: { value: new Vector3() },
    u_distance: { value: 1 },
    u_hole_radius: { value: 1 },
    u_beam_point: { value: new Vector3() },
    u_beam_wi: { value: new Vector3() },
    u_beam_power: { value: 1 },
  };
  private readonly mean = meanPass();
  private readonly display = displayPass();
  private sums: [WebGLRenderTarget, WebGLRenderTarget];
  private sample: WebGLRenderTarget;
  private readonly pixel: WebGLRenderTarget;
  private taken = 0;
  /** Light from all around, besides the lights. */
  sky: SkyTextures | null = null;
  /** Of the canvas. */
  primaries: Primaries = SRGB;
  width = 1;
  height = 1;

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly type: typeof FloatType | typeof HalfFloatType,
  ) {
    this.sums = [floatTarget(1, 1, type), floatTarget(1, 1, type)];
    this.sample = floatTarget(1, 1, type, true);
    this.pixel = floatTarget(1, 1, type, true);
  }

  /** Samples taken since the last change. */
  get samples(): number {
    return this.taken;
  }

  resize(width: number, height: number): void {
    if (width === this.width && height === this.height) return;
    [this.width, this.height] = [width, height];
    for (const target of [...this.sums, this.sample]) target.setSize(width, height);
    this.restart();
  }

  restart(): void {
    this.taken = 0;
  }

  /** How many samples make the picture whole. */
  static samplesOf(state: State, { filtered, provisional }: Evaluated): number {
    if (provisional) return 1;
    const sized = state.shape === 'screen' || state.lights.some((light) => light.diameter_deg > (filtered ? ONE_LOOK_UP_DEG : 0));
    const sky = state.environment !== 'none' && lightsSurface(state);
    return Math.max(sized ? state.light_samples : 1, positionsOf(state, filtered), sky ? state.environment_samples : 1);
  }

  /** Takes one sample more. */
  step(state: State, evaluated: Evaluated, body: Body | null): void {
    const { filtered, provisional } = evaluated;
    const [x, y] = provisional ? [0, 0] : positionOf(state, filtered, this.taken);
    const offset: [number, number] = [(2 * x) / this.width, (2 * y) / this.height];
    this.prepare(state, evaluated, body, provisional ? -1 : this.taken, offset, 1);
    this.own.u_output.value = 0;
    this.draw(state, evaluated, body, this.sample);
    const [before, after] = this.sums;
    this.mean.material.uniforms.u_before.value = before.texture;
    this.mean.material.uniforms.u_sample.value = this.sample.texture;
    this.mean.material.uniforms.u_share.value = 1 / (this.taken + 1);
    this.mean.draw(this.renderer, after);
    this.sums = [after, before];
    this.taken += 1;
  }

  /** Shows what was summed, on the canvas or in a target. */
  show(exposure: number, tone: State['tone'], target: WebGLRenderTarget | null, other: Picture | null = null): void {
    const uniforms = this.display.material.uniforms;
    uniforms.u_xyz.value = this.sums[0].texture;
    uniforms.u_other.value = other?.sums[0].texture ?? this.sums[0].texture;
    uniforms.u_exposure.value = exposure;
    uniforms.u_backdrop.value = target ? 0 : 1;
    // Targets are read back as sRGB; the canvas may be wider.
    Object.assign(uniforms, primaryUniforms(target ? SRGB : this.primaries));
    uniforms.u_mode.value = other ? 2 : tone === 'clip' ? 1 : 0;
    this.display.draw(this.renderer, target);
  }

  /** The sum itself: XYZ, top row first. */
  values(): Float32Array {
    const { width, height } = this;
    const out = new Float32Array(4 * width * height);
    if (this.type === FloatType) {
      this.renderer.readRenderTargetPixels(this.sums[0], 0, 0, width, height, out);
    } else throw new Error('this browser cannot read pictures of floating-point numbers');
    return flipped(out, width, height);
  }

  /** The two directions of the active light at a place in picture coordinates; null beside the surface and in the shade. */
  directionsAt(state: State, evaluated: Evaluated, body: Body | null, at: { x: number; y: number }): { wi: Vec3; wo: Vec3 } | null {
    const [ex, ey] = extent(this.width, this.height);
    this.prepare(state, { ...evaluated, filtered: false }, body, -1, [at.x / ex, at.y / ey], this.width);
    this.own.u_output.value = 1;
    this.draw(state, evaluated, body, this.pixel);
    const out = new Float32Array(4);
    this.renderer.readRenderTargetPixels(this.pixel, 0, 0, 1, 1, out);
    const [a, b, c, d] = out;
    if (a > 2) return null;
    const up = (x: number, y: number): Vec3 => [x, y, Math.sqrt(Math.max(0, 1 - x * x - y * y))];
    return { wi: up(a, b), wo: up(c, d) };
  }

  private draw(state: State, evaluated: Evaluated, body: Body | null, target: WebGLRenderTarget): void {
    body?.drawShadows(this.renderer, this.own);
    this.own.u_size.value.set(target.width, target.height);
    this.program(state, evaluated, body).draw(this.renderer, target);
  }

  /** Sets every uniform for a sample; index -1 is the middle of the lights. */
  private prepare(state: State, evaluated: Evaluated, body: Body | null, index: number, offset: [number, number], enlarge: number): void {
    const { own } = this;
    const { filtered } = evaluated;
    const count = Picture.samplesOf(state, evaluated);
    const size = extent(this.width, this.height);
    const lights: Vector4[] = own.u_light.value;
    own.u_active.value = state.shape === 'map' || state.shape === 'screen' ? 0 : state.active;
    own.u_lights.value = Math.min(state.lights.length, LIGHTS_MAX);
    state.lights.slice(0, LIGHTS_MAX).forEach((light, i) => {
      const { direction, irradiance, radius } = lightSample(light, index, count, filtered);
      lights[i].set(...aboutVertical(direction, -state.spin_deg), irradiance);
      own.u_light_radius.value[i] = radius;
    });
    own.u_pixel_share.value = filtered ? 1 / positionsOf(state, filtered) : 0;
    this.prepareSky(state, index);
    own.u_turn.value.set(Math.cos(state.turn_deg * degrees), Math.sin(state.turn_deg * degrees));
    const view = viewOf(state, body);
    if (view) {
      const clip = centredOn(toClip(view, state, size), offset, enlarge);
      own.u_to_clip.value = clip;
      own.u_from_clip.value = clip.clone().invert();
    }
    own.u_extent.value.set(size[0] / enlarge, size[1] / enlarge);
    own.u_offset.value.set(offset[0] * size[0], offset[1] * size[1]);
    if (state.shape === 'patch') this.preparePatch(state);
    if (state.shape === 'map') own.u_wi.value.set(...lightSample(state.lights[0], index, count, filtered).direction);
    if (state.shape === 'screen') this.prepareScreen(state, index, count);
  }

  private prepareSky(state: State, index: number): void {
    const { own, sky } = this;
    own.u_sky.value = sky && lightsSurface(state) ? sky.total : 0;
    own.u_sky_map.value = sky?.map ?? null;
    own.u_sky_rows.value = sky?.rows ?? null;
    own.u_spin.value.set(Math.cos(state.spin_deg * degrees), Math.sin(state.spin_deg * degrees));
    own.u_index.value = index;
  }

  private preparePatch(state: State): void {
    const { tangent, bitangent, normal } = patchAxes(state.patch);
    this.own.u_tangent.value.set(...tangent);
    this.own.u_bitangent.value.set(...bitangent);
    this.own.u_normal.value.set(...normal);
    this.own.u_half_width.value = 0.5 * state.patch.width_mm;
  }

  private prepareScreen(state: State, index: number, count: number): void {
    const { distance_mm, width_mm, beam_mm, incidence_deg } = state.screen;
    const [sin, cos] = [Math.sin(incidence_deg * degrees), Math.cos(incidence_deg * degrees)];
    const radius = 0.5 * beam_mm;
    const light = state.lights[0];
    const [radiusSquared, angle] = index < 0 ? [0, 0] : sunflower(index, count);
    const [x, y] = [Math.sqrt(radiusSquared) * Math.cos(angle) * radius, Math.sqrt(radiusSquared) * Math.sin(angle) * radius];
    const [, , divergence, turn] = index < 0 ? [0, 0, 0, 0] : sequencePoint(index);
    const [dx, dy, dz] = directionTo([0, 0, 1], light.diameter_deg, [divergence, 2 * Math.PI * turn]);
    const own = this.own;
    own.u_sample_normal.value.set(sin, 0, cos);
    own.u_distance.value = distance_mm;
    own.u_half_width.value = 0.5 * width_mm;
    own.u_hole_radius.value = radius;
    own.u_beam_point.value.set(x, y, (-x * sin) / cos);
    const wi: Vec3 = [cos * dx - sin * dz, dy, sin * dx + cos * dz];
    own.u_beam_wi.value.set(...wi);
    own.u_beam_power.value = (light.irradiance * wi[2] * Math.PI * radius * radius) / cos;
  }

  private program(state: State, evaluated: Evaluated, body: Body | null): Pass {
    const solid = state.shape === 'snake' || state.shape === 'model';
    const surrounded = this.sky !== null && lightsSurface(state);
    const key = `${keyOf(evaluated)} ${solid ? body?.geometry.uuid : state.shape} ${surrounded}`;
    let pass = this.programs.get(key);
    if (!pass) {
      const surface = solid ? body?.fragment : FLAT[state.shape as keyof typeof FLAT];
      if (surface === undefined) throw new Error(`the shape ${state.shape} is not there yet`);
      const text = (surrounded ? '#define SURROUNDED\n' : '') + evaluationOf(evaluated) + SHADE + surface;
      const made: RawShaderMaterial = material(solid ? (body?.vertex ?? '') : FILL_VERTEX, text, { ...this.own }, solid);
      pass = new Pass(made, solid ? body?.geometry : undefined);
      this.programs.set(key, pass);
    }
    Object.assign(pass.material.uniforms, evaluated.uniforms, solid ? body?.uniforms : {}, solid && surrounded ? body?.occlusion() : {});
    return pass;
  }
}

/** Whether a camera sees the surface: maps and screens have no surroundings. */
const lightsSurface = (state: State): boolean => state.shape !== 'map' && state.shape !== 'screen';

/** How many positions in a pixel are drawn. */
const positionsOf = ({ pixel_samples }: State, filtered: boolean): number => (!filtered ? pixel_samples : pixel_samples < QUARTERS.length ? 1 : QUARTERS.length);

/** The position of a sample within its pixel. */
function positionOf(state: State, filtered: boolean, index: number): [number, number] {
  const count = positionsOf(state, filtered);
  return filtered && count > 1 ? QUARTERS[index % count] : pixelOffset(index, count);
}

/** One sample of a light: its direction and irradiance, and the angular radius in radians for which a filtered look-up there stands. */
function lightSample(light: State['lights'][number], index: number, count: number, filtered: boolean): { direction: Vec3; irradiance: number; radius: number } {
  const whole = 0.5 * degrees * light.diameter_deg;
  if (index < 0 || light.diameter_deg === 0 || (filtered && light.diameter_deg <= ONE_LOOK_UP_DEG)) {
    return { direction: normalise(light.direction), irradiance: light.irradiance, radius: whole };
  }
  const direction = directionTo(light.direction, light.diameter_deg, sunflower(index, count));
  return { direction, irradiance: light.irradiance * sampleIrradiance(light.direction, light.diameter_deg, count), radius: whole / Math.sqrt(count) };
}

/** Rows turned top to bottom. */
export function flipped<T extends Float32Array | Uint8Array>(pixels: T, width: number, height: number): T {
  const row = 4 * width;
  const out = pixels.slice() as T;
  for (let y = 0; y < height; y++) out.set(pixels.subarray(y * row, (y + 1) * row) as never, (height - 1 - y) * row);
  return out;
}
