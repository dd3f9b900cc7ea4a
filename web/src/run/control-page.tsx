import { may, session } from '../session/session';
import { Facts } from '../ui/facts';
import { say } from '../ui/notice';
import { Press } from '../ui/press';
import type { Screen } from '../ui/screen';
import { moment } from '../ui/units';
import { words } from '../words';
import { control, giveControlBack, holder, mine, takeControl } from './control';
import { device, LONGEST } from './control-device';
import { OthersAsk } from './control-request';
import { LinkFigures } from './link-figures';
import { current } from './run';

/** Who is in control of the chosen cell, since when, on which screen; what this screen is called. */
function ControlPage() {
  const said = words.value.handover;
  const known = control.value;
  return (
    <div class="page control-page">
      <h1>{said.title}</h1>
      <section class="tile">
        <Facts
          facts={[
            { name: said.who, value: whoHasIt() },
            { name: said.screen, value: screenOf() },
            { name: said.since, value: known?.since ? moment(known.since) : '–' },
          ]}
        />
        <OthersAsk />
        <p class="hint">{said.hint}</p>
      </section>
      <LinkFigures />
      <section>
        <label class="field">
          <span>{said.named}</span>
          <input
            value={device.value}
            maxLength={LONGEST}
            autocomplete="off"
            onInput={({ currentTarget }) => {
              device.value = currentTarget.value.trim();
            }}
          />
          <small class="hint">{said.namedHint}</small>
        </label>
      </section>
    </div>
  );
}

function whoHasIt(): string {
  const said = words.value.handover;
  if (mine.value) return said.you(session.value?.name ?? '');
  return control.value === null ? words.value.unknown : (holder.value ?? said.nobody);
}

function screenOf(): string {
  const known = control.value;
  return known?.holder == null ? '–' : known.device || words.value.handover.unnamed;
}

function Actions() {
  const said = words.value.handover;
  const known = control.value;
  if (known === null || !may('operator')) return null;
  if (mine.value) {
    const holds = current.value?.state === 'Execute' && known.request === null;
    return (
      <Press kind="primary" act={release}>
        <span>
          {said.release}
          {holds && <small class="consequence">{said.releaseHolds}</small>}
        </span>
      </Press>
    );
  }
  return holder.value === null ? (
    <Press kind="primary" act={() => takeControl(known.cell)}>
      {said.take}
    </Press>
  ) : null;
}

async function release(): Promise<void> {
  await giveControlBack();
  say(() => words.value.handover.told.released, 'passes');
}

function next(): string {
  const said = words.value.handover.next;
  if (!may('operator')) return said.watch;
  return mine.value ? said.mine : holder.value === null ? said.free : said.others;
}

export const controlScreen: Screen = { Page: ControlPage, Actions, next };
