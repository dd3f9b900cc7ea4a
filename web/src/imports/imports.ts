import { computed, signal } from '@preact/signals';
import type { DiagnosisPublic, Flaw, ImportPublic } from '../api';
import { cells, chosenCell } from '../cells/cells';
import { ask, send } from '../ui/client';
import { type Notice, noticeOf } from '../ui/notice';
import { Refusal } from '../ui/refusal';

/** Reading has two minutes of the processor, and on a busy machine more of the clock. */
const PATIENCE_MS = 600_000;
const ASK_MS = 700;
/** Of a name. */
export const MOST_LETTERS = 120;

/** The import that the service keeps; null before a file was chosen. */
export const log = signal<ImportPublic | null>(null);
/** A log of the same arm without the payload, put aside to be compared with; null where none is. */
export const armAlone = signal<ImportPublic | null>(null);
/** The file that is on its way, and what share of it has gone; null while none is. */
export const sending = signal<{ file: string; share: number } | null>(null);
/** What share of the reading is done; null while nothing is read. */
export const reading = signal<number | null>(null);
/** Whether its payload is being identified. */
export const identifying = signal(false);
/** Why the last attempt came to nothing. */
export const refused = signal<{ flaws: Flaw[]; notice: Notice | null } | null>(null);
/** Where it was made: the name of a cell, or nothing where that is none of ours. */
export const madeIn = signal('');
/** What to call it. */
export const name = signal('');

export const working = computed(() => sending.value !== null || reading.value !== null || identifying.value);
export const understood = computed(() => log.value?.reading?.understood ?? null);
/** Whether a recording was made of it. */
export const sound = computed(() => understood.value !== null && log.value?.reading?.contradiction === null);

const pathOf = ({ log_import }: ImportPublic) => ({ log_import });

/** Sends files one after the other, and has the log read. */
export async function sendFiles(files: readonly File[]): Promise<void> {
  if (files.length === 0) return;
  await attempted(async () => {
    log.value ??= await ask('POST /api/imports');
    for (const file of files) {
      sending.value = { file: file.name, share: 0 };
      if (name.value === '') name.value = file.name.replace(/\.[a-z0-9.]+$/i, '').slice(0, MOST_LETTERS);
      const path: { log_import: string; file: string } = { ...pathOf(log.value), file: file.name };
      log.value = await send('PUT /api/imports/{log_import}/files/{file}', { path }, file, (share) => {
        sending.value = { file: file.name, share };
      });
    }
    sending.value = null;
    await readLog({});
  });
}

/** Takes a file away, and has the rest read where there is any. */
export async function removeFile(file: string): Promise<void> {
  const before = log.value;
  if (before === null) return;
  await attempted(async () => {
    const path = { ...pathOf(before), file };
    log.value = await ask('DELETE /api/imports/{log_import}/files/{file}', { path });
    if (log.value.files.length === 0) await forget();
    else if (log.value.files.some(({ kind }) => kind === 'log')) await readLog(before.answers);
  });
}

/** Answers a question, or changes what was understood; all that was answered before still holds. */
export const answer = (key: string, value: string) => answerAll({ [key]: value });

export async function answerAll(given: Record<string, string>): Promise<void> {
  const before = log.value?.answers ?? {};
  await attempted(async () => {
    try {
      await readLog({ ...before, ...given });
    } catch (error) {
      await readLog(before).catch(() => undefined); // what was understood stays, beside why it cannot be otherwise
      throw error;
    }
  });
}

/** Says where it was made; the robot of a cell gives its joints a meaning. */
export async function chooseCell(cell: string): Promise<void> {
  madeIn.value = cell;
  if (log.value?.files.length) await answerAll({});
}

async function readLog(answers: Record<string, string>): Promise<void> {
  const before = log.value;
  if (before === null) return;
  reading.value = 0;
  const timer = window.setInterval(() => void follow(before), ASK_MS);
  try {
    const body = { answers, cell: madeIn.value || null };
    log.value = await ask('PUT /api/imports/{log_import}/reading', {
      path: pathOf(before),
      body,
      patience_ms: PATIENCE_MS,
    });
  } catch (error) {
    log.value = { ...before, reading: null, identified: null };
    throw error;
  } finally {
    window.clearInterval(timer);
    reading.value = null;
  }
}

/** How far the reading is; what does not get through is asked again. */
async function follow(before: ImportPublic): Promise<void> {
  const found = await ask('GET /api/imports/{log_import}', { path: pathOf(before) }).catch(() => null);
  if (reading.value !== null && found?.progress != null) reading.value = found.progress;
}

/** Keeps the log as the one without the payload; the next is the one with it. */
export function putAside(): void {
  armAlone.value = log.value;
  clear();
}

/** The log without the payload is no longer compared with; nothing of it stays. */
export async function dropArmAlone(): Promise<void> {
  const before = armAlone.value;
  armAlone.value = null;
  if (before !== null) await remove(before);
}

/** Has the payload identified from the recording that was made of it, beside that of the arm alone; both imports stay. */
export async function identify(): Promise<void> {
  const before = log.value;
  if (before === null) return;
  await attempted(async () => {
    identifying.value = true;
    log.value = await ask('POST /api/imports/{log_import}/identification', {
      path: pathOf(before),
      body: { without: armAlone.value?.log_import ?? null },
      patience_ms: PATIENCE_MS,
    });
  });
}

/** Has the recording that was made of it diagnosed; it is the service's then. */
export async function diagnose(): Promise<DiagnosisPublic | null> {
  const before = log.value;
  if (before === null) return null;
  const body = { name: name.value.trim() || null };
  const queued = await ask('POST /api/imports/{log_import}/diagnosis', { path: pathOf(before), body });
  clear();
  return queued;
}

/** Leaves it; nothing of it stays. */
export async function forget(): Promise<void> {
  const before = log.value;
  clear();
  if (before !== null) await remove(before);
}

async function remove(left: ImportPublic): Promise<void> {
  await ask('DELETE /api/imports/{log_import}', { path: pathOf(left) }).catch((error) => {
    if (!(error instanceof Refusal)) throw error; // it has gone by itself
  });
}

function clear(): void {
  log.value = null;
  refused.value = null;
  name.value = '';
}

/** Does something that the service may refuse; why it did stands on the page. */
async function attempted(act: () => Promise<void>): Promise<void> {
  if (working.value) return;
  refused.value = null;
  try {
    await act();
  } catch (error) {
    const flaws = error instanceof Refusal ? (error.problem.flaws ?? []) : [];
    refused.value = { flaws, notice: flaws.length > 0 ? null : noticeOf(error) };
    if (error instanceof Refusal && error.said.code === 'imports-unknown')
      forgetGone(error.said.parameters?.log_import);
  } finally {
    sending.value = null;
    identifying.value = false;
  }
}

/** The service has no import of that name any more. */
function forgetGone(gone: unknown): void {
  for (const each of [log, armAlone]) if (each.value?.log_import === gone) each.value = null;
}

/** Names of the cells, the one that is worked in first. */
export const cellNames = computed(() =>
  [chosenCell.value, ...(cells.value ?? []).map((each) => each.name)].filter(
    (each, k, all) => each && all.indexOf(each) === k,
  ),
);
