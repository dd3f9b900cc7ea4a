import type { LogLine, LogPreview } from '../api';
import { nameFile } from '../ui/file-name';
import { type Line, Plot } from '../ui/plot';
import { scaleOf } from '../ui/units';
import { words } from '../words';
import { importWords } from './import-words';
import { name } from './imports';

const AXES = ['--series-x', '--series-y', '--series-z'];
/** A robot has more joints than there are colours: those behind are dashed. */
const DEGREES = 180 / Math.PI;

/** The wrench or the torques of the joints, and below them the joints or where gravity points. */
export function LogLook({ preview }: { preview: LogPreview }) {
  const said = importWords.value;
  const running = words.value.running;
  const { t_s, force_n, torque_n_m, joint_torques_n_m, joints_rad, down } = preview;
  const [force, torque] = [scaleOf('force'), scaleOf('torque')];
  return (
    <section class="stack log-look">
      <h2>{said.look}</h2>
      <Lines
        title={`${running.force}, ${force.unit}`}
        t_s={t_s}
        lines={force_n}
        factor={force.factor}
        unit={force.unit}
        file="force"
      />
      <Lines
        title={`${running.torque}, ${torque.unit}`}
        t_s={t_s}
        lines={torque_n_m}
        factor={torque.factor}
        unit={torque.unit}
        file="torque"
      />
      <Lines
        title={`${said.jointTorques}, ${torque.unit}`}
        t_s={t_s}
        lines={joint_torques_n_m}
        factor={torque.factor}
        unit={torque.unit}
        file="joint-torques"
      />
      {joints_rad.length > 0 ? (
        <Lines title={said.joints} t_s={t_s} lines={joints_rad} factor={DEGREES} unit="°" file="joints" />
      ) : (
        <Lines title={said.down} t_s={t_s} lines={down} factor={1} unit="" file="down" />
      )}
    </section>
  );
}

interface LinesProps {
  title: string;
  t_s: number[];
  lines: LogLine[];
  factor: number;
  unit: string;
  file: string;
}

/** Nothing where the log has none of these. */
function Lines({ title, t_s, lines, factor, unit, file }: LinesProps) {
  if (lines.length === 0) return null;
  const drawn: Line[] = lines.map((line, k) => ({
    label: line.name,
    colour: AXES[k % AXES.length] ?? '--ink',
    dashed: k >= AXES.length && k < 2 * AXES.length,
  }));
  return (
    <Plot
      title={title}
      note=""
      lines={drawn}
      data={[t_s, ...lines.map(({ values }) => values.map((value) => factor * value))]}
      unit={unit}
      file={nameFile(['log', name.value, file], new Date().toISOString())}
      together="log"
    />
  );
}
