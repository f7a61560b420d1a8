// Builds the page into dist/: three files that refer to each other relatively. The same sources give the same bytes.
import { build } from 'esbuild';
import { copyFile, mkdir } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const at = (...parts) => join(here, ...parts);

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
  loader: { '.glsl': 'text' },
  logLevel: 'warning',
});
await copyFile(at('src', 'index.html'), at('dist', 'index.html'));
