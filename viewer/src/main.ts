// Opens the atlas beside the page and starts the page on it.

import './ui/style.css';
import { App } from './app';
import { AtlasError, atlasFiles } from './atlas/files';
import { GraphicsError } from './engine';
import { h } from './ui/dom';
import { useTheme } from './ui/theme';

const errors: string[] = [];
addEventListener('error', (event) => errors.push(event.message));
addEventListener('unhandledrejection', (event) => errors.push(String(event.reason)));

function sayFault(error: unknown): void {
  const [title, text] =
    error instanceof GraphicsError
      ? ['This page cannot draw here', `${error.message} Try another browser, or switch on hardware acceleration.`]
      : error instanceof AtlasError
        ? ['The atlas cannot be shown', error.message]
        : ['Something went wrong', String(error)];
  errors.push(`${title}: ${text}`);
  document.querySelector('.fault')?.remove();
  document.body.append(h('div', { className: 'fault', role: 'alert' }, h('div', {}, h('h2', {}, title), h('p', {}, text))));
}

useTheme();
const mount = document.getElementById('app') ?? document.body;
try {
  const app = new App(mount, atlasFiles(document), sayFault);
  const ready = app.start().catch((error: unknown) => {
    sayFault(error);
    throw error;
  });
  ready.catch(() => undefined);
  Object.assign(window, { atlasViewer: app.api(ready, errors) });
} catch (error) {
  sayFault(error);
  const ready = Promise.reject(error);
  ready.catch(() => undefined);
  Object.assign(window, { atlasViewer: { ready, errors } });
}
