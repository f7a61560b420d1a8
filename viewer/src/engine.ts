// What the page shows, without its controls: a specimen of the atlas, the picture, and numbers from the same shader.

import { FloatType, HalfFloatType, WebGLRenderer, type DataTexture } from 'three';
import { AtlasError, type AtlasFiles } from './atlas/files';
import { hasMeans, hasSplines, packSpectral, packTables, type Packed, type PackedSpectral, type PackedTables, type Progress } from './atlas/pack';
import { readIndex, readSpecimen, type AtlasIndex, type Specimen, type ViewerFile } from './atlas/specimen';
import { Picture, byteTarget, flipped, type Evaluated } from './gl/picture';
import { automaticExposure, Probe, type Pair } from './gl/probe';
import { asksOf, quadratureOf, quadratureUniforms, type Ask } from './gl/quadrature';
import { P3 } from './gl/display';
import { GpuClock } from './gl/clock';
import { BINDING } from './gl/library';
import { upload, uploadReady, type Readiness, type Uploaded } from './gl/upload';
import { illuminant, illuminantOf, type Illuminant, type Quadrature } from './light/illuminants';
import type { Body } from './scene/body';
import { builtIn, skyTextures, type Environment, type SkyTextures } from './scene/environment';
import { snakeBody } from './scene/snake';
import { merged, type State } from './state';

/** Why a picture cannot be drawn, in words for the reader of the page. */
export class GraphicsError extends Error {}

/** Tables, and what of them is on the GPU. */
interface OnGpu<P extends Packed> {
  packed: P;
  uploaded: Partial<Record<Readiness, Uploaded>>;
}

/** A specimen on the GPU. */
interface Loaded {
  specimen: Specimen;
  /** Those of XYZ; null where the specimen has spectral ones alone. */
  tables: OnGpu<PackedTables> | null;
  spectral: OnGpu<PackedSpectral> | null;
}

const onGpu = <P extends Packed>(packed: P): OnGpu<P> => ({ packed, uploaded: { plain: upload(packed) } });
const disposeOf = (tables: OnGpu<Packed> | null): void => Object.values(tables?.uploaded ?? {}).forEach((one) => one.dispose());

const METER_SIDE = 128;

export class Engine {
  readonly renderer: WebGLRenderer;
  private readonly gl: WebGL2RenderingContext;
  clock: GpuClock;
  readonly probe: Probe;
  /** Whether targets of 32-bit floats can be drawn and read: without them there are no numbers, only pictures. */
  readonly floats: boolean;
  index!: AtlasIndex;
  loaded: Loaded | null = null;
  model: Body | null = null;
  private ownSky: SkyTextures | null = null;
  private builtSky: { name: string; sky: SkyTextures } | null = null;
  private readonly picture: Picture;
  private other: Picture | null = null;
  private meter: Picture | null = null;
  private snake: Body | null = null;
  private metered: { key: string; exposure: number } | null = null;
  private quadratureKey = '';
  private quadratureUniforms: Record<string, { value: unknown }> = {};

  constructor(
    canvas: HTMLCanvasElement,
    readonly files: AtlasFiles,
    public state: State,
  ) {
    if (typeof DecompressionStream === 'undefined') throw new GraphicsError('This browser cannot unpack the tables; those of 2023 and later can.');
    const gl = canvas.getContext('webgl2', { antialias: false, alpha: false, powerPreference: 'high-performance' });
    if (!gl) throw new GraphicsError('This page draws with WebGL 2, which this browser does not offer or has switched off.');
    this.clock = new GpuClock(gl);
    this.renderer = new WebGLRenderer({ canvas, context: gl });
    this.renderer.autoClear = true;
    this.renderer.debug.onShaderError = (context, program) => {
      throw new GraphicsError(`The graphics driver refuses the shader: ${context.getProgramInfoLog(program) ?? 'it does not say why'}.`);
    };
    this.clearToNothing();
    this.floats = gl.getExtension('EXT_color_buffer_float') !== null;
    if (!this.floats && gl.getExtension('EXT_color_buffer_half_float') === null) {
      throw new GraphicsError('This page sums light in floating-point numbers, which this graphics driver cannot draw to.');
    }
    // An address cannot hold the files that these ask for.
    if (this.state.shape === 'model') this.state.shape = 'snake';
    if (this.state.environment === 'own') this.state.environment = 'none';
    this.picture = new Picture(this.renderer, this.floats ? FloatType : HalfFloatType);
    this.gl = gl;
    this.useColours();
    this.probe = new Probe(this.renderer);
  }

  get size(): { width: number; height: number } {
    return { width: this.picture.width, height: this.picture.height };
  }

  /** Samples taken, and how many make the picture whole. */
  get progress(): { taken: number; whole: number } {
    return { taken: this.picture.samples, whole: this.whole(this.evaluated()) };
  }

  private whole(evaluated: Evaluated | null): number {
    return evaluated ? Picture.samplesOf(this.state, evaluated) : 1;
  }

  async open(): Promise<void> {
    this.index = await readIndex(this.files);
    const shown = (await this.viewerFile())?.specimens;
    if (shown) this.index.specimens = this.index.specimens.filter(({ name }) => shown.includes(name));
    if (!this.index.specimens?.length) throw new AtlasError('The atlas holds no specimen.');
    this.files.expect(this.index.files ?? []);
  }

  private viewer: Promise<ViewerFile | null> | null = null;
  /** What the atlas holds for this page alone; null where it holds nothing. */
  viewerFile(): Promise<ViewerFile | null> {
    return (this.viewer ??= this.files.optionalJson<ViewerFile>('viewer.json').catch(() => null));
  }

  private readonly described = new Map<string, Promise<Specimen>>();
  /** What the atlas says of a specimen. */
  specimen(name: string): Promise<Specimen> {
    const found = this.described.get(name) ?? readSpecimen(this.files, name);
    this.described.set(name, found);
    return found;
  }

  /** Loads the state's specimen, or the first one, and what the state needs of it. */
  async loadSpecimen(progress: Progress): Promise<void> {
    const names = this.index.specimens.map((specimen) => specimen.name);
    const name = names.includes(this.state.specimen) ? this.state.specimen : names[0];
    if (this.loaded?.specimen.name !== name) {
      const specimen = await this.specimen(name);
      const packed = await packTables(this.files, specimen, progress);
      this.unload();
      this.loaded = { specimen, tables: packed && onGpu(packed), spectral: null };
      this.metered = null;
    }
    this.state.specimen = name;
    this.restart();
  }

  /** Loads the spectral tables once they are needed. False where the specimen has none. */
  async loadSpectral(progress: Progress): Promise<boolean> {
    const loaded = this.loaded;
    if (!loaded) return false;
    if (!loaded.spectral) {
      const packed = await packSpectral(this.files, loaded.specimen, progress);
      if (!packed) return false;
      if (this.loaded !== loaded) return false;
      loaded.spectral = onGpu(packed);
      if (this.wantsSpectral()) this.restart();
    }
    return true;
  }

  /** What the state's look-ups want of tables. */
  private readiness(packed: Packed): Readiness {
    const { interpolation, look_ups } = this.state;
    if (interpolation === 'spline' && hasSplines(packed)) return 'splines';
    return interpolation !== 'cubic' && look_ups === 'filtered' && hasMeans(packed) ? 'filtered' : 'plain';
  }

  /** Whether the tables of the picture are ready for the state's look-ups; until then they are looked up linearly, at points. */
  isReady(): boolean {
    const tables = this.ofPicture();
    return !tables || tables.uploaded[this.readiness(tables.packed)] !== undefined;
  }

  /** Makes the loaded tables ready for the state's look-ups, with pauses, and says whether anything changed. */
  async makeReady(): Promise<boolean> {
    const { loaded } = this;
    let changed = false;
    for (const tables of [this.ofPicture(), loaded?.tables ?? null, loaded?.spectral ?? null]) {
      if (!tables) continue;
      const readiness = this.readiness(tables.packed);
      if (tables.uploaded[readiness]) continue;
      const ready = await uploadReady(tables.packed, readiness);
      if (this.loaded !== loaded || tables.uploaded[readiness]) {
        ready.dispose();
        continue;
      }
      tables.uploaded[readiness] = ready;
      changed = true;
      if (tables === this.ofPicture()) this.restart();
    }
    return changed;
  }

  /** The tables that the picture is made from. */
  private ofPicture(): OnGpu<Packed> | null {
    const { loaded } = this;
    return loaded && this.light() && loaded.spectral ? loaded.spectral : (loaded?.tables ?? null);
  }

  private unload(): void {
    disposeOf(this.loaded?.tables ?? null);
    disposeOf(this.loaded?.spectral ?? null);
    this.loaded = null;
    this.quadratureKey = '';
  }

  /** Waits for the GPU. */
  finish(): void {
    this.gl.readPixels(0, 0, 1, 1, this.gl.RGBA, this.gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  /** After the GPU's memory was lost and given back: what lay in it is uploaded anew as it is used. */
  restored(): void {
    this.clock = new GpuClock(this.gl);
    this.clearToNothing();
    this.useColours();
    for (const body of [this.snake, this.model]) body?.forgetShadows();
    this.metered = null;
    this.restart();
  }

  /** The fourth channel of a picture: -1 where there is no surface. */
  private clearToNothing(): void {
    this.renderer.setClearColor(0x000000, -1);
  }

  /** The widest colours that both screen and browser have. */
  private useColours(): void {
    const { gl } = this;
    if (!matchMedia('(color-gamut: p3)').matches || !('drawingBufferColorSpace' in gl)) return;
    gl.drawingBufferColorSpace = 'display-p3';
    if (gl.drawingBufferColorSpace === 'display-p3') this.picture.primaries = P3;
  }

  /** Changes the state; the picture starts anew where it looks different. Returns whether it does. */
  set(change: Partial<State>): boolean {
    const before = this.state;
    this.state = merged(before, change);
    const shows = ({ pointer, polar_log, motion, exposure, tone, ...rest }: State) => {
      void [pointer, polar_log, motion, exposure, tone];
      return JSON.stringify(rest);
    };
    const different = shows(before) !== shows(this.state);
    if (different) this.restart();
    return different;
  }

  restart(): void {
    this.picture.restart();
    this.other?.restart();
  }

  /** Whether the state asks for wavelengths, which the tables of XYZ do not hold. */
  wantsSpectral(): boolean {
    return this.loaded?.tables === null || this.state.illuminant !== 'tables' || this.state.scale !== 1;
  }

  /** What the state asks for and the specimen cannot give; empty where there is nothing. */
  lacking(): string {
    const { loaded, state } = this;
    if (!loaded || !this.wantsSpectral()) return '';
    if (!loaded.specimen.spectral) return 'no spectral tables: shown under the light of the tables';
    if (!loaded.spectral) return 'reading the spectral tables';
    if (loaded.specimen.pigment && state.pigment) return 'without the pigment, which is known for the tables’ light alone';
    return '';
  }

  /** The light of the state's picture; null for that of the tables of XYZ. */
  light(): Illuminant | null {
    if (this.loaded && !this.loaded.specimen.spectral) return null;
    const { illuminant: name, laser_nm, sun_deg } = this.state;
    if (name === 'tables') return this.loaded && this.wantsSpectral() ? illuminantOf(this.loaded.specimen.optics.illuminant) : null;
    return illuminant(name, laser_nm, sun_deg);
  }

  /**
   * What pictures and numbers are made from: the tables of XYZ, or spectral ones under the state's light. With all tables, or as
   * many as the state says; with the pigment below the structure, or without.
   */
  evaluated(all = false, pigment = this.state.pigment): Evaluated | null {
    const loaded = this.loaded;
    if (!loaded) return null;
    const count = all ? null : this.state.tables;
    const light = this.light();
    if (light && loaded.spectral) return this.spectralUnder(loaded.spectral, light, count);
    if (!loaded.tables) return null;
    const { uploaded, ...how } = this.lookedUp(loaded.tables);
    return { ...how, source: 'tables', uniforms: this.limited(uploaded, count, pigment) };
  }

  private spectralUnder(spectral: OnGpu<PackedSpectral>, light: Illuminant, count: number | null): Evaluated {
    const { uploaded, ...how } = this.lookedUp(spectral);
    return { ...how, source: 'spectral', uniforms: { ...this.limited(uploaded, count, false), ...this.quadratureFor(light) } };
  }

  /** How tables are looked up: as the state says where they are ready for that. */
  private lookedUp({ packed, uploaded }: OnGpu<Packed>): { uploaded: Uploaded } & Omit<Evaluated, 'source' | 'uniforms'> {
    const { interpolation, look_ups } = this.state;
    const ready = uploaded[this.readiness(packed)];
    const plain = uploaded.plain as Uploaded;
    if (!ready) return { uploaded: plain, interpolation: 'bilinear', filtered: false, provisional: true };
    // Tables for scenes alone have no levels, and the shader asks for none.
    return { uploaded: ready, interpolation, filtered: look_ups === 'filtered' && interpolation !== 'cubic', provisional: false };
  }

  /** The spectral tables under any light, where they are loaded. */
  spectralEvaluated(): Evaluated | null {
    const loaded = this.loaded;
    if (!loaded?.spectral) return null;
    const light = this.light() ?? illuminant('D65', 633, 45);
    return this.spectralUnder(loaded.spectral, light, this.state.tables);
  }

  /** The quadrature of a light for the specimen's spectral tables. */
  quadratureOf(light: Illuminant): Quadrature | null {
    const specimen = this.loaded?.specimen;
    return specimen ? quadratureOf(specimen, light) : null;
  }

  /** The uniforms with the scales of tables beyond the first few set to zero. */
  private limited({ uniforms }: Uploaded, count: number | null, pigment: boolean): Uploaded['uniforms'] {
    const block = uniforms[BINDING[0]].value;
    const scales = block.table_scales.map((quad: { clone(): unknown }) => quad.clone());
    if (count !== null) {
      scales.forEach((quad: { setComponent(i: number, v: number): void }, i: number) => {
        for (let c = 0; c < 4; c++) if (4 * i + c >= count) quad.setComponent(c, 0);
      });
    }
    const shown = { ...block, table_scales: scales };
    if (shown.pigment && !pigment) shown.pigment = shown.pigment.clone().set(0, 0, 0, 0);
    return { ...uniforms, [BINDING[0]]: { value: shown } };
  }

  private quadratureFor(light: Illuminant): Record<string, { value: unknown }> {
    const specimen = this.loaded?.specimen;
    const key = `${specimen?.name} ${light.label} ${this.state.scale}`;
    if (key !== this.quadratureKey) {
      const found = this.quadratureOf(light);
      if (!specimen || !found) return {};
      (this.quadratureUniforms.u_quadrature?.value as DataTexture | undefined)?.dispose();
      this.quadratureKey = key;
      this.quadratureUniforms = quadratureUniforms(specimen, found, this.state.scale);
    }
    return this.quadratureUniforms;
  }

  /** Wavelengths with the material's index at each. */
  asks(nm: number[]): Ask[] {
    return asksOf(this.loaded?.specimen ?? null, nm);
  }

  /** Tables of the specimen that the picture is made from. */
  tableCount(): number {
    const { loaded } = this;
    if (!loaded) return 1;
    return this.light() && loaded.spectral ? (loaded.specimen.spectral?.tables ?? 1) : (loaded.tables?.packed.params.table_count ?? 1);
  }

  /** Look-ups in tables for one direction of one light. */
  lookups(): number {
    const { loaded } = this;
    if (!loaded) return 0;
    const evaluated = this.evaluated();
    if (!evaluated) return 0;
    // A filtered look-up reads seven places; a spline is made of four linear fetches, a cubic of sixteen texels.
    const { interpolation, filtered } = evaluated;
    const block = evaluated.uniforms[BINDING[0]].value;
    const each = filtered ? 7 : interpolation === 'cubic' ? 16 : block.look_up === 1 ? 4 : 1;
    if (evaluated.source === 'spectral') {
      return (each * block.table_layers + block.cross_layers) * Number(this.quadratureUniforms.u_wavelengths?.value ?? 0);
    }
    return each * block.table_count + block.restricted;
  }

  private body(): Body | null {
    if (this.state.shape === 'snake') return (this.snake ??= snakeBody());
    return this.state.shape === 'model' ? this.model : null;
  }

  /** A mesh of the reader's own, from now on the shape "model". */
  useModel(body: Body): void {
    this.model?.geometry.dispose();
    this.model = body;
    this.restart();
  }

  /** Light from all around of the reader's own, from now on the environment "own". */
  useSky(sky: Environment): void {
    this.ownSky = skyTextures(sky);
    this.restart();
  }

  get hasSky(): boolean {
    return this.ownSky !== null;
  }

  private sky(): SkyTextures | null {
    const { environment } = this.state;
    if (environment === 'none') return null;
    if (environment === 'own') return this.ownSky;
    if (this.builtSky?.name !== environment) this.builtSky = { name: environment, sky: skyTextures(builtIn(environment)) };
    return this.builtSky.sky;
  }

  /** The factor from XYZ to the display, white being 1. */
  exposure(): number {
    const { exposure } = this.state;
    return exposure === null ? this.automatic() : Math.PI * 2 ** exposure;
  }

  private automatic(): number {
    const { specimen, shape, illuminant: light, laser_nm, scale, environment: sky } = this.state;
    const evaluated = this.evaluated();
    // One sample of the surroundings is too few to meter by.
    const few = sky !== 'none' && evaluated?.provisional;
    const key = JSON.stringify([specimen, shape, light, laser_nm, scale, sky, few]);
    if (this.metered?.key === key || !evaluated || !this.floats) return this.metered?.exposure ?? 1;
    this.meter ??= new Picture(this.renderer, FloatType);
    this.meter.resize(METER_SIDE, METER_SIDE);
    this.meter.restart();
    this.meter.sky = this.sky();
    const still: State = { ...this.state, environment_samples: 16, view: { azimuth_deg: 0, elevation_deg: 0, zoom: 1 }, light_samples: 1, pixel_samples: 1 };
    for (let i = 0; i < Picture.samplesOf(still, evaluated); i++) this.meter.step(still, evaluated, this.body());
    this.metered = { key, exposure: automaticExposure(this.meter.values()) };
    return this.metered.exposure;
  }

  /** Meters the automatic exposure anew. */
  remeter(): void {
    this.metered = null;
  }

  /** Sets the size of the picture in pixels. */
  resize(width: number, height: number): void {
    this.renderer.setSize(width, height, false);
    this.picture.resize(width, height);
    this.other?.resize(width, height);
  }

  /** Takes samples until the picture is whole or the time is up, and shows it. Returns whether it is whole. */
  draw(budget_ms: number): boolean {
    const [evaluated, body] = [this.evaluated(), this.body()];
    if (!evaluated) return true;
    const whole = this.whole(evaluated);
    this.picture.sky = this.sky();
    const started = performance.now();
    const other = this.state.difference && this.state.tables !== null ? this.otherPicture() : null;
    while (this.picture.samples < whole) {
      this.clock.time(() => this.picture.step(this.state, evaluated, body));
      if (other) other.step(this.state, this.evaluated(true) ?? evaluated, body);
      if (performance.now() - started > budget_ms) break;
    }
    this.picture.show(this.exposure(), this.state.tone, null, other);
    return this.picture.samples >= whole;
  }

  private otherPicture(): Picture {
    if (!this.other) {
      this.other = new Picture(this.renderer, this.floats ? FloatType : HalfFloatType);
      this.other.resize(this.picture.width, this.picture.height);
      this.restart();
    }
    this.other.sky = this.sky();
    return this.other;
  }

  /** The picture on black: 8-bit sRGB, four channels, top row first. */
  pixels(): { width: number; height: number; data: Uint8Array } {
    const { width, height } = this.size;
    const target = byteTarget(width, height);
    const other = this.state.difference && this.state.tables !== null ? this.other : null;
    this.picture.show(this.exposure(), this.state.tone, target, other);
    const data = new Uint8Array(4 * width * height);
    this.renderer.readRenderTargetPixels(target, 0, 0, width, height, data);
    target.dispose();
    return { width, height, data: flipped(data, width, height) };
  }

  /** The picture's XYZ, and 1 where directions have no answer or -1 beside the surface; four channels, top row first. */
  values(): { width: number; height: number; data: Float32Array } {
    return { ...this.size, data: this.picture.values() };
  }

  /** The directions of the active light at the pointer; null beside the surface. */
  directions(): Pair | null {
    const evaluated = this.evaluated();
    return evaluated && this.floats ? this.picture.directionsAt(this.state, evaluated, this.body(), this.state.pointer) : null;
  }
}
