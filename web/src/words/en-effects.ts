import type { Named } from './en-remarks';

/** What the diagnosis can name. */
export const enEffects = {
  effects: {
    base_tilt: 'Base not level',
    cable_drag: 'Hose or cable that pulls',
    external_contact: 'Contact during part of the run',
    gear_ripple: 'Ripple of the gears',
    joint_backlash: 'Play in the joints',
    joint_elasticity: 'Joints that give under load',
    joint_friction: 'Friction in the joints',
    joint_offset: 'Joint encoders whose zero is off',
    kinematic_lag: 'Lag of the recorded motion',
    payload_loose: 'Loose part in the payload',
    payload_mass_change: 'Payload that gained or lost mass',
    payload_mismatch: 'Payload that is not the reference',
    payload_shift: 'Payload that slipped',
    sample_dropout: 'Samples held or lost',
    sensor_creep: 'Creep of the sensor',
    sensor_crosstalk: 'Cross-talk between the sensor’s channels',
    sensor_drift: 'Drift of the sensor’s offset',
    sensor_gain: 'Gain error of the sensor’s channels',
    sensor_hysteresis: 'Hysteresis of the sensor',
    sensor_interference: 'Electrical interference',
    sensor_lowpass: 'Low-pass filter in the sensor',
    sensor_noise: 'More sensor noise than stated',
    sensor_nonlinearity: 'Non-linear sensor',
    sensor_offset_step: 'Jump of the sensor’s offset',
    sensor_quantization: 'Coarse steps of the sensor',
    sensor_rotation: 'Sensor mounted turned',
    sensor_saturation: 'Clipping of the sensor',
    sensor_translation: 'Sensor origin off',
    time_delay: 'Wrench late against the joints',
    tool_flexibility: 'Tool that rings',
    unknown: 'An effect outside the library',
  } as Record<string, string>,
  stages: {
    sensor: 'sensor',
    timing: 'timing',
    mounting: 'mounting',
    kinematics: 'kinematics',
    payload: 'payload',
    environment: 'surroundings',
    actuation: 'drives',
  } as Record<string, string>,
  /** What to do about an effect, and what a proposed motion does: the engine says it in English, with its figures. */
  remedies: {} as Record<string, string>,
  motions: {} as Record<string, string>,
  /** What was seen elsewhere than in the wrench, by the identifier of the remark. */
  seen: {} as Record<string, (named: Named) => string>,
  /** Pieces of the names of parameters, where they are not English words already. */
  pieces: { second_order: 'second-order share', joint: 'joint', mode: 'mode' } as Record<string, string>,
};
