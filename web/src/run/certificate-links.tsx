import { language } from '../session/settings';
import { addressOf } from '../ui/client';
import { words } from '../words';

/** The certificate of a run, as a page and as data, and that it is not accepted yet. */
export function CertificateLinks({ run, accepted }: { run: string; accepted: boolean }) {
  const said = words.value.result;
  return (
    <>
      <p class="downloads">
        <a
          class="download"
          href={addressOf('/api/runs/{run}/certificate.pdf', { run }, { language: language.value })}
          download
        >
          {said.certificate}
        </a>
        <a class="download" href={addressOf('/api/runs/{run}/certificate', { run })} download>
          {said.certificateData}
        </a>
      </p>
      {!accepted && <p class="hint">{said.certificateOpen}</p>}
    </>
  );
}
