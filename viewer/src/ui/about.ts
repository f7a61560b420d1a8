// What the atlas says of the specimen.

import type { Engine } from '../engine';
import type { Specimen, StoredMaterial } from '../atlas/specimen';
import type { State } from '../state';
import { h, shown } from './dom';
import type { Answer, View } from './views';

export function aboutView(): View {
  const facts = h('dl', { className: 'facts wide' });
  const doubts = h('div', { className: 'doubts' });
  const warnings = h('details', {}, h('summary', {}, 'What to doubt'), doubts);
  const element = h('div', {}, facts, warnings);
  let name = '';
  return {
    element,
    update: (_state: State, engine: Engine, _answer: Answer | null) => {
      const specimen = engine.loaded?.specimen;
      if (!specimen || specimen.name === name) return;
      name = specimen.name;
      facts.replaceChildren(...rows(specimen).flatMap(([term, value, title]) => [h('dt', { title }, term), h('dd', {}, value)]));
      const found = specimen.warnings ?? [];
      warnings.hidden = found.length === 0;
      doubts.replaceChildren(...found.map((text) => h('p', { className: 'caption' }, `${text[0].toUpperCase()}${text.slice(1)}.`.replace(/\.\.$/, '.'))));
    },
  };
}

function material(stored: StoredMaterial): string {
  if (stored === 'ideal') return 'reflects everything';
  return 'dielectric' in stored ? `n = ${shown(stored.dielectric.n, 4)}` : `n = ${shown(stored.conductor.n)}, k = ${shown(stored.conductor.k)}`;
}

function rows(specimen: Specimen): [string, string, string][] {
  const { optics, tables, spectral, statistics, errors, provenance } = specimen;
  const scan = provenance?.[0];
  const [first] = statistics ?? [];
  const period = first?.dominant_periods?.[0];
  const total = errors?.find((row) => row.what === 'total' && row.region === 'whole hemisphere');
  const found: ([string, string, string] | null)[] = [
    scan ? ['scan', `${scan.size.join(' × ')} px, ${shown(scan.pitch_nm[0])} nm each`, scan.file_name] : null,
    first ? ['roughness', `${shown(first.rms_height_nm)} nm rms`, 'Root mean square of the heights.'] : null,
    period ? ['period', `${shown(period.period_nm, 4)} nm at ${period.direction_deg.toFixed(0)}°`, 'The strongest period of the relief, and its direction from the x axis.'] : null,
    ['material', material(optics.material), 'Refractive index of the surface.'],
    ['coherence', `σ = ${shown(optics.sigma_nm / 1000)} µm`, 'How far apart two points may lie and still interfere: it sets how sharp the colours are.'],
    ['tables', `${tables.tables.length} of ${tables.u.samples} × ${tables.v.samples}${spectral ? `, ${spectral.tables} spectral` : ''}`, 'Tables of XYZ, and tables that hold no light and no observer.'],
    total?.p95 ? ['error', `${shown(100 * total.p95, 2)} % (95 % of directions)`, 'Of the luminance against the integral over the scan itself.'] : null,
  ];
  return found.filter((row) => row !== null);
}
