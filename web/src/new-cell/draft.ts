import { computed, signal } from '@preact/signals';
import type { DraftCellPublic, DraftPublic, Flaw, paths, RobotOutline } from '../api';
import { cells, readCells } from '../cells/cells';
import { language } from '../session/settings';
import { addressOf, ask, PLAIN_FILE } from '../ui/client';
import { type Notice, noticeOf } from '../ui/notice';
import { Refusal } from '../ui/refusal';
import { NARROW_SPACE, number, typed } from '../ui/units';
import { armOf, type Frames, framesFit } from './frames';
import { valuesOf } from './values';

/** The console's languages are files of its own; the service knows its own as well. */
type ServerLanguage = NonNullable<
  NonNullable<paths['/api/drafts/{draft}/cell']['put']['parameters']['query']>['language']
>;

export const STEPS = ['description', 'arm', 'joints', 'home', 'sensor', 'room', 'check'] as const;
export type Step = (typeof STEPS)[number];

/** Making takes seconds, on a busy machine many. */
const PATIENCE_MS = 120_000;

/** The step that is shown. */
export const step = signal<Step>('description');
/** The draft that the service keeps; null before a file was chosen. */
export const draft = signal<DraftPublic | null>(null);
/** The file that was chosen last, while it is read. */
export const fileName = signal('');
/** Which of the files describes the robot, and the arguments of a xacro file. */
export const description = signal<{ file: string; arguments: Record<string, string> }>({
  file: '',
  arguments: {},
});
/** What the robot is made of; null until it was read. */
export const outline = signal<RobotOutline | null>(null);
export const frames = signal<Frames | null>(null);
/** The cell as it was made last; null before. */
export const made = signal<DraftCellPublic | null>(null);
/** What somebody has typed, by the name of the value; what is absent is as it was made. */
export const edits = signal<Record<string, string>>({});
/** Pairs of links that somebody wants left out; null for those that are proposed. */
export const leftOut = signal<[string, string][] | null>(null);
/** Why the last attempt came to nothing. */
export const refused = signal<{ flaws: Flaw[]; notice: Notice | null } | null>(null);
export const working = signal(false);
/** Counts what was made, so that its picture is asked for anew. */
const pictures = signal(0);

/** Where the picture of the home is; null before there is one. */
export const picture = computed(() =>
  draft.value === null || pictures.value === 0
    ? null
    : `${addressOf('/api/drafts/{draft}/picture', { draft: draft.value.draft })}?made=${pictures.value}`,
);

/** Begins with a file. */
export async function sendFile(file: File): Promise<void> {
  const isZip = file.name.toLowerCase().endsWith('.zip');
  fileName.value = file.name;
  await attempted(async () => {
    const zip = isZip ? file : new Blob([file], { type: PLAIN_FILE });
    const query = isZip ? {} : { name: plainName(file.name) };
    const before = draft.value;
    draft.value = await ask('POST /api/drafts', { zip, query });
    if (before) void leave(before.draft);
    outline.value = null;
    frames.value = null;
    made.value = null;
    edits.value = {};
    leftOut.value = null;
    pictures.value = 0;
    description.value = { file: draft.value.descriptions[0]?.file ?? '', arguments: {} };
  });
}

const plainName = (name: string) => name.replace(/[^A-Za-z0-9_.-]+/g, '_').slice(-64);

/** Reads the chosen description, and proposes an arm. */
async function readRobot(): Promise<void> {
  const path = { draft: draft.value?.draft ?? '' };
  const { file, arguments: all } = description.value;
  const given = Object.fromEntries(Object.entries(all).filter(([, text]) => text !== ''));
  const read = await ask('POST /api/drafts/{draft}/robot', {
    path,
    body: { file, arguments: given },
    patience_ms: PATIENCE_MS,
  });
  if (JSON.stringify(read) !== JSON.stringify(outline.value)) {
    outline.value = read;
    frames.value = armOf(read);
    edits.value = {};
    leftOut.value = null;
  }
}

/** Has the cell made with all that is known of it. */
async function make(): Promise<void> {
  const [arm, before] = [frames.value, made.value];
  if (draft.value === null || arm === null) return;
  const values = { ...valuesOf(arm.title, edits.value, before), adjacent: leftOut.value };
  const body = { ...framesFit(arm, outline.value), values };
  const path = { draft: draft.value.draft };
  try {
    const query = { language: language.value as ServerLanguage };
    made.value = await ask('PUT /api/drafts/{draft}/cell', { path, query, body, patience_ms: PATIENCE_MS });
  } finally {
    pictures.value += 1;
  }
}

/** Makes the cell with what is typed, and draws it. */
export const remake = () => attempted(make);

/** Goes on to the next step, once what this one says could be used. */
export async function goOn(): Promise<void> {
  await attempted(async () => {
    if (step.value === 'description') await readRobot();
    else await make();
    step.value = STEPS[STEPS.indexOf(step.value) + 1] ?? 'check';
  });
}

export function goBack(): void {
  refused.value = null;
  step.value = STEPS[STEPS.indexOf(step.value) - 1] ?? 'description';
}

/** Whether a step can be gone to: those before, and those behind once the cell was made. */
export function isOpen(wanted: Step): boolean {
  if (wanted === 'description') return true;
  return wanted === 'arm' ? outline.value !== null : made.value !== null;
}

/** Imports the cell; null where it was refused. */
export async function importDraft(): Promise<string | null> {
  let name: string | null = null;
  await attempted(async () => {
    await make();
    const path = { draft: draft.value?.draft ?? '' };
    const body = { name: frames.value?.name ?? '' };
    name = (await ask('POST /api/drafts/{draft}/import', { path, body, patience_ms: PATIENCE_MS })).name;
    forget();
    await readCells();
  });
  return name;
}

/** Leaves the new cell; nothing of it stays. */
export async function discard(): Promise<void> {
  const before = draft.value;
  forget();
  if (before) await leave(before.draft);
}

async function leave(name: string): Promise<void> {
  await ask('DELETE /api/drafts/{draft}', { path: { draft: name } }).catch((error) => {
    if (!(error instanceof Refusal)) throw error; // it has gone by itself
  });
}

function forget(): void {
  draft.value = null;
  outline.value = null;
  frames.value = null;
  made.value = null;
  edits.value = {};
  leftOut.value = null;
  refused.value = null;
  fileName.value = '';
  pictures.value = 0;
  step.value = 'description';
}

/** Does something that the service may refuse; why it did stands on the page. */
async function attempted(act: () => Promise<void>): Promise<void> {
  if (working.value) return;
  working.value = true;
  refused.value = null;
  try {
    await act();
  } catch (error) {
    const flaws = error instanceof Refusal ? (error.problem.flaws ?? []) : [];
    refused.value = { flaws, notice: flaws.length > 0 ? null : noticeOf(error) };
  } finally {
    working.value = false;
  }
}

/** Types over a value. */
export function edit(name: string, text: string): void {
  edits.value = { ...edits.value, [name]: text };
}

/** A value as it stands in its field: as it was typed, else as it was made. */
export function textOf(name: string, value: number | null | undefined, factor = 1, places = 4): string {
  const written = edits.value[name];
  if (written !== undefined) return written;
  if (value == null) return '';
  const [whole = '', decimals = ''] = number(factor * value, places)
    .replaceAll(NARROW_SPACE, '')
    .split(/(?=[.,])/);
  const kept = decimals.replace(/0+$/, '');
  return kept.length > 1 ? whole + kept : whole;
}

/** Whether what was typed for a value cannot be read. */
export const isUnread = (name: string): boolean => {
  const text = edits.value[name]?.trim() ?? '';
  return text !== '' && typed(text) === null;
};

/** Texts among the values, which need no number. */
const TEXTS = new Set(['sensor.name']);

/** Whether anything that was typed cannot be read. */
export const hasUnread = computed(() =>
  Object.keys(edits.value).some((name) => !TEXTS.has(name) && isUnread(name)),
);

/** Whether a cell has that name already. */
export const isTaken = (name: string) => (cells.value ?? []).some((each) => each.name === name);
