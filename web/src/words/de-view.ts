import type { Words } from './en';

export const view: Words['view'] = {
  from: 'Ansicht',
  looks: { front: 'Vorn', top: 'Oben', operator: 'Bediener', fit: 'Einpassen', reset: 'Zurücksetzen' },
  path: 'Geplante Bahn',
  play: 'Abspielen',
  pause: 'Anhalten',
  of: (whole) => `von ${whole} Bewegung`,
};
