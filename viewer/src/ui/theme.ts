// Light or dark: as the system has it, until the reader chooses.

const KEY = 'diffraction-atlas-theme';

const remembered = (): string | null => {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
};

const system = (): string => (matchMedia('(prefers-color-scheme: light)').matches ? 'light' : 'dark');

/** Applies the theme, and follows the system's until the reader chooses another. */
export function useTheme(): void {
  const apply = () => (document.documentElement.dataset.theme = remembered() ?? system());
  apply();
  matchMedia('(prefers-color-scheme: light)').addEventListener('change', apply);
}

export function switchTheme(): void {
  const next = document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark';
  document.documentElement.dataset.theme = next;
  try {
    localStorage.setItem(KEY, next);
  } catch {
    // Pages opened from the disk may keep nothing; the theme then lasts as long as the page.
  }
}
