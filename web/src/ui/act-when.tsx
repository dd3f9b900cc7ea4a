import { Press } from './press';

interface Props {
  /** Why it cannot be done yet; null where it can. */
  lacking: string | null;
  act: () => Promise<void>;
  children: string;
}

/** A form's button; while it cannot be pressed it says what is missing. */
export function ActWhen({ lacking, act, children }: Props) {
  return (
    <div class="row">
      <Press act={act} disabled={lacking !== null}>
        {children}
      </Press>
      {lacking && <span class="hint">{lacking}</span>}
    </div>
  );
}
