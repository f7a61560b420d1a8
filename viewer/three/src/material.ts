// The material: the atlas's evaluation within three's own loop over lights and their shadows.

import { Matrix3, ShaderLib, ShaderMaterial, UniformsLib, UniformsUtils, Vector2, Vector3, type Texture } from 'three';
import type { PackedSpectral, PackedTables } from '../../src/atlas/pack';
import type { Specimen } from '../../src/atlas/specimen';
import { SRGB } from '../../src/gl/display';
import { evaluation, type Interpolation } from '../../src/gl/library';
import { quadratureOf, quadratureUniforms } from '../../src/gl/quadrature';
import { upload, type Uploaded } from '../../src/gl/upload';
import type { Illuminant, IlluminantName } from '../../src/light/illuminants';
import { directionTo, sampleIrradiance, sunflower } from '../../src/light/samples';
import { FRAGMENT, LIGHT_SAMPLES_MAX, VERTEX } from './shader';

export interface DiffractionOptions {
  /** Turns the structure on the surface. */
  turnDeg?: number;
  /** Angular diameter of the lights; 0 for points, 0.53 for the sun. */
  lightDiameterDeg?: number;
  /** Look-ups over each light's disc, 1 to 64; one takes the middle. */
  lightSamples?: number;
  /** `cubic` reads sixteen texels in place of four. */
  interpolation?: Interpolation;
  /** In place of the light that the tables were made for: a sum over 48 wavelengths and more, from spectral tables. */
  illuminant?: Exclude<IlluminantName, 'tables'>;
  /** Wavelength of the illuminant `laser`. */
  laserNm?: number;
  /** Height of the illuminant `sun`. */
  sunDeg?: number;
}

/** What a material is made from. */
export interface Evaluable {
  specimen: Specimen;
  packed: PackedTables | PackedSpectral;
  /** For spectral tables. */
  light: Illuminant | null;
}

/**
 * A diffracting surface under three's directional, point and spot lights, with their shadows. A light of intensity 1 and the radiance
 * that it reflects are as of three's other materials: a white matt surface shows 1/π. Where tables made for certain scenes have no
 * answer it is magenta.
 */
export class DiffractionMaterial extends ShaderMaterial {
  private readonly uploaded: Uploaded;

  constructor({ specimen, packed, light }: Evaluable, options: DiffractionOptions = {}) {
    const uploaded = upload(packed);
    const wavelengths = light && quadratureOf(specimen, light);
    super({
      name: `diffraction ${specimen.name}`,
      lights: true,
      uniforms: {
        ...UniformsUtils.merge([UniformsLib.lights]),
        ...uploaded.uniforms,
        ...(wavelengths ? quadratureUniforms(specimen, wavelengths, 1) : {}),
        u_rgb_from_xyz: { value: new Matrix3().copy(SRGB.rgb_from_xyz) },
        u_turn: { value: new Vector2(1, 0) },
        u_samples: { value: 1 },
        u_disc: { value: Array.from({ length: LIGHT_SAMPLES_MAX }, () => new Vector3(0, 0, 1)) },
        u_share: { value: 1 },
      },
      vertexShader: VERTEX(ShaderLib.lambert.vertexShader),
      fragmentShader: FRAGMENT(evaluation(wavelengths ? 'spectral' : 'tables', options.interpolation ?? 'bilinear')),
    });
    this.uploaded = uploaded;
    this.turnDeg = options.turnDeg ?? 0;
    this.setLightSize(options.lightDiameterDeg ?? 0, options.lightSamples ?? 1);
  }

  /** Turns the structure on the surface. */
  set turnDeg(angle: number) {
    const radians = (angle * Math.PI) / 180;
    (this.uniforms.u_turn.value as Vector2).set(Math.cos(radians), Math.sin(radians));
  }

  /** Of all lights: the angular diameter, and how many look-ups stand for the disc. */
  setLightSize(diameterDeg: number, samples: number): void {
    const count = diameterDeg > 0 ? Math.min(LIGHT_SAMPLES_MAX, Math.max(1, Math.round(samples))) : 1;
    const disc = this.uniforms.u_disc.value as Vector3[];
    for (let i = 0; i < count; i++) disc[i].set(...directionTo([0, 0, 1], diameterDeg, sunflower(i, count)));
    this.uniforms.u_samples.value = count;
    this.uniforms.u_share.value = sampleIrradiance([0, 0, 1], diameterDeg, count) / count;
  }

  /** Takes the textures off the GPU, too. */
  override dispose(): void {
    this.uploaded.dispose();
    (this.uniforms.u_quadrature?.value as Texture | undefined)?.dispose();
    super.dispose();
  }
}
