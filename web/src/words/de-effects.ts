import type { enEffects } from './en-effects';
import type { Named } from './en-remarks';

/** Gravity sweeps through the sensor. */
function turning(about: string, down: string): string {
  return `Drehung um die ${about}-Achse des Sensors, waagrecht gehalten, ${down} nach unten: die Schwerkraft wandert durch den Sensor.`;
}

/** Was von der Last abweicht, soweit es bestimmt ist. */
function differences({ mass_share, first_moment_share, inertia_share }: Named): string {
  const lighter = mass_share?.startsWith('−') || mass_share?.startsWith('-');
  const mass = mass_share?.replace(/^[−-]/, '');
  return [
    mass && `${mass} ${lighter ? 'leichter' : 'schwerer'}`,
    first_moment_share && `statisches Moment um ${first_moment_share} anders`,
    inertia_share && `Trägheit um ${inertia_share} anders`,
  ]
    .filter(Boolean)
    .join(', ');
}

/** Wie ein Gelenk reibt. */
function rubs({ joint, coulomb_nm, viscous_nms }: Named): string {
  return `Gelenk ${joint} reibt mit ${coulomb_nm} (Coulomb) und ${viscous_nms} (viskos)`;
}

/** Welches Gelenk seinem Befehl zu weit nachläuft. */
function late({ late_joint, tracking_rad }: Named): string {
  if (late_joint === undefined) return '';
  return ` Gelenk ${late_joint} weicht in Bewegung um ${tracking_rad} (quadratisches Mittel) von seinem Befehl ab.`;
}

export const deEffects: typeof enEffects = {
  effects: {
    base_tilt: 'Schiefe Basis',
    cable_drag: 'Zug von Schlauch oder Kabel',
    external_contact: 'Berührung während eines Teils des Laufs',
    gear_ripple: 'Welligkeit der Getriebe',
    joint_backlash: 'Spiel in den Gelenken',
    joint_elasticity: 'Elastische Gelenke',
    joint_friction: 'Reibung in den Gelenken',
    joint_offset: 'Verschobener Nullpunkt der Gelenkgeber',
    kinematic_lag: 'Nachlaufende Bewegungsaufzeichnung',
    payload_loose: 'Loses Teil in der Last',
    payload_mass_change: 'Masseänderung der Last',
    payload_mismatch: 'Last weicht von der Referenz ab',
    payload_shift: 'Verrutschte Last',
    sample_dropout: 'Gehaltene oder verlorene Messwerte',
    sensor_creep: 'Kriechen des Sensors',
    sensor_crosstalk: 'Übersprechen zwischen den Kanälen',
    sensor_drift: 'Drift des Sensor-Nullpunkts',
    sensor_gain: 'Verstärkungsfehler der Kanäle',
    sensor_hysteresis: 'Hysterese des Sensors',
    sensor_interference: 'Elektrische Störung',
    sensor_lowpass: 'Tiefpass im Sensor',
    sensor_noise: 'Mehr Rauschen als angegeben',
    sensor_nonlinearity: 'Nichtlinearer Sensor',
    sensor_offset_step: 'Sprung des Sensor-Nullpunkts',
    sensor_quantization: 'Grobe Stufen des Sensors',
    sensor_rotation: 'Verdreht montierter Sensor',
    sensor_saturation: 'Begrenzung des Sensors',
    sensor_translation: 'Versetzter Ursprung des Sensors',
    time_delay: 'Verzögertes Kraftsignal',
    tool_flexibility: 'Schwingendes Werkzeug',
    unknown: 'Ein Effekt außerhalb der Bibliothek',
  },
  stages: {
    sensor: 'Sensor',
    timing: 'Zeitbezug',
    mounting: 'Montage',
    kinematics: 'Kinematik',
    payload: 'Last',
    environment: 'Umgebung',
    actuation: 'Antriebe',
  },
  remedies: {
    base_tilt:
      'Richten Sie die Basis waagrecht aus, oder berichtigen Sie die Richtung der Schwerkraft in der Zelle.',
    cable_drag: 'Legen Sie Schlauch oder Kabel frei, sodass sie nicht ziehen oder reiben.',
    external_contact: 'Halten Sie die Last frei; lassen Sie diesen Teil weg, oder fahren Sie erneut.',
    gear_ripple: 'Drehen Sie das Gelenk beim Messen mit einer anderen Geschwindigkeit.',
    joint_backlash: 'Lassen Sie das Getriebe des Gelenks mit dem größten Spiel einstellen.',
    joint_elasticity:
      'Nehmen Sie die Steifigkeit der Gelenke in den Zwilling auf, oder verwenden Sie Geber auf der Abtriebsseite.',
    joint_friction:
      'Fahren Sie die Gelenke einige Minuten warm, lassen Sie nachsehen, welche mehr reiben als früher, und geben Sie die bleibende Reibung in cell.toml an (robot.friction).',
    joint_offset: 'Justieren Sie den Nullpunkt des genannten Gelenkgebers, oder zentrieren Sie ihn.',
    kinematic_lag:
      'Zeichnen Sie ungefilterte Gelenkstellungen auf, oder verschieben Sie ihre Zeitstempel um den Nachlauf.',
    payload_loose: 'Befestigen Sie das lose Teil der Last.',
    payload_mass_change: 'Prüfen Sie die Last; identifizieren Sie sie danach erneut.',
    payload_mismatch:
      'Prüfen Sie, ob die richtige Last montiert ist, und ersetzen Sie die Referenz durch die gefundenen Werte.',
    payload_shift: 'Spannen Sie die Last fester; identifizieren Sie sie danach erneut.',
    sample_dropout:
      'Gleichen Sie die Rate der Aufzeichnung der des Sensors an, oder entlasten Sie seinen Bus.',
    sensor_creep: 'Warten Sie nach einer Laständerung, bevor Sie nullen oder messen.',
    sensor_crosstalk: 'Laden Sie die Kalibriermatrix des Sensors neu, oder lassen Sie ihn neu kalibrieren.',
    sensor_drift: 'Lassen Sie den Sensor 20 Minuten warm werden, und nullen Sie ihn kurz vor dem Lauf.',
    sensor_gain: 'Lassen Sie den Sensor mit bekannten Gewichten in beiden Richtungen neu kalibrieren.',
    sensor_hysteresis:
      'Prüfen Sie die Schrauben der Sensorflansche auf Schlupf; sonst fahren Sie jede Pose von derselben Seite an.',
    sensor_interference:
      'Führen Sie das Sensorkabel fern von Motor- und Netzkabeln, und erden Sie seinen Schirm an einem Ende.',
    sensor_lowpass: 'Schalten Sie den Filter des Sensors ab, oder setzen Sie seine Grenzfrequenz weit höher.',
    sensor_noise:
      'Prüfen Sie Versorgung, Schirm und Kabel des Sensors, oder geben Sie das höhere Rauschen an und halten Sie länger.',
    sensor_nonlinearity: 'Lassen Sie die Linearität des Sensors mit mehreren bekannten Gewichten prüfen.',
    sensor_offset_step: 'Prüfen Sie Stecker und Kabel des Sensors, und nullen Sie ihn.',
    sensor_quantization:
      'Wählen Sie die feinste Auflösung des Sensors oder einen kleineren Messbereich; bewegen Sie bis dahin beim Halten ein wenig.',
    sensor_rotation:
      'Berichtigen Sie das Sensorkoordinatensystem in der URDF, oder montieren Sie den Sensor neu.',
    sensor_saturation: 'Wählen Sie einen größeren Messbereich des Sensors oder eine leichtere Last.',
    sensor_translation: 'Verschieben Sie das Sensorkoordinatensystem in der URDF um den gefundenen Versatz.',
    time_delay:
      'Stempeln Sie Kräfte und Gelenke mit einer Uhr, oder stellen Sie die Verzögerung in der Aufzeichnung ein.',
    tool_flexibility: 'Versteifen Sie das Werkzeug, oder glätten Sie die Bewegung.',
  },
  motions: {
    swings_about_horizontal_x: turning('x', 'y'),
    swings_about_horizontal_y: turning('y', 'z'),
    swings_about_horizontal_z: turning('z', 'x'),
    tilted_holds: 'Halte mit der Schwerkraft längs vier Diagonalen des Sensorkoordinatensystems.',
    revisit: 'Der erste Halt noch einmal.',
    both_sides: 'Der erste Halt, von der einen und von der anderen Seite angefahren.',
    wide_band_slow: 'Eine breitbandige Bewegung um alle Achsen zugleich, 0,3 bis 5 Hz.',
    wide_band_fast: 'Eine breitbandige Bewegung um alle Achsen zugleich, 5 bis 15 Hz.',
    other_posture: 'Der erste Halt in einer anderen Stellung des Arms.',
    second_payload:
      'Derselbe Lauf mit einer zweiten Last, deren Masse und Schwerpunkt bekannt sind: keine Bewegung mit dieser trennt genug.',
  },
  seen: {
    noisier: ({ channel, times, correlation }) =>
      `In den Halten rauscht ${channel} ${times}-mal so stark wie angegeben; Korrelation zwischen den Werten: ${correlation}.`,
    line: ({ frequency_hz, times, channel }) =>
      `Eine Linie bei ${frequency_hz}, in ${channel} mit dem ${times}-fachen des Rauschens.`,
    mains_line: ({ frequency_hz, source_hz, times, channel }) =>
      `Eine Linie bei ${frequency_hz} (Netz, ${source_hz}), in ${channel} mit dem ${times}-fachen des Rauschens.`,
    coarse_steps: ({ channel, step_n, step_nm, times }) =>
      `${channel} kommt in Stufen von ${step_n ?? step_nm}: dem ${times}-fachen des Rauschens.`,
    held_or_lost: ({ held_share, lost_share, longest_s }) =>
      `${held_share} der Messwerte wiederholen den vorigen, bis zu ${longest_s} lang; ${lost_share} fehlen.`,
    other_payload: (named) => `Die Last ist nicht die Referenz: ${differences(named)}.`,
    as_referred: (named) => `Die Last ist die Referenz, soweit es von Belang ist: ${differences(named)}.`,
    payload_or_gap: (named) =>
      `Die Last ist nicht die Referenz: ${differences(named)}. Der Grund kann aber die Abweichung selbst sein.`,
    friction_differs: (named) =>
      `${rubs(named)}; angegeben sind ${named.stated_coulomb_nm} und ${named.stated_viscous_nms}.${late(named)}`,
    friction_as_stated: (named) =>
      `Die Reibung ist, wie die Zelle sie angibt. Am weitesten entfernt: ${rubs(named)}; angegeben sind ${named.stated_coulomb_nm} und ${named.stated_viscous_nms}.${late(named)}`,
    friction_not_stated: (named) =>
      `${rubs(named)}; die Zelle gibt keine Reibung an, mit der das zu vergleichen wäre.${late(named)}`,
    friction_in_tracking: (named) =>
      `Gelenk ${named.joint} bleibt um ${named.lag_rad} hinter seinem Befehl zurück: Reibung im Schleppfehler; ohne Gelenkmomente lässt sie sich nicht mit der Zelle vergleichen.${late(named)}`,
  },
  pieces: {
    about: 'um',
    amplitude: 'Amplitude',
    asymmetry: 'Asymmetrie',
    at: 'bei',
    contact_torque: 'Kontaktmoment',
    corner: 'Knick',
    correlation: 'Korrelation',
    cos: 'Kosinusanteil',
    coulomb: 'Coulombsche Reibung',
    creep: 'Kriechen',
    damping_ratio: 'Dämpfungsgrad',
    delay: 'Verzögerung',
    duration: 'Dauer',
    first_minute: 'erste Minute',
    first_moment: 'statisches Moment',
    force: 'Kraft',
    frequency: 'Frequenz',
    friction: 'Reibung',
    from: 'aus',
    full_scale_error: 'Fehler bei Vollausschlag',
    gain_error: 'Verstärkungsfehler',
    gear_ratio: 'Übersetzung',
    guide_friction: 'Reibung der Führung',
    half_width: 'halbe Breite',
    hanging: 'hängender Anteil',
    held: 'gehalten',
    joint: 'Gelenk',
    lag: 'Nachlauf',
    lost: 'verloren',
    lower_limit: 'untere Grenze',
    mass: 'Masse',
    mode: 'Mode',
    moving: 'beweglicher Anteil',
    noise_factor: 'Rauschfaktor',
    over: 'Dauer',
    place: 'Ort',
    pull: 'Zug',
    rectification: 'Gleichrichtung',
    second_order: 'Anteil zweiter Ordnung',
    settling_rate: 'Einschwingrate',
    sin: 'Sinusanteil',
    slack: 'Lose',
    slope_error: 'Steigungsfehler',
    start: 'Anfang',
    start_rate: 'Anfangsrate',
    step: 'Sprung',
    step_time: 'Zeitpunkt',
    stiffness: 'Steifigkeit',
    swinging_inertia: 'schwingende Trägheit',
    taper: 'Verlauf',
    time_constant: 'Zeitkonstante',
    turning_load_log_ratio: 'Umkehrlast (log)',
    turning_spread_log_ratio: 'Streuung der Umkehrlast (log)',
    twist_cube: 'Verdrehung, kubisch',
    twist_friction: 'Verdrehung, Reibung',
    twist_linear: 'Verdrehung, linear',
    twist_square: 'Verdrehung, quadratisch',
    upper_limit: 'obere Grenze',
    viscous: 'viskose Reibung',
  },
};
