// Numbers from the same shader: the BRDF for lists of directions, spectra, and the map for one direction of the light.

import { DataTexture, FloatType, NearestFilter, RGBAFormat, Vector3, type WebGLRenderer, type WebGLRenderTarget } from 'three';
import type { Xyz } from '../light/illuminants';
import type { Vec3 } from '../light/samples';
import { displayPass, material, Pass } from './passes';
import { byteTarget, evaluationOf, flipped, floatTarget, keyOf, type Evaluated } from './picture';
import type { Ask } from './quadrature';
import { FILL_VERTEX } from './shade';
import type { Uniforms } from './upload';

export interface Pair {
  wi: Vec3;
  wo: Vec3;
}

const OUT = 'layout(location = 0) out highp vec4 out_value;\nuniform highp sampler2D u_list;\n';

/** Texel (i, 0) of the list is wi, texel (i, 1) wo. */
const PAIRS = `${OUT}
void main() {
  int i = int(gl_FragCoord.x);
  vec3 f = reflected(texelFetch(u_list, ivec2(i, 0), 0).xyz, texelFetch(u_list, ivec2(i, 1), 0).xyz);
  out_value = vec4(f, answered ? 1.0 : 0.0);
}
`;

/** Texel (i, 0) of the list is a wavelength with the material's n, k and kind. */
const SPECTRUM = `${OUT}
uniform vec3 u_wi;
uniform vec3 u_wo;
void main() {
  vec4 ask = texelFetch(u_list, ivec2(int(gl_FragCoord.x), 0), 0);
  float f = brdf_spectral_with(front_at(ask.yzw), u_wi, u_wo, ask.x / u_structure_scale);
  out_value = vec4(has_answer(f) ? f : 0.0, has_answer(f) ? 1.0 : 0.0, 0.0, 0.0);
}
`;

/** f over all viewing directions for one light. */
const MAP = `${OUT}
uniform vec3 u_wi;
uniform float u_side;
uniform float u_radius;
void main() {
  vec2 at = 2.0 * gl_FragCoord.xy / u_side - 1.0;
  float cos2 = 1.0 - dot(at, at);
  vec3 f = vec3(0.0);
#ifdef FILTERED
  float pixel = 4.0 / (12.0 * u_side * u_side);
  if (cos2 > 0.0) f = reflected_over(u_wi, vec3(at, sqrt(cos2)), footprint_of_light(u_wi, u_radius) + pixel * vec3(1.0, 0.0, 1.0));
#else
  if (cos2 > 0.0) f = reflected(u_wi, vec3(at, sqrt(cos2)));
#endif
  out_value = vec4(f, answered ? 0.0 : 1.0);
}
`;

function listTexture(rows: number[][], width: number): DataTexture {
  const data = new Float32Array(4 * width * rows.length);
  rows.forEach((row, y) => data.set(row, 4 * width * y));
  const texture = new DataTexture(data, width, rows.length, RGBAFormat, FloatType);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

export class Probe {
  private readonly programs = new Map<string, Pass>();
  private readonly targets = new Map<string, WebGLRenderTarget>();
  private readonly display = displayPass();
  private readonly own: Uniforms = {
    u_list: { value: null },
    u_wi: { value: new Vector3() },
    u_wo: { value: new Vector3() },
    u_side: { value: 1 },
    u_radius: { value: 0 },
  };

  constructor(private readonly renderer: WebGLRenderer) {}

  /** XYZ in 1/sr of each pair of directions; null where the tables have no answer. */
  brdf(evaluated: Evaluated, pairs: Pair[]): (Xyz | null)[] {
    const rows = [pairs.flatMap(({ wi }) => [...wi, 0]), pairs.flatMap(({ wo }) => [...wo, 0])];
    const out = this.list(evaluated, 'pairs', PAIRS, rows, pairs.length);
    return pairs.map((_, i) => (out[4 * i + 3] > 0.5 ? [out[4 * i], out[4 * i + 1], out[4 * i + 2]] : null));
  }

  /** The BRDF in 1/sr at each wavelength; NaN where the tables have no answer. */
  spectrum(evaluated: Evaluated, { wi, wo }: Pair, asks: Ask[]): Float64Array {
    this.own.u_wi.value.set(...wi);
    this.own.u_wo.value.set(...wo);
    const row = asks.flatMap(({ nm, index_n, index_k, material: kind }) => [nm, index_n, index_k, kind]);
    const out = this.list(evaluated, 'spectrum', SPECTRUM, [row], asks.length);
    return Float64Array.from(asks, ({ known }, i) => (known && out[4 * i + 1] > 0.5 ? out[4 * i] : NaN));
  }

  /** The map of the BRDF as 8-bit colours, top row first, with the exposure that shows it; and its brightest luminance. */
  map(evaluated: Evaluated, wi: Vec3, lightRadius: number, side: number, exposure: number | null): { pixels: Uint8Array; exposure: number } {
    this.own.u_wi.value.set(...wi);
    this.own.u_radius.value = lightRadius;
    this.own.u_side.value = side;
    const target = this.target('map', side, side);
    this.program(evaluated, 'map', MAP).draw(this.renderer, target);
    const used = exposure ?? this.exposureOf(target, side, side);
    const bytes = this.bytes(target, side, side, used);
    return { pixels: flipped(bytes, side, side), exposure: used };
  }

  private exposureOf(target: WebGLRenderTarget, width: number, height: number): number {
    const values = new Float32Array(4 * width * height);
    this.renderer.readRenderTargetPixels(target, 0, 0, width, height, values);
    return automaticExposure(values);
  }

  private bytes(source: WebGLRenderTarget, width: number, height: number, exposure: number): Uint8Array {
    const uniforms = this.display.material.uniforms;
    uniforms.u_xyz.value = source.texture;
    uniforms.u_other.value = source.texture;
    uniforms.u_exposure.value = exposure;
    const shown = this.target('bytes', width, height, true);
    this.display.draw(this.renderer, shown);
    const out = new Uint8Array(4 * width * height);
    this.renderer.readRenderTargetPixels(shown, 0, 0, width, height, out);
    return out;
  }

  private list(evaluated: Evaluated, name: string, text: string, rows: number[][], count: number): Float32Array {
    const list = listTexture(rows, count);
    this.own.u_list.value = list;
    const target = this.target(name, count, 1);
    this.program({ ...evaluated, filtered: false }, name, text).draw(this.renderer, target);
    const out = new Float32Array(4 * count);
    this.renderer.readRenderTargetPixels(target, 0, 0, count, 1, out);
    list.dispose();
    return out;
  }

  private target(name: string, width: number, height: number, bytes = false): WebGLRenderTarget {
    let target = this.targets.get(name);
    if (!target) {
      target = floatTarget(width, height, FloatType);
      if (bytes) target = byteTarget(width, height);
      this.targets.set(name, target);
    }
    if (target.width !== width || target.height !== height) target.setSize(width, height);
    return target;
  }

  private program(evaluated: Evaluated, name: string, text: string): Pass {
    const key = `${keyOf(evaluated)} ${name}`;
    let pass = this.programs.get(key);
    if (!pass) {
      pass = new Pass(material(FILL_VERTEX, evaluationOf(evaluated) + text, { ...this.own }));
      this.programs.set(key, pass);
    }
    Object.assign(pass.material.uniforms, evaluated.uniforms);
    return pass;
  }
}

/** Share of the lit pixels that the automatic exposure keeps at or below white. */
const QUANTILE = 0.995;

/** The exposure that brings the quantile of the lit pixels' luminance to white; RGBA pixels of XYZ. */
export function automaticExposure(values: Float32Array): number {
  const room = new Float32Array(values.length / 4);
  let count = 0;
  for (let i = 1; i < values.length; i += 4) if (values[i] > 0 && Number.isFinite(values[i])) room[count++] = values[i];
  if (!count) return 1;
  const lit = room.subarray(0, count).sort();
  return 1 / lit[Math.ceil(QUANTILE * count) - 1];
}
