// Writes src/generated/cie.json from the tables of crates/brdf/src/cie_data.rs, which has the sources of the numbers.
import { readFile, writeFile } from 'node:fs/promises';

export async function cieFromRust() {
  const text = await readFile(new URL('../../crates/brdf/src/cie_data.rs', import.meta.url), 'utf8');
  const table = (name) => {
    const start = text.indexOf('= [', text.indexOf(`pub const ${name}:`));
    const end = text.indexOf('];', start);
    const body = text.slice(start + 2, end + 1).replace(/\/\/.*$/gm, '').replace(/,(\s*\])/g, '$1');
    return JSON.parse(body);
  };
  const number = (name) => Number(text.match(new RegExp(`pub const ${name}: f64 = ([0-9.]+);`))[1]);
  return {
    observerFirstNm: number('OBSERVER_FIRST_NM'),
    observer: table('OBSERVER_2DEG'),
    stepNm: number('ILLUMINANT_STEP_NM'),
    d65FirstNm: number('D65_FIRST_NM'),
    d65: table('D65'),
    fluorescentFirstNm: number('FLUORESCENT_FIRST_NM'),
    fluorescent: table('FLUORESCENT'),
  };
}

if (process.argv[1] === new URL(import.meta.url).pathname) {
  const data = await cieFromRust();
  await writeFile(new URL('../src/generated/cie.json', import.meta.url), `${JSON.stringify(data)}\n`);
}
