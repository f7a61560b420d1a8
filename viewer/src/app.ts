// The page at work: changes of the state become pictures, answers and the page's address.

import { fromAngles } from './angles';
import type { AtlasFiles } from './atlas/files';
import { measuredSpectra, type MeasuredSpectrum } from './atlas/measured';
import { Engine } from './engine';
import { dominantWavelength } from './light/colour';
import { illuminantOf, quadrature, type Illuminant, type Xyz } from './light/illuminants';
import type { Vec3 } from './light/samples';
import { fromFragment, toFragment, type State } from './state';
import { aboutVertical } from './gl/camera';
import { download, recordWebm } from './ui/capture';
import { buildPage, type Page } from './ui/page';
import { plotWavelengths } from './ui/spectrum';
import { specimenCards } from './ui/specimens';
import { switchTheme } from './ui/theme';
import { readEnvironment } from './scene/environment';
import { readModel } from './scene/model';
import { chooseFile, dropTarget } from './ui/drop';
import { h, shown } from './ui/dom';
import { planeOfIncidence, type Answer } from './ui/views';

const VIEWS_EVERY_MS = 70;
const ADDRESS_EVERY_MS = 400;
/** What a sample may take while something moves, and how long nothing must move before the picture gets every pixel. */
const MOVING_MS = 36;
const STILL_AFTER_MS = 300;
const COARSEST = 0.25;

export class App {
  readonly engine: Engine;
  readonly page: Page;
  private pending: Promise<void> = Promise.resolve();
  /** A viewing direction that is asked in place of the spot's. */
  private asked: Vec3 | null = null;
  /** A measured spectrum whose directions are asked. */
  private measured: MeasuredSpectrum | null = null;
  private offeredFor = '';
  private stale = { picture: true, views: true, controls: true, address: false };
  private last = { views: 0, address: 0, tick: 0 };
  private frameMs = 0;
  /** Pixels per pixel of the screen along each side: now, and while something moves. */
  private detail = { now: 1, moving: 1 };
  private moved = 0;
  private tickMs = 16;
  private drew = false;
  private recording = false;
  private opened = false;
  /** What the page says while the graphics driver keeps its memory to itself. */
  private lost: HTMLElement | null = null;

  constructor(
    mount: HTMLElement,
    files: AtlasFiles,
    private readonly fault: (error: unknown) => void,
  ) {
    this.page = buildPage({
      change: (change) => this.set(change),
      current: () => this.engine.state,
      savePng: () => this.savePng(),
      record: () => void this.record(),
      copyLink: () => void this.copyLink(),
      theme: () => {
        switchTheme();
        this.stale.views = true;
      },
      exposure: () => (this.opened ? this.engine.exposure() : Math.PI),
      tables: () => this.engine?.tableCount() ?? 1,
      remeter: () => {
        this.engine.remeter();
        this.stale.picture = this.stale.controls = true;
      },
    });
    this.engine = new Engine(this.page.stage.canvas, files, fromFragment(location.hash));
    mount.replaceChildren(this.page.element);
    this.page.map.onAsk = (wo) => {
      this.asked = wo;
      this.stale.views = true;
    };
    this.page.spectrum.onChoose = (measured) => {
      this.measured = measured;
      this.stale.views = true;
    };
    const { canvas } = this.page.stage;
    canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      this.lost ??= lostNotice();
    });
    canvas.addEventListener('webglcontextrestored', () => this.restored());
    dropTarget(mount, (dropped) => void this.take(dropped));
    new ResizeObserver(() => this.fit()).observe(this.page.stage.element);
    addEventListener('hashchange', () => {
      if (location.hash !== toFragment(this.engine.state)) this.set(fromFragment(location.hash));
    });
  }

  /** Opens the atlas, shows the first picture, and goes on for ever. */
  async start(): Promise<void> {
    const { engine, page } = this;
    await engine.open();
    const name = page.element.querySelector('.atlas-name');
    if (name) name.textContent = engine.index.name;
    document.title = `${engine.index.name} – diffraction atlas`;
    page.specimens.append(...(await specimenCards(engine, (specimen) => this.set({ specimen }))));
    await this.load();
    this.opened = true;
    this.firstFrame();
    page.element.classList.add('ready');
    performance.mark('first view');
    const tick = (now: number) => {
      try {
        if (!this.lost) this.tick(now);
        requestAnimationFrame(tick);
      } catch (error) {
        this.fault(error);
      }
    };
    requestAnimationFrame((now) => {
      this.measureSpeed();
      tick(now);
    });
    this.pending = this.pending.then(() => this.load(true));
    // A specimen that cannot be read says so when it is chosen.
    void page.coherence.find(engine).then(() => (this.stale.controls = true), () => undefined);
  }

  /** Draws coarsely: whoever compiles shaders and draws on the processor shows something soon. */
  private firstFrame(): void {
    this.detail.now = this.detail.moving = COARSEST;
    this.fit();
    this.engine.draw(0);
    this.stale.picture = true;
  }

  /** How coarse the picture must be to move smoothly: the first frame once more, now that shaders are compiled. */
  private measureSpeed(): void {
    const { engine } = this;
    engine.finish();
    engine.restart();
    const started = performance.now();
    engine.draw(0);
    engine.finish();
    const whole = (performance.now() - started) / COARSEST ** 2;
    this.detail.moving = Math.min(1, Math.max(COARSEST, Math.sqrt(MOVING_MS / whole)));
  }

  set(change: Partial<State>): void {
    const before = this.engine.state;
    if (change.shape === 'model' && !this.engine.model) {
      this.stale.controls = true;
      chooseFile('.glb,.gltf,.obj', (files) => void this.take(files));
      return;
    }
    if (change.environment === 'own' && before.environment !== 'own' && !this.engine.hasSky) {
      this.stale.controls = true;
      chooseFile('.exr,.hdr', (files) => void this.take(files));
      return;
    }
    if (this.engine.set(change)) this.moved = performance.now();
    const after = this.engine.state;
    if (change.pointer || change.specimen) this.asked = this.measured = null;
    this.stale = { picture: true, views: true, controls: true, address: true };
    if (before.size_px !== after.size_px) this.fit();
    if (!this.opened) return;
    const spectral = this.engine.wantsSpectral() && !this.engine.loaded?.spectral;
    if (before.specimen !== after.specimen || spectral || !this.engine.isReady()) this.pending = this.pending.then(() => this.load());
  }

  /** Loads what the state needs; `spectral` loads those tables whether or not the picture needs them. */
  private async load(spectral = false): Promise<void> {
    const { engine, page } = this;
    const progress = (share: number) => {
      page.loading.value = share;
      page.loading.hidden = share >= 1;
    };
    try {
      progress(0.02);
      await engine.loadSpecimen(progress);
      if (this.opened && (await engine.makeReady())) this.stale.picture = this.stale.views = true;
      if (spectral || engine.wantsSpectral() || this.opened) await engine.loadSpectral(progress);
      progress(1);
      if (this.opened) await engine.makeReady();
    } catch (error) {
      progress(1);
      this.fault(error);
      if (!this.opened) throw error;
    }
    this.stale = { picture: true, views: true, controls: true, address: true };
    const name = engine.loaded?.specimen.name ?? '';
    if (this.offeredFor !== name) {
      this.offeredFor = name;
      page.spectrum.offer(measuredSpectra((await engine.viewerFile())?.measured?.[name] ?? []));
    }
  }

  private fit(): void {
    const { size_px } = this.engine.state;
    const box = this.page.stage.element.getBoundingClientRect();
    const dpr = Math.min(2, devicePixelRatio || 1);
    const side = Math.min(box.width, box.height);
    this.page.stage.square(size_px ? side : null);
    const detail = dpr * this.detail.now;
    const [width, height] = size_px ? [size_px, size_px] : [Math.round(box.width * detail), Math.round(box.height * detail)];
    if (width < 1 || height < 1) return;
    this.engine.resize(width, height);
    this.stale.picture = this.stale.views = true;
  }

  private tick(now: number): void {
    const { engine, page, stale } = this;
    this.move(now);
    if (stale.controls) {
      stale.controls = false;
      for (const control of page.controls) control.update(engine.state);
      for (const input of page.specimens.querySelectorAll('input')) input.checked = input.value === engine.state.specimen;
      page.stage.update(engine.state);
      page.facts.textContent = this.specimenFacts();
    }
    if (this.recording) stale.picture = true;
    this.chooseDetail(now);
    if (stale.picture) {
      const started = performance.now();
      stale.picture = !engine.draw(0);
      this.frameMs = 0.8 * this.frameMs + 0.2 * (performance.now() - started);
      this.updateStatus();
    }
    if (stale.views && now - this.last.views > VIEWS_EVERY_MS) {
      stale.views = false;
      this.last.views = now;
      this.updateViews();
    }
    if (stale.address && now - this.last.address > ADDRESS_EVERY_MS) {
      stale.address = false;
      this.last.address = now;
      if (engine.state.motion === 'none') history.replaceState(null, '', toFragment(engine.state) || location.pathname + location.search);
    }
  }

  /** The graphics driver is back: everything goes to it anew. */
  private restored(): void {
    this.engine.restored();
    this.lost?.remove();
    this.lost = null;
    this.stale = { picture: true, views: true, controls: true, address: false };
  }

  /** Fewer pixels while something moves and the GPU is slow; all of them once it stands still. */
  private chooseDetail(now: number): void {
    const { detail, stale } = this;
    const moving = this.recording || now - this.moved < STILL_AFTER_MS;
    if (moving && this.drew && detail.now === detail.moving) {
      const took = Math.min(1000, this.tickMs);
      if (took > 1.4 * MOVING_MS) detail.moving = Math.max(COARSEST, detail.moving * Math.max(0.5, Math.sqrt(MOVING_MS / took)));
      else if (took < 0.6 * MOVING_MS && detail.moving < 1) detail.moving = Math.min(1, detail.moving * 1.1);
    }
    this.drew = stale.picture;
    const wanted = moving ? detail.moving : 1;
    if (Math.abs(wanted - detail.now) < 0.02 * detail.now && wanted !== 1) return;
    if (wanted === detail.now) return;
    detail.now = wanted;
    this.fit();
  }

  /** What moves by itself since the last frame. */
  private move(now: number): void {
    this.tickMs = now - this.last.tick;
    const seconds = Math.min(0.1, this.tickMs / 1000);
    this.last.tick = now;
    const { state } = this.engine;
    if (state.motion === 'light') {
      const lights = state.lights.map((light) => ({ ...light, direction: aboutView(light.direction, 40 * seconds) }));
      this.set({ lights });
    } else if (state.motion === 'turntable') this.set({ spin_deg: (state.spin_deg + 30 * seconds) % 360 });
  }

  /** Asks the spot, and brings every view to the answer. */
  private updateViews(): void {
    const answer = this.answer();
    for (const view of this.page.views) view.update(this.engine.state, this.engine, answer);
    this.updateBadge(answer);
    this.updateStatus();
  }

  private answer(): Answer | null {
    const { engine } = this;
    const evaluated = engine.evaluated();
    const found = this.measured ? directionsOf(this.measured) : engine.directions();
    if (!found || !evaluated) return null;
    const pair = { wi: found.wi, wo: this.asked ?? found.wo };
    const inPlane = planeOfIncidence(pair.wi).map((wo) => ({ wi: pair.wi, wo }));
    const [xyz, ...plane] = engine.probe.brdf(evaluated, [pair, ...inPlane]);
    const specimen = engine.loaded?.specimen;
    const light = engine.light() ?? illuminantOf(specimen?.optics.illuminant ?? 'd65');
    const white = whiteOf(light);
    const spectral = engine.spectralEvaluated();
    const stored = specimen?.spectral;
    let spectrum: Answer['spectrum'] = null;
    if (spectral && stored) {
      const at = this.measured?.nm ?? [];
      const nm = [...new Set([...plotWavelengths(stored.shortest_nm, stored.longest_nm), ...at])].sort((a, b) => a - b);
      const measured = nm.map((one) => this.measured?.values[at.indexOf(one)] ?? null);
      spectrum = { nm, values: engine.probe.spectrum(spectral, pair, engine.asks(nm)), measured };
    }
    return { ...pair, chosen: this.measured !== null, xyz, plane, white, dominant: xyz ? dominantWavelength(xyz, white) : null, spectrum };
  }

  private updateBadge(answer: Answer | null): void {
    const { badge } = this.page;
    const usable = this.engine.loaded?.specimen.tables.usable_radius ?? 2;
    const radius = answer ? Math.hypot(answer.wi[0] + answer.wo[0], answer.wi[1] + answer.wo[1]) : 0;
    const words = this.engine.lacking() || (answer && !answer.xyz ? 'the tables do not cover the spot' : radius > usable ? 'the spot lies beyond the scan’s sampling' : '');
    badge.textContent = words;
    badge.hidden = words === '';
  }

  private updateStatus(): void {
    const { engine } = this;
    const { taken, whole } = engine.progress;
    this.page.status.textContent = `${Math.min(taken, whole)} / ${whole} samples · ${engine.size.width} × ${engine.size.height} · ${engine.lookups()} look-ups · ${engine.clock.ms === null ? `${shown(this.frameMs, 2)} ms` : `${shown(engine.clock.ms, 2)} ms GPU`}`;
  }

  private specimenFacts(): string {
    const specimen = this.engine.loaded?.specimen;
    if (!specimen) return '';
    const { sigma_nm } = specimen.optics;
    return `${specimen.species ?? specimen.name} · coherence σ ${shown(sigma_nm / 1000)} µm`;
  }

  /** Files dropped on the page, or chosen: a mesh, or an image of the surroundings. */
  private async take(files: File[]): Promise<void> {
    for (const file of files) {
      try {
        if (/\.(glb|gltf|obj)$/i.test(file.name)) {
          this.engine.useModel(await readModel(file));
          this.set({ shape: 'model', view: { azimuth_deg: 0, elevation_deg: 0, zoom: 1 } });
        } else if (/\.(exr|hdr)$/i.test(file.name)) {
          this.engine.useSky(await readEnvironment(file));
          this.set({ environment: 'own' });
        } else throw new Error('The page takes meshes (.glb, .gltf, .obj) and images of the surroundings (.exr, .hdr).');
      } catch (error) {
        this.notice(`${file.name}: ${error instanceof Error ? error.message : String(error)}`);
      }
    }
  }

  /** A few words that go away by themselves. */
  private notice(text: string): void {
    const note = h('p', { className: 'notice', role: 'alert' }, text);
    document.body.append(note);
    setTimeout(() => note.remove(), 7000);
  }

  private savePng(): void {
    this.detail.now = 1;
    this.fit();
    this.engine.draw(Infinity);
    this.page.stage.canvas.toBlob((blob) => blob && download(blob, `${this.engine.state.specimen}.${this.engine.state.shape}.png`));
  }

  private async record(): Promise<void> {
    const { state } = this.engine;
    if (state.motion === 'none') this.set({ motion: 'light' });
    this.recording = true;
    const blob = await recordWebm(this.page.stage.canvas, 5);
    this.recording = false;
    if (state.motion === 'none') this.set({ motion: 'none' });
    if (!blob) this.notice('This browser records no WebM.');
    else download(blob, `${state.specimen}.${state.shape}.webm`);
  }

  private async copyLink(): Promise<void> {
    history.replaceState(null, '', toFragment(this.engine.state) || location.pathname + location.search);
    try {
      await navigator.clipboard.writeText(location.href);
      this.notice('The link is copied.');
    } catch {
      this.notice('The link stands in the address bar.');
    }
  }

  /** What tests and other pages may call. */
  api(ready: Promise<void>, errors: string[]) {
    const { engine } = this;
    const pair = (theta_i: number, phi_i: number, theta_r: number, phi_r: number) => ({ wi: fromAngles(theta_i, phi_i), wo: fromAngles(theta_r, phi_r) });
    const settled = async () => {
      await ready;
      await this.pending;
    };
    return {
      ready,
      errors,
      set: (change: Partial<State>) => this.set(change),
      state: () => structuredClone(engine.state),
      frame: async () => {
        await settled();
        if (this.lost) return;
        this.detail.now = 1;
        this.fit();
        engine.draw(Infinity);
        this.updateViews();
      },
      pixels: () => engine.pixels(),
      xyz: () => engine.values(),
      exposure: () => engine.exposure(),
      gpuMs: () => engine.clock.ms,
      /** What the views show of the spot: directions, XYZ, and the spectrum with what was measured there. */
      spot: async () => {
        await settled();
        const answer = this.answer();
        return answer && { ...answer, spectrum: answer.spectrum && { ...answer.spectrum, values: Array.from(answer.spectrum.values) } };
      },
      brdfXyz: async (...angles: [number, number, number, number]): Promise<Xyz | null> => {
        await settled();
        const evaluated = engine.evaluated(false, false);
        return evaluated ? engine.probe.brdf(evaluated, [pair(...angles)])[0] : null;
      },
      spectrumAt: async (theta_i: number, phi_i: number, theta_r: number, phi_r: number, wavelengths_nm?: number[]) => {
        await settled();
        const stored = engine.loaded?.specimen.spectral;
        if (!stored || !(await engine.loadSpectral(() => undefined))) throw new Error('the specimen has no spectral tables');
        const nm = wavelengths_nm ?? plotWavelengths(stored.shortest_nm, stored.longest_nm);
        await engine.makeReady();
        const evaluated = engine.spectralEvaluated();
        if (!evaluated) throw new Error('the specimen has no spectral tables');
        const values = engine.probe.spectrum(evaluated, pair(theta_i, phi_i, theta_r, phi_r), engine.asks(nm));
        return { wavelengths_nm: nm, values: Array.from(values) };
      },
    };
  }
}

const directionsOf = ({ angles_deg: [ti, pi, tr, pr] }: MeasuredSpectrum) => ({ wi: fromAngles(ti, pi), wo: fromAngles(tr, pr) });

function lostNotice(): HTMLElement {
  const words = 'The graphics driver took its memory back, as it does when it restarts or when another program wants it. The page goes on by itself once it may draw again.';
  const again = h('button', { type: 'button', onclick: () => location.reload() }, 'Load the page again');
  const notice = h('div', { className: 'fault', role: 'alert' }, h('div', {}, h('h2', {}, 'The picture is gone for a moment'), h('p', {}, words), again));
  document.body.append(notice);
  return notice;
}

/** A direction turned about the line of sight. */
function aboutView([x, y, z]: Vec3, angle_deg: number): Vec3 {
  const [a, , b] = aboutVertical([x, 0, y], angle_deg);
  return [a, b, z];
}

const whites = new Map<string, Xyz>();
function whiteOf(light: Illuminant): Xyz {
  let white = whites.get(light.label);
  if (!white) {
    const sums = quadrature(light, [380, 780], 401).weights.reduce((sum, w) => sum.map((c, i) => c + w[i]) as Xyz, [0, 0, 0] as Xyz);
    whites.set(light.label, (white = sums));
  }
  return white;
}
