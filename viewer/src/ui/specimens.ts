// The specimens as small pictures to choose from.

import type { Engine } from '../engine';
import { freshId, h } from './dom';

export async function specimenCards(engine: Engine, choose: (name: string) => void): Promise<HTMLElement[]> {
  const group = freshId();
  return Promise.all(
    engine.index.specimens.map(async ({ name, species }, i) => {
      const first = engine.state.specimen ? name === engine.state.specimen : i === 0;
      const input = h('input', { type: 'radio', name: group, value: name, checked: first, onchange: () => choose(name) });
      const path = `${name}/preview.png`;
      const listed = engine.index.files.some((file) => file.path === path);
      const image = h('img', { alt: '', loading: 'lazy', src: listed ? await engine.files.url(path) : '' });
      if (!listed) image.hidden = true;
      return h('label', { className: 'specimen', title: species ?? name }, input, image, h('span', {}, name.replaceAll('_', ' ')));
    }),
  );
}
