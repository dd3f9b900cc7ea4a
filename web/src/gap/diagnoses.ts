import { computed, effect, signal } from '@preact/signals';
import type { DiagnosisPublic, OverlayPublic } from '../api';
import { ask } from '../ui/client';
import { until } from '../ui/connection';
import { jobsOf } from '../ui/jobs';

/** So many of the newest are listed. */
const LISTED = 6;

/** Diagnoses, and the one that is looked at. */
export const { listed: diagnoses, shown: diagnosis } = jobsOf<DiagnosisPublic>(
  'gap',
  () => ask('GET /api/diagnoses', { query: { limit: LISTED } }),
  (id) => ask('GET /api/diagnoses/{diagnosis}', { path: { diagnosis: id } }),
);
/** What it compared; null where there was too little, or it is not done. */
export const overlay = signal<OverlayPublic | null>(null);

export async function diagnoseRun(run: string): Promise<DiagnosisPublic> {
  return ask('POST /api/diagnoses', { body: { run } });
}

/** Diagnoses a recording folder as a zip, under a name; `cell` is where it was made, null where that is none of ours. */
export async function diagnoseUpload(
  zip: Blob,
  cell: string | null,
  name: string | null,
): Promise<DiagnosisPublic> {
  return ask('POST /api/diagnoses/uploads', { zip, query: { cell, name } });
}

export async function cancelDiagnosis(id: string): Promise<void> {
  diagnosis.value = await ask('DELETE /api/diagnoses/{diagnosis}', { path: { diagnosis: id } });
}

async function readOverlay(id: string): Promise<void> {
  const found = await ask('GET /api/diagnoses/{diagnosis}/overlay', { path: { diagnosis: id } });
  if (compared.value === id) overlay.value = found;
}

const compared = computed(() => (diagnosis.value?.result?.gap ? diagnosis.value.diagnosis : null));
effect(() => {
  const id = compared.value;
  overlay.value = null;
  return id !== null ? until(() => readOverlay(id)) : undefined;
});
