// Controls that follow the state: each has a label, a unit, a tooltip, and works with the keyboard as the browser's own do.

import type { State } from '../state';
import { freshId, h } from './dom';

export interface Control {
  element: HTMLElement;
  /** Brings the control to what the state says. */
  update(state: State): void;
}

export type Change = (change: Partial<State>) => void;

interface SliderOptions {
  label: string;
  unit?: string;
  title: string;
  min: number;
  max: number | (() => number);
  step: number;
  get(state: State): number;
  set(value: number, state: State): Partial<State>;
  /** What is shown for a value; the number with its unit where absent. */
  text?(value: number, state: State): string;
  /** Hidden where this is false. */
  when?(state: State): boolean;
}

export function slider(options: SliderOptions, current: () => State, change: Change): Control {
  const { label, unit = '', title, min, step } = options;
  const most = () => (typeof options.max === 'number' ? options.max : options.max());
  const id = freshId();
  const output = h('output', { htmlFor: id });
  const input = h('input', {
    type: 'range', id, min, max: most(), step, title,
    oninput: () => change(options.set(Number(input.value), current())),
  });
  const element = h('div', { className: 'control', title }, h('label', { htmlFor: id }, label), output, input);
  return {
    element,
    update: (state) => {
      const value = options.get(state);
      const max = most();
      input.max = String(max);
      input.value = String(value);
      const text = options.text?.(value, state) ?? `${Number(value.toFixed(2))}${unit}`;
      output.textContent = text;
      input.setAttribute('aria-valuetext', text);
      input.style.setProperty('--filled', `${(100 * (Number(input.value) - min)) / (max - min)}%`);
      element.hidden = options.when ? !options.when(state) : false;
    },
  };
}

interface ChoiceOptions<T extends string> {
  label: string;
  title: string;
  choices: { value: T; label: string; icon?: () => Node; title?: string }[];
  get(state: State): T;
  set(value: T): Partial<State>;
  when?(state: State): boolean;
}

/** A few choices side by side. */
export function segments<T extends string>(options: ChoiceOptions<T>, change: Change): Control {
  const name = freshId();
  const inputs = new Map<T, HTMLInputElement>();
  const parts = options.choices.map(({ value, label, icon, title }) => {
    const input = h('input', { type: 'radio', name, value, onchange: () => change(options.set(value)) });
    inputs.set(value, input);
    return h('label', { title: title ?? label }, input, h('span', {}, icon?.(), h('span', { className: 'word' }, label)));
  });
  const element = h(
    'fieldset',
    { className: 'segments', title: options.title },
    h('legend', {}, options.label),
    h('div', { className: 'row' }, ...parts),
  );
  return {
    element,
    update: (state) => {
      const input = inputs.get(options.get(state));
      if (input) input.checked = true;
      else for (const other of inputs.values()) other.checked = false;
      element.hidden = options.when ? !options.when(state) : false;
    },
  };
}

/** Many choices in a list. */
export function list<T extends string>(options: ChoiceOptions<T>, change: Change): Control {
  const id = freshId();
  const select = h(
    'select',
    { id, onchange: () => change(options.set(select.value as T)) },
    ...options.choices.map(({ value, label }) => h('option', { value }, label)),
  );
  const element = h('div', { className: 'control list', title: options.title }, h('label', { htmlFor: id }, options.label), select);
  return {
    element,
    update: (state) => {
      select.value = options.get(state);
      element.hidden = options.when ? !options.when(state) : false;
    },
  };
}

interface ToggleOptions {
  label: string;
  title: string;
  get(state: State): boolean;
  set(value: boolean): Partial<State>;
  when?(state: State): boolean;
}

export function toggle(options: ToggleOptions, change: Change): Control {
  const input = h('input', { type: 'checkbox', onchange: () => change(options.set(input.checked)) });
  const element = h('label', { className: 'toggle', title: options.title }, input, h('span', {}, options.label));
  return {
    element,
    update: (state) => {
      input.checked = options.get(state);
      element.hidden = options.when ? !options.when(state) : false;
    },
  };
}

export function section(title: string, open: boolean, ...children: Node[]): HTMLElement {
  return h('details', { open, className: 'section' }, h('summary', {}, h('h2', {}, title)), h('div', { className: 'body' }, ...children));
}

export function button(label: string, title: string, onclick: () => void, className = ''): HTMLButtonElement {
  return h('button', { type: 'button', title, onclick, className }, label);
}
