// The choice of coherence: specimens of the same scans and material that differ in it.

import type { Engine } from '../engine';
import type { Specimen } from '../atlas/specimen';
import type { Change, Control } from './controls';
import { freshId, h, shown } from './dom';

/** Specimens whose files are read to find those of the same scans: more would take long. */
const SPECIMENS_MAX = 64;

interface Coherent {
  name: string;
  surface: string;
  label: string;
  sigma_nm: number;
}

/** What the specimens have in common that one can choose the coherence of, and how each is named. */
export function coherent(name: string, { provenance, optics }: Specimen): Coherent | null {
  if (!provenance?.length || !provenance.every(({ sha256 }) => sha256)) return null;
  const surface = JSON.stringify([provenance.map(({ sha256, pitch_nm }) => [sha256, pitch_nm]), optics.material, optics.illuminant, optics.factor]);
  const source = optics.source_deg ? `a source of ${shown(optics.source_deg)}°` : `σ = ${shown(optics.sigma_nm / 1000)} µm`;
  return { name, surface, label: source, sigma_nm: optics.sigma_nm };
}

export interface CoherenceControl extends Control {
  /** Looks through the atlas for specimens of the same scans. */
  find(engine: Engine): Promise<void>;
}

export function coherenceControl(change: Change): CoherenceControl {
  const id = freshId();
  const select = h('select', { id, onchange: () => change({ specimen: select.value }) });
  const title = 'How far apart two points may lie and still interfere: a smaller source makes sharper colours. Specimens of the same scan.';
  const element = h('div', { className: 'control list', title, hidden: true }, h('label', { htmlFor: id }, 'Coherence'), select);
  let all: Coherent[] = [];
  let offered = '';
  return {
    element,
    async find(engine) {
      const { specimens } = engine.index;
      if (specimens.length > SPECIMENS_MAX) return;
      const found = await Promise.all(specimens.map(async ({ name }) => coherent(name, await engine.specimen(name))));
      all = found.filter((one) => one !== null);
    },
    update(state) {
      const now = all.find(({ name }) => name === state.specimen);
      const same = all.filter(({ surface }) => surface === now?.surface).sort((a, b) => a.sigma_nm - b.sigma_nm);
      element.hidden = same.length < 2;
      const key = JSON.stringify(same);
      if (key !== offered) {
        offered = key;
        select.replaceChildren(...same.map(({ name, label }) => h('option', { value: name }, label)));
      }
      select.value = state.specimen;
    },
  };
}
