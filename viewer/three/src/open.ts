// An atlas at an address.

import { AtlasError, filesFrom, under } from '../../src/atlas/files';
import { packSpectral, packTables, type Progress } from '../../src/atlas/pack';
import { readIndex, readSpecimen } from '../../src/atlas/specimen';
import { illuminant, illuminantOf } from '../../src/light/illuminants';
import { DiffractionMaterial, type DiffractionOptions } from './material';

/** An atlas whose index has been read; tables are loaded with each material. */
export interface OpenAtlas {
  /** Names of its specimens. */
  specimens: string[];
  /**
   * A specimen as a material: its files are fetched and held against their digests. An `illuminant` other than the tables' own needs
   * spectral tables. Throws an AtlasError that says which file is missing or damaged, and for a specimen that is not there.
   */
  material(specimen: string, options?: DiffractionOptions, progress?: Progress): Promise<DiffractionMaterial>;
}

/** Opens an atlas, or one version of it, at an address relative to the page. Of an atlas the newest version is taken. */
export async function openAtlas(address: string): Promise<OpenAtlas> {
  const base = address.endsWith('/') ? address : `${address}/`;
  const latest = await under(base)('latest');
  const folder = latest ? `${base}${new TextDecoder().decode(latest).trim()}/` : base;
  const files = filesFrom(under(folder), async (path) => `${folder}${path}`);
  const index = await readIndex(files);
  files.expect(index.files);
  const specimens = index.specimens.map(({ name }) => name);
  return {
    specimens,
    async material(name, options = {}, progress = () => undefined) {
      if (!specimens.includes(name)) throw new AtlasError(`The atlas has no specimen ${name}; it has ${specimens.join(', ')}.`);
      const specimen = await readSpecimen(files, name);
      const tables = options.illuminant ? null : await packTables(files, specimen, progress);
      if (tables) return new DiffractionMaterial({ specimen, packed: tables, light: null }, options);
      const spectral = await packSpectral(files, specimen, progress);
      if (!spectral) throw new AtlasError(`The specimen ${name} has no spectral tables, so it is seen under its own light alone.`);
      const light = options.illuminant
        ? illuminant(options.illuminant, options.laserNm ?? 633, options.sunDeg ?? 45)
        : illuminantOf(specimen.optics.illuminant);
      return new DiffractionMaterial({ specimen, packed: spectral, light }, options);
    },
  };
}
