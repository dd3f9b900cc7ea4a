import { mayTour, startTour } from '../help/tour';
import { Choice } from '../ui/choice';
import { Press } from '../ui/press';
import { to } from '../ui/route';
import type { Screen } from '../ui/screen';
import { words } from '../words';
import { LANGUAGES, nameOf } from '../words/languages';
import { session } from './session';
import { language, THEMES, theme, UNITS, units } from './settings';
import { signOut } from './signing-in';

function Settings() {
  const all = words.value;
  return (
    <div class="page settings">
      <h1>{all.settings.title}</h1>
      <Choice
        legend={all.settings.language}
        options={LANGUAGES.map((value) => ({ value, label: nameOf(value) }))}
        chosen={language.value}
        choose={(value) => {
          language.value = value;
        }}
      />
      <Choice
        legend={all.settings.units}
        options={UNITS.map((value) => ({ value, label: all.units[value] }))}
        chosen={units.value}
        choose={(value) => {
          units.value = value;
        }}
      />
      <Choice
        legend={all.settings.theme}
        options={THEMES.map((value) => ({ value, label: all.themes[value] }))}
        chosen={theme.value}
        choose={(value) => {
          theme.value = value;
        }}
      />
      <section>
        <h2>{all.settings.account}</h2>
        <p>
          {session.value?.name} · {session.value?.roles.map((role) => all.roles[role]).join(', ')}
        </p>
        <div class="row">
          <a class="press" href={to('admin', 'account')}>
            {all.settings.ownAccount}
          </a>
          <Press disabled={!mayTour.value} act={startTour}>
            {all.help.take}
          </Press>
          <Press act={signOut}>{all.signIn.out}</Press>
        </div>
      </section>
    </div>
  );
}

export const settings: Screen = { Page: Settings, next: () => words.value.settings.next };
