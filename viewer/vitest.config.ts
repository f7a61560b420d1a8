import { defineConfig } from 'vitest/config';

export default defineConfig({
  plugins: [
    {
      name: 'glsl-as-text',
      transform: (code: string, id: string) =>
        id.endsWith('.glsl') ? { code: `export default ${JSON.stringify(code)}`, map: null } : undefined,
    },
  ],
  test: { include: ['test/**/*.test.ts'] },
});
