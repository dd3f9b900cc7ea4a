import type { RobotOutline } from '../api';
import { Choice } from '../ui/choice';
import { NumberField } from '../ui/number-field';
import { Select } from '../ui/select';
import { TextField } from '../ui/text-field';
import { scaleOf, typed } from '../ui/units';
import { frames, isTaken, outline } from './draft';
import { type Frames, linksAbove, linksBehind, NAME } from './frames';
import { newCellWords } from './new-cell-words';
import { Said } from './said';

interface Props {
  arm: Frames;
  robot: RobotOutline;
  change: (part: Partial<Frames>) => void;
}

/** What the cell is called, where the arm begins, where the sensor sits, and what hangs behind it. */
export function ArmStep() {
  const [arm, robot] = [frames.value, outline.value];
  if (arm === null || robot === null) return null;
  const change = (part: Partial<Frames>) => {
    frames.value = { ...arm, ...part };
  };
  const parts = { arm, robot, change };
  return (
    <>
      <Names {...parts} />
      <SensorFrame {...parts} />
      <Base {...parts} />
      <Behind {...parts} />
      <Said step="arm" />
    </>
  );
}

function Names({ arm, change }: Props) {
  const said = newCellWords.value.arm;
  const flaw = NAME.test(arm.name) ? (isTaken(arm.name) ? said.taken : null) : said.badName;
  return (
    <>
      <TextField
        label={said.name}
        hint={said.nameHint}
        flaw={flaw}
        text={arm.name}
        change={(name) => change({ name })}
      />
      <TextField label={said.cellTitle} text={arm.title} change={(title) => change({ title })} />
    </>
  );
}

function SensorFrame({ arm, robot, change }: Props) {
  const said = newCellWords.value.arm;
  const links = robot.links.filter(({ parent }) => parent !== null).map(({ name }) => name);
  return (
    <fieldset class="stack">
      <Choice
        legend={said.sensor}
        options={[
          { value: 'link', label: said.atLink },
          { value: 'mount', label: said.mounted },
        ]}
        chosen={arm.kind}
        choose={(kind) => change({ kind, behind: null })}
      />
      <Select
        label={arm.kind === 'link' ? said.link : said.flange}
        options={links.map((name) => [name, name])}
        chosen={arm.sensor}
        choose={(sensor) => {
          const above = linksAbove(robot, sensor);
          change({ sensor, behind: null, base: above.includes(arm.base) ? arm.base : (above.at(-1) ?? '') });
        }}
      />
      {arm.kind === 'mount' && (
        <>
          <Triple
            legend={said.offset(scaleOf('length').unit)}
            texts={arm.offset}
            change={(offset) => change({ offset })}
          />
          <Triple legend={said.turn} texts={arm.turn} change={(turn) => change({ turn })} />
        </>
      )}
    </fieldset>
  );
}

type Texts = [string, string, string];

function Triple({ legend, texts, change }: { legend: string; texts: Texts; change: (texts: Texts) => void }) {
  return (
    <fieldset>
      <legend>{legend}</legend>
      <div class="three">
        {['x', 'y', 'z'].map((axis, k) => (
          <NumberField
            key={axis}
            label={axis}
            signed
            text={texts[k] ?? ''}
            flaw={typed(texts[k] ?? '') === null}
            change={(text) => change(texts.with(k, text) as Texts)}
          />
        ))}
      </div>
    </fieldset>
  );
}

function Base({ arm, robot, change }: Props) {
  const said = newCellWords.value.arm;
  const above = linksAbove(robot, arm.sensor);
  return (
    <Select
      label={said.base}
      options={above.map((name) => [name, name])}
      chosen={arm.base}
      choose={(base) => change({ base })}
    />
  );
}

/** What only a person knows of links behind the sensor's frame. */
function Behind({ arm, robot, change }: Props) {
  const said = newCellWords.value.arm;
  const links = linksBehind(robot, arm);
  if (links.length === 0) return null;
  return (
    <Choice
      legend={said.behind(links.join(', '))}
      options={[
        { value: 'tool', label: said.tool, note: said.toolHint },
        { value: 'robot', label: said.robot, note: said.robotHint },
      ]}
      chosen={arm.behind ?? ''}
      choose={(behind) => change({ behind })}
    />
  );
}
