import '../look/admin.css';
import { session } from '../session/session';
import { notThere } from '../ui/not-there-page';
import { go, route, to } from '../ui/route';
import type { Screen } from '../ui/screen';
import { Select } from '../ui/select';
import { adminWords } from './admin-words';
import { namesOf } from './roles';
import { isOpen, isSection, SECTIONS, type SectionName } from './sections';

function Administration() {
  const said = adminWords.value;
  const here = sectionHere();
  if (here === null) return null;
  const open = (Object.keys(SECTIONS) as SectionName[]).filter(isOpen);
  const { Section } = SECTIONS[here];
  return (
    <div class="page admin">
      {open.length > 1 && (
        <div class="admin-sections-narrow">
          <Select
            label={said.section}
            options={open.map((name): [string, string] => [name, said.sections[name]])}
            chosen={here}
            choose={(name) => go('admin', name)}
          />
        </div>
      )}
      {open.length > 1 && (
        <nav class="admin-sections" aria-label={said.title}>
          {open.map((name) => (
            <a key={name} href={to('admin', name)} aria-current={name === here ? 'page' : undefined}>
              {said.sections[name]}
            </a>
          ))}
        </nav>
      )}
      <h1>{said.sections[here]}</h1>
      {isOpen(here) ? <Section key={here} /> : <Closed name={here} />}
    </div>
  );
}

/** Somebody came by an address of a section that is not theirs. */
function Closed({ name }: { name: SectionName }) {
  const said = adminWords.value;
  const engineers = SECTIONS[name].roles.includes('engineer');
  return (
    <>
      <p>{engineers ? said.closedEngineers : said.closed}</p>
      <p class="hint">{said.yourRoles(namesOf(session.value?.roles ?? []))}</p>
    </>
  );
}

/** The section that the address names; the first one where it names none, null where there is none of that name. */
function sectionHere(): SectionName | null {
  const [, name = 'account', more] = route.value;
  return isSection(name) && more === undefined ? name : null;
}

const page: Screen = {
  Page: Administration,
  next: () => {
    const here = sectionHere();
    const said = adminWords.value.next;
    return here !== null && isOpen(here) ? said[here] : said.closed;
  },
};

/** What the address names. */
export const screenHere = (): Screen => (sectionHere() === null ? notThere : page);
