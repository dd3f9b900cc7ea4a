import { signal } from '@preact/signals';
import type { LiveBatch } from '../api';

const WRENCH_S = 12;
const ESTIMATE_EVERY_S = 0.25;
const UNKNOWN = Array<null>(6).fill(null);

/** One moment: time (s), then measured and reconstructed fx fy fz (N) tx ty tz (N m). */
export type WrenchRow = { t_s: number; measured: number[]; reconstructed: (number | null)[] };
/** The mass as it was estimated at one moment, kg. */
export type MassRow = { t_s: number; mass_kg: number; std_kg: number };

/** The wrench of the last seconds. */
export const wrenchTrace = signal<WrenchRow[]>([]);
/** The estimate of the mass since this screen looks on. */
export const massTrace = signal<MassRow[]>([]);

export function clearTraces(): void {
  wrenchTrace.value = [];
  massTrace.value = [];
}

/** Takes the last sample of each batch; samples from before the newest known begin a new trace. */
export function trace(batches: LiveBatch[]): void {
  const rows = batches.flatMap(rowOf);
  const newest_s = rows.at(-1)?.t_s ?? 0;
  if (newest_s < (wrenchTrace.value.at(-1)?.t_s ?? 0)) clearTraces();
  wrenchTrace.value = [...wrenchTrace.value, ...rows].filter((each) => each.t_s > newest_s - WRENCH_S);
  const mass = massOf(batches.at(-1));
  if (
    mass === null ||
    mass.t_s < (massTrace.value.at(-1)?.t_s ?? Number.NEGATIVE_INFINITY) + ESTIMATE_EVERY_S
  )
    return;
  massTrace.value = [...massTrace.value, mass];
}

function rowOf(batch: LiveBatch): WrenchRow[] {
  const t_s = batch.t_s.at(-1);
  const measured = batch.wrench.at(-1);
  if (t_s === undefined || measured === undefined) return [];
  return [{ t_s, measured, reconstructed: batch.reconstructed ?? UNKNOWN }];
}

function massOf(batch: LiveBatch | undefined): MassRow | null {
  const t_s = batch?.t_s.at(-1);
  const mass_kg = batch?.phi[0];
  const std_kg = batch?.phi_std[0];
  return t_s === undefined || mass_kg == null || std_kg == null ? null : { t_s, mass_kg, std_kg };
}
