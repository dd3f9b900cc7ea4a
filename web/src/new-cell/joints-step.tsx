import type { DraftJoint } from '../api';
import { MessageText } from '../ui/message-text';
import { scaleOf } from '../ui/units';
import type { Message } from '../words/catalogue';
import { edits, made } from './draft';
import { newCellWords } from './new-cell-words';
import { notesOf, Said } from './said';
import { ValueField } from './value-field';

/** The limits of every joint and the masses that nobody states, each with why it was taken. */
export function JointsStep() {
  const said = newCellWords.value.joints;
  const { joints = [], links = [] } = made.value ?? {};
  const { factor, unit } = scaleOf('mass');
  const guessed = links.filter(
    ({ name }) => notesOf('link', name).some(isOfMass) || edits.value[`mass.${name}`] !== undefined,
  );
  return (
    <>
      {joints.map((joint) => (
        <Joint key={joint.name} joint={joint} />
      ))}
      {guessed.length > 0 && (
        <section class="tile stack">
          <h3>{said.masses}</h3>
          {guessed.map(({ name, mass_kg }) => (
            <div key={name}>
              <ValueField
                name={`mass.${name}`}
                label={said.mass(name, unit)}
                value={mass_kg}
                factor={factor}
                places={3}
              />
              <Reasons notes={notesOf('link', name).filter(isOfMass)} />
            </div>
          ))}
        </section>
      )}
      <details class="others">
        <summary>{said.friction}</summary>
        {joints.map(({ name }, k) => (
          <fieldset key={name}>
            <legend>{name}</legend>
            <div class="two">
              <ValueField
                name={`friction.${name}.coulomb`}
                label={said.coulomb}
                value={made.value?.cell.robot.friction?.coulomb_n_m[k]}
              />
              <ValueField
                name={`friction.${name}.viscous`}
                label={said.viscous}
                value={made.value?.cell.robot.friction?.viscous_n_m_s[k]}
              />
            </div>
          </fieldset>
        ))}
      </details>
      <Said step="joints" />
    </>
  );
}

const isOfMass = ({ parameters }: Message) => parameters?.mass_kg !== undefined;

function Joint({ joint }: { joint: DraftJoint }) {
  const said = newCellWords.value.joints;
  const { name } = joint;
  const fields = [
    ['lower_rad', said.lower],
    ['upper_rad', said.upper],
    ['velocity_rad_s', said.velocity],
    ['effort_n_m', said.effort],
    ['acceleration_rad_s2', said.acceleration],
  ] as const;
  return (
    <section class="tile joint">
      <h3>{name}</h3>
      <div class="five">
        {fields.map(([key, label]) => (
          <ValueField key={key} name={`joint.${name}.${key}`} label={label} value={joint[key]} />
        ))}
      </div>
      <Reasons notes={notesOf('joint', name)} />
    </section>
  );
}

function Reasons({ notes }: { notes: Message[] }) {
  return notes.map((note) => (
    <p class="reason" key={note.code}>
      <span aria-hidden="true">?</span> <MessageText message={note} />
    </p>
  ));
}
