import { words } from '../words';
import { type Quantity, shown } from './units';

interface Props {
  quantity: Quantity;
  /** SI; null where it is not determined. */
  value: number | null | undefined;
  std?: number | null | undefined;
  /** Why it is not determined. */
  reason?: string | undefined;
}

/** A number with its interval and its unit, or why there is none. */
export function Measured({ quantity, value, std = null, reason }: Props) {
  if (value == null) return <span class="measured undetermined">{reason ?? words.value.notDetermined}</span>;
  const found = shown(quantity, value, std);
  return (
    <span class="measured">
      <b>{found.value}</b>
      {found.half !== null && <i>± {found.half}</i>}
      <small>{found.unit}</small>
    </span>
  );
}
