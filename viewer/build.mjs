// Builds the page into dist/: three files that refer to each other relatively. The same sources give the same bytes.
import { build } from 'esbuild';
import { copyFile, mkdir, readFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const at = (...parts) => join(here, ...parts);

// What the page is built with asks for its licence to go with every copy.
const licence = async (name) => `${name}\n\n${(await readFile(at('node_modules', name, 'LICENSE'), 'utf8')).trim()}`;
const mit = (await licence('uplot')).split('Permission is')[1];
const fflate = `fflate, as three carries it\n\nCopyright (c) 2020 Arjun Barrett\n\nPermission is${mit}`;
const licences = [await licence('three'), await licence('three-mesh-bvh'), await licence('uplot'), fflate].join('\n\n----\n\n').replaceAll('*/', '* /');

await mkdir(at('dist'), { recursive: true });
await build({
  absWorkingDir: here,
  entryPoints: { viewer: 'src/main.ts' },
  outdir: 'dist',
  bundle: true,
  format: 'iife',
  target: ['es2022'],
  charset: 'utf8',
  minify: true,
  legalComments: 'eof',
  footer: { js: `/*\nThis page contains:\n\n${licences}\n*/` },
  loader: { '.glsl': 'text' },
  logLevel: 'warning',
});
await copyFile(at('src', 'index.html'), at('dist', 'index.html'));
