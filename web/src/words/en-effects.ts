import type { Named } from './en-remarks';

/** What the diagnosis can name. */
export const enEffects = {
  effects: {
    base_tilt: 'Base not level',
    cable_drag: 'Hose or cable drag',
    external_contact: 'Contact during part of the run',
    gear_ripple: 'Gear ripple',
    joint_backlash: 'Joint backlash',
    joint_elasticity: 'Joint elasticity',
    joint_friction: 'Joint friction',
    joint_offset: 'Joint encoder offset',
    kinematic_lag: 'Lag of the recorded motion',
    payload_loose: 'Loose part in the payload',
    payload_mass_change: 'Payload mass change',
    payload_mismatch: 'Payload differs from the reference',
    payload_shift: 'Payload slipped',
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
    sensor_rotation: 'Sensor mounted rotated',
    sensor_saturation: 'Clipping of the sensor',
    sensor_translation: 'Sensor origin offset',
    time_delay: 'Force signal delay',
    tool_flexibility: 'Tool vibration',
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
