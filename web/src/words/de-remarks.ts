import type { remarks as english } from './en-remarks';

const ABOUT_COM = 'um den Schwerpunkt längs der Achsen des Flanschs';

export const remarks: typeof english = {
  warnings: {
    residual: ({ channel, times }) =>
      `Der Rest ist größer als das Rauschen des Sensors, am meisten in ${channel} (${times}-mal, mit seinem zeitlichen Zusammenhang): etwas, das im Modell fehlt. Die Unsicherheiten wurden vergrößert, aber ein Fehler, der sich wiederholt, ist kein Rauschen.`,
    no_such_body: () =>
      'Für sich allein verlangten die Daten einen Körper, den es nicht geben kann; genommen wurde der nächste, den es geben kann.',
    noise_of_residual: () =>
      'Kein Stillstand war lang genug, um das Rauschen des Sensors zu messen: es wurde dem Rest entnommen.',
    base_tilt: ({ angle_rad }) => `Die Basis steht schief: ${angle_rad}; berücksichtigt.`,
    delay: ({ delay_s }) => `Die Kraftmessung kommt gegen die Gelenke ${delay_s} zu spät; berücksichtigt.`,
    transfers_alone: ({ axes, parameters }) =>
      `Nicht gedreht wurde um ${axes?.replaceAll(' or ', ', ')}: ${parameters} beruhen allein auf den Fahrten, und keine ausgelassene Drehung prüft sie nach.`,
    drift: () => 'Der Nullpunkt des Sensors wandert; berücksichtigt.',
    saturated: ({ channels }) => `Der Sensor stand am Ende seines Bereichs: ${channels}.`,
    effect_left_out: ({ effect }) =>
      `Ein Effekt des Zwillings konnte nicht berücksichtigt werden: ${effect}.`,
    wrench_needed: () =>
      'Aus Gelenkmomenten folgt eine Last nur zusammen mit den Parametern des Arms selbst oder mit einer Aufzeichnung derselben Bewegung ohne Last. Oder zeichnen Sie einen Sensor am Handgelenk auf.',
    motion_needed: () => 'Zeichnen Sie neben der Kraft auch Gelenke oder Stellungen des Sensors auf.',
    nothing: () => 'Die Aufzeichnung ist zu kurz oder enthält zu wenig.',
    no_wrench: () => 'Die Aufzeichnung enthält keine Kräfte am Handgelenk.',
    no_motion: () => 'Die Aufzeichnung enthält weder Gelenke noch Stellungen.',
    poses_only: () =>
      'Die Aufzeichnung besteht aus einzelnen Stellungen, nicht aus Bewegung; aus ihr folgt nur eine Last.',
    tool_without_std: ({ tool, keys }) =>
      `Wie unsicher das Werkzeug ${tool} ist, ist nicht bekannt (${keys} fehlt): die Intervalle des Werkstücks enthalten davon nichts und können zu eng sein.`,
    no_workpiece: () =>
      'Was ohne die Werkzeuge bleibt, ist kein starrer Körper: das Werkstück ist zu leicht, um es von nichts zu unterscheiden, oder ein Werkzeug ist anders als angegeben.',
    too_short: ({ lasts_s }) => `${lasts_s} sind zu kurz, um etwas zu sagen.`,
    hardly_turns: () =>
      'Der Sensor dreht sich kaum; so lassen sich Last, Nullpunkte und Effekte nicht trennen.',
  },
  undetermined: {
    mass: 'zu wenige verschiedene Stellungen',
    com: 'Schwerkraft aus zu wenigen Richtungen',
    inertia: 'zu wenig Winkelbeschleunigung',
  },
  exports: {
    ur: `kg, m, kg m²; Trägheit ${ABOUT_COM}: Ixx Iyy Izz Ixy Ixz Iyz`,
    kuka_krl:
      'kg, mm, Grad, kg m²; Hauptträgheitsmomente J um den Schwerpunkt, längs Achsen, die A B C aus denen des Flanschs drehen',
    kuka_sunrise: `kg, mm, kg m²; Trägheitsmomente ${ABOUT_COM}, ohne Deviationsmomente`,
    abb: 'kg, mm, kg m²; Hauptträgheitsmomente um den Schwerpunkt, längs Achsen, die eine Quaternion (w x y z) aus denen des Flanschs dreht',
    franka: `kg, m, kg m²; Trägheit ${ABOUT_COM}, neun Werte, Spalte für Spalte`,
    flexiv: `kg, m, kg m²; Trägheit ${ABOUT_COM}: Ixx Iyy Izz Ixy Ixz Iyz`,
    xarm: 'kg, mm; keine Trägheit',
    opc_ua:
      'kg, mm, Grad, kg m²; Hauptträgheitsmomente um den Befestigungspunkt, längs Achsen, die A B C aus denen des Befestigungspunkts drehen',
    mujoco: 'kg, m, kg m²; Trägheit um den Schwerpunkt längs der Achsen des Körpers: 11 22 33 12 13 23',
    urdf: 'kg, m, kg m²; Trägheit um den Schwerpunkt längs der Achsen des Glieds: ixx ixy ixz iyy iyz izz',
  },
  limits: {
    'the recording has no joint positions': 'die Aufzeichnung enthält keine Gelenkpositionen',
    'the recording does not say where the sensor is': 'die Aufzeichnung sagt nicht, wo der Sensor ist',
    'the sensor stays in one place': 'der Sensor bleibt an einem Ort',
    'no joint moves in this recording': 'in dieser Aufzeichnung bewegt sich kein Gelenk',
  },
};
