// The page: the picture in the middle, controls on one side, linked views on the other.

import type { State } from '../state';
import { aboutView } from './about';
import { coherenceControl, type CoherenceControl } from './coherence';
import { chromaticityView } from './chromaticity';
import { button, list, section, segments, slider, toggle, type Change, type Control } from './controls';
import { h } from './dom';
import { icons } from './icons';
import { mapView, type MapView } from './map';
import { lightPad } from './pad';
import { polarView } from './polar';
import { reliefView } from './relief';
import { spectrumView, type SpectrumView } from './spectrum';
import { stage, withLight, type Grip, type Stage } from './stage';
import type { View } from './views';

export interface Page {
  element: HTMLElement;
  stage: Stage;
  map: MapView;
  spectrum: SpectrumView;
  views: View[];
  controls: Control[];
  specimens: HTMLElement;
  coherence: CoherenceControl;
  status: HTMLElement;
  badge: HTMLElement;
  loading: HTMLProgressElement;
  facts: HTMLElement;
}

export interface Actions {
  change: Change;
  current(): State;
  savePng(): void;
  record(): void;
  copyLink(): void;
  theme(): void;
  remeter(): void;
  /** The factor that shows the picture now. */
  exposure(): number;
  /** How many tables the specimen has. */
  tables(): number;
}

export function buildPage(actions: Actions): Page {
  const { change, current } = actions;
  const picture = stage(current, change);
  const map = mapView();
  const [spectrum, polar, relief] = [spectrumView(), polarView(change), reliefView()];
  const [colour, about] = [chromaticityView(), aboutView()];
  const views: View[] = [map, spectrum, polar, relief, colour, about];
  const controls: Control[] = [];
  const keep = (control: Control): HTMLElement => {
    controls.push(control);
    return control.element;
  };
  const coherence = coherenceControl(change);
  const specimens = h('div', { className: 'specimens', role: 'radiogroup', 'aria-label': 'Specimen' });
  const status = h('p', { className: 'status', role: 'status' });
  const badge = h('p', { className: 'badge', hidden: true });
  const loading = h('progress', { max: 1, value: 0, 'aria-label': 'Reading the atlas' });
  const facts = h('p', { className: 'caption' });
  picture.overlay.append(badge, status);

  const gripRow = gripChoice(picture);
  const wide = matchMedia('(min-width: 760px)').matches;
  const panel = h(
    'aside',
    { className: 'controls', 'aria-label': 'Controls' },
    section('Specimen', true, specimens, keep(coherence), facts),
    section('Shape', true, keep(shapes(change)), ...screenControls(current, change).map(keep)),
    section('Light', wide, keep(lightPad(current, change)), ...lightControls(current, change).map(keep), lampButtons(current, change)),
    section('Surface', false, ...surfaceControls(current, change).map(keep)),
    section('Picture', wide, ...pictureControls(current, change, actions).map(keep)),
    section('Trust', false, ...trustControls(current, change, actions).map(keep)),
  );
  const card = (title: string, view: View) => h('section', { className: 'card' }, h('h2', {}, title), view.element);
  const aside = h(
    'aside',
    { className: 'views', 'aria-label': 'Linked views' },
    card('Spectrum at the spot', spectrum),
    card('All viewing directions', map),
    card('Plane of incidence', polar),
    card('Relief and its frequencies', relief),
    card('Chromaticity', colour),
    card('The specimen', about),
  );
  const head = h(
    'header',
    {},
    h('div', { className: 'brand' }, icons.mark(), h('h1', {}, 'Diffraction atlas'), h('span', { className: 'atlas-name' })),
    h(
      'nav',
      { 'aria-label': 'Picture' },
      iconButton(icons.link, 'Copy link', 'Copies a link that restores this view.', actions.copyLink),
      iconButton(icons.picture, 'PNG', 'Saves the picture as PNG.', actions.savePng),
      iconButton(icons.film, 'WebM', 'Records the motion for five seconds as WebM.', actions.record),
      iconButton(icons.theme, 'Theme', 'Light or dark page.', actions.theme),
    ),
    loading,
  );
  const element = h(
    'div',
    { className: 'page' },
    head,
    panel,
    h('main', { className: 'stage' }, picture.element, h('div', { className: 'under' }, gripRow, motion(change, keep))),
    aside,
  );
  return { element, stage: picture, map, spectrum, views, controls, specimens, coherence, status, badge, loading, facts };
}

const iconButton = (icon: () => Node, word: string, title: string, onclick: () => void): HTMLElement =>
  h('button', { type: 'button', title, onclick, className: 'icon' }, icon(), h('span', { className: 'word' }, word));

function gripChoice(picture: Stage): HTMLElement {
  const control = segments<Grip>(
    {
      label: 'Dragging moves',
      title: 'What a drag on the picture moves, and the arrow keys. With Shift it is the other of light and view.',
      choices: [
        { value: 'light', label: 'light', icon: icons.light },
        { value: 'view', label: 'view', icon: icons.orbit },
        { value: 'spot', label: 'spot', icon: icons.spot },
      ],
      get: () => picture.grip,
      set: (grip) => {
        picture.grip = grip;
        return {};
      },
    },
    () => undefined,
  );
  control.update({} as State);
  return control.element;
}

function motion(change: Change, keep: (control: Control) => HTMLElement): HTMLElement {
  return keep(
    segments<State['motion']>(
      {
        label: 'Motion',
        title: 'What moves by itself.',
        choices: [
          { value: 'none', label: 'still', icon: icons.pause },
          { value: 'light', label: 'light', icon: icons.sweep },
          { value: 'turntable', label: 'object', icon: icons.turn },
        ],
        get: (state) => state.motion,
        set: (value) => ({ motion: value }),
      },
      change,
    ),
  );
}

function shapes(change: Change): Control {
  return segments<State['shape']>(
    {
      label: 'Shape',
      title: 'What wears the structure.',
      choices: [
        { value: 'ball', label: 'ball', icon: icons.ball, title: 'A ball: every orientation at once.' },
        { value: 'snake', label: 'snake', icon: icons.snake, title: 'A snake with scales.' },
        { value: 'patch', label: 'flat', icon: icons.flat, title: 'A flat sample, tilted.' },
        { value: 'screen', label: 'screen', icon: icons.screen, title: 'A beam through a hole in a screen, thrown back on it.' },
        { value: 'map', label: 'map', icon: icons.map, title: 'The BRDF itself over all viewing directions.' },
        { value: 'model', label: 'own', icon: icons.own, title: 'Your own mesh: drop a .glb or .obj file with texture coordinates on the page.' },
      ],
      get: (state) => state.shape,
      set: (shape) => ({ shape, view: { azimuth_deg: 0, elevation_deg: 0, zoom: 1 }, spin_deg: 0 }),
    },
    change,
  );
}

function screenControls(current: () => State, change: Change): Control[] {
  const onScreen = (state: State) => state.shape === 'screen';
  const flat = (state: State) => state.shape === 'patch';
  return [
    slider({ label: 'Incidence', unit: '°', title: 'Turns the sample about the vertical.', min: 0, max: 40, step: 1, get: (s) => s.screen.incidence_deg, set: (v, s) => ({ screen: { ...s.screen, incidence_deg: v } }), when: onScreen }, current, change),
    slider({ label: 'Distance', unit: ' mm', title: 'From the screen to the sample.', min: 30, max: 300, step: 5, get: (s) => s.screen.distance_mm, set: (v, s) => ({ screen: { ...s.screen, distance_mm: v } }), when: onScreen }, current, change),
    slider({ label: 'Beam', unit: ' mm', title: 'Diameter of the beam and of the hole.', min: 0.5, max: 10, step: 0.5, get: (s) => s.screen.beam_mm, set: (v, s) => ({ screen: { ...s.screen, beam_mm: v } }), when: onScreen }, current, change),
    slider({ label: 'Tilt', unit: '°', title: 'Leans the upper edge of the sample away.', min: 0, max: 80, step: 1, get: (s) => s.patch.tilt_deg, set: (v, s) => ({ patch: { ...s.patch, tilt_deg: v } }), when: flat }, current, change),
  ];
}

function lightControls(current: () => State, change: Change): Control[] {
  const light = (state: State) => state.lights[state.active];
  const angles = (state: State) => {
    const [x, y, z] = light(state).direction;
    return { theta: (Math.atan2(Math.hypot(x, y), z) * 180) / Math.PI, phi: (Math.atan2(y, x) * 180) / Math.PI };
  };
  const pointed = (theta: number, phi: number): State['lights'][number]['direction'] => {
    const [t, p] = [(theta * Math.PI) / 180, (phi * Math.PI) / 180];
    return [Math.sin(t) * Math.cos(p), Math.sin(t) * Math.sin(p), Math.cos(t)];
  };
  return [
    slider({ label: 'Angle', unit: '°', title: 'Angle of the light from the line of sight at rest.', min: 0, max: 175, step: 0.5, get: (s) => angles(s).theta, set: (v, s) => withLight(s, { direction: pointed(Math.max(v, 0.01), angles(s).phi) }), text: (v) => `${v.toFixed(1)}°`, when: (s) => s.shape !== 'screen' }, current, change),
    slider({ label: 'Azimuth', unit: '°', title: 'Where the light stands around the line of sight; 0 is to the right.', min: -180, max: 180, step: 1, get: (s) => angles(s).phi, set: (v, s) => withLight(s, { direction: pointed(angles(s).theta, v) }), text: (v) => `${v.toFixed(0)}°`, when: (s) => s.shape !== 'screen' }, current, change),
    slider({ label: 'Size', unit: '°', title: 'Full angle of the light’s disc: 0 is a point, 0.53° the sun.', min: 0, max: 30, step: 0.01, get: (s) => light(s).diameter_deg, set: (v, s) => withLight(s, { diameter_deg: v }) }, current, change),
    slider({ label: 'Strength', title: 'Irradiance on a surface that faces the light; 0 switches it off.', min: 0, max: 4, step: 0.05, get: (s) => light(s).irradiance, set: (v, s) => withLight(s, { irradiance: v }) }, current, change),
    list<State['illuminant']>(
      {
        label: 'Spectrum',
        title: 'The light’s spectrum. All but the first need spectral tables.',
        choices: [
          { value: 'tables', label: 'as in the tables' },
          { value: 'D65', label: 'D65, daylight' },
          { value: 'A', label: 'A, incandescent' },
          { value: 'F11', label: 'F11, fluorescent' },
          { value: 'LED', label: 'white LED' },
          { value: 'sun', label: 'sun at a height' },
          { value: 'laser', label: 'laser line' },
          { value: 'E', label: 'E, equal power' },
        ],
        get: (s) => s.illuminant,
        set: (illuminant) => ({ illuminant }),
      },
      change,
    ),
    list<State['environment']>(
      {
        label: 'Surroundings',
        title: 'Light from all around, besides the lights. Drop an .exr or .hdr file on the page to use your own.',
        choices: [
          { value: 'none', label: 'dark' },
          { value: 'overcast', label: 'overcast sky' },
          { value: 'window', label: 'room with windows' },
          { value: 'own', label: 'own image' },
        ],
        get: (s) => s.environment,
        set: (environment) => ({ environment }),
        when: (s) => s.shape !== 'map' && s.shape !== 'screen',
      },
      change,
    ),
    slider({ label: 'Wavelength', unit: ' nm', title: 'Wavelength of the laser.', min: 400, max: 700, step: 1, get: (s) => s.laser_nm, set: (v) => ({ laser_nm: v }), when: (s) => s.illuminant === 'laser' }, current, change),
    slider({ label: 'Sun’s height', unit: '°', title: 'Height of the sun above the horizon: low suns are red.', min: 1, max: 90, step: 1, get: (s) => s.sun_deg, set: (v) => ({ sun_deg: v }), when: (s) => s.illuminant === 'sun' }, current, change),
  ];
}

function lampButtons(current: () => State, change: Change): HTMLElement {
  const add = () => {
    const state = current();
    if (state.lights.length >= 4) return;
    const [x, y, z] = state.lights[state.active].direction;
    const light = { ...state.lights[state.active], direction: [-x - 0.2, y + 0.1, z] as [number, number, number] };
    change({ lights: [...state.lights, light], active: state.lights.length });
  };
  const remove = () => {
    const state = current();
    if (state.lights.length > 1) change({ lights: state.lights.filter((_, i) => i !== state.active), active: 0 });
  };
  return h('div', { className: 'buttons' }, button('Add a light', 'Up to four lights at once.', add), button('Remove it', 'Removes the light that is chosen on the disc.', remove));
}

function surfaceControls(current: () => State, change: Change): Control[] {
  return [
    slider({ label: 'Orientation', unit: '°', title: 'Turns the structure on the surface.', min: -90, max: 90, step: 1, get: (s) => s.turn_deg, set: (v) => ({ turn_deg: v }) }, current, change),
    slider({ label: 'Scale', title: 'Shrinks the structure in all directions, heights too, and the coherence with it: what it does to a wavelength, the scanned one does to a longer one. Needs spectral tables.', min: 0.4, max: 1, step: 0.01, get: (s) => s.scale, set: (v) => ({ scale: v }), text: (v) => `× ${v.toFixed(2)}` }, current, change),
    toggle({ label: 'pigment below the structure', title: 'Where the specimen has a pigment.', get: (s) => s.pigment, set: (v) => ({ pigment: v }) }, change),
  ];
}

function pictureControls(current: () => State, change: Change, actions: Actions): Control[] {
  const auto = button('Auto', 'Meters the exposure anew: the brightest half percent comes to white.', () => {
    change({ exposure: null });
    actions.remeter();
  });
  const exposure = slider({ label: 'Exposure', title: 'In stops. 0 shows a white wall facing the light as white.', min: -8, max: 14, step: 0.1, get: (s) => s.exposure ?? Math.log2(actions.exposure() / Math.PI), set: (v) => ({ exposure: v }), text: (v, s) => `${v >= 0 ? '+' : '−'}${Math.abs(v).toFixed(1)}${s.exposure === null ? ' auto' : ''}` }, current, change);
  exposure.element.append(auto);
  return [
    exposure,
    segments<State['tone']>({ label: 'Bright and saturated colours', title: 'What becomes of colours that no display shows.', choices: [{ value: 'atlas', label: 'keep the hue' }, { value: 'clip', label: 'cut channels' }], get: (s) => s.tone, set: (tone) => ({ tone }) }, change),
  ];
}

function trustControls(current: () => State, change: Change, actions: Actions): Control[] {
  const all = actions.tables;
  return [
    slider({ label: 'Tables used', title: 'How many tables of the expansion are summed.', min: 1, max: all, step: 1, get: (s) => s.tables ?? all(), set: (v) => ({ tables: v >= all() ? null : v }), text: (v, s) => (s.tables === null ? 'all' : `${v}`) }, current, change),
    toggle({ label: 'show the difference', title: 'The difference of luminance from all tables, ten times enlarged, in place of the picture.', get: (s) => s.difference, set: (v) => ({ difference: v }), when: (s) => s.tables !== null }, change),
    segments<State['look_ups']>({ label: 'Lights and pixels', title: 'A filtered look-up is the mean over a light’s disc and over what a pixel shows; of lights wider than two degrees there are several. Points are samples of both, as in the report’s pictures.', choices: [{ value: 'filtered', label: 'filtered' }, { value: 'points', label: 'points' }], get: (s) => s.look_ups, set: (look_ups) => ({ look_ups }), when: (s) => s.interpolation !== 'cubic' }, change),
    segments<State['interpolation']>({ label: 'Between texels', title: 'Splines are closest to the scan, and what the atlas’s tolerance is meant for; bilinear look-ups are the hardware’s own; cubic ones go through four texels a side, at points.', choices: [{ value: 'spline', label: 'spline' }, { value: 'bilinear', label: 'bilinear' }, { value: 'cubic', label: 'cubic' }], get: (s) => s.interpolation, set: (interpolation) => ({ interpolation }) }, change),
  ];
}
