import { words } from '../words';
import { dismiss, messageOf, notice, remarks } from './notice';
import { Press } from './press';
import { Told } from './told';

/** What went wrong last, until it is closed or something else is asked for; what was told, until it passes or is closed. */
export function NoticeList() {
  return (
    <>
      {notice.value && (
        <div class="notice" role="alert">
          <span aria-hidden="true">▲</span>
          <Told message={messageOf(notice.value)} />
          <Press
            act={() => {
              notice.value = null;
            }}
          >
            {words.value.close}
          </Press>
        </div>
      )}
      {remarks.value.map(({ id, text, kind }) => (
        <div key={id} class="notice remark" role="status">
          <span aria-hidden="true">{kind === 'passes' ? '✓' : 'ℹ'}</span>
          <p class="told">{text()}</p>
          <Press act={() => dismiss(id)}>{words.value.close}</Press>
        </div>
      ))}
    </>
  );
}
