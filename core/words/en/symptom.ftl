# What is read off a recording directly, beside the verdict.
symptom-noisier = The noise of { $channel } in the holds is { FIXED($times, digits: 2) } times the stated one, its correlation between samples { FIXED($correlation, digits: 2) }.
symptom-held-or-lost = { $held_share ->
    [0] { PERCENT($lost_share, digits: 1) } % of the wrench samples are missing.
   *[other] { $lost_share ->
        [0] { PERCENT($held_share, digits: 1) } % of the wrench samples repeat the one before, for up to { MILLI($longest_s) } ms.
       *[other] { PERCENT($held_share, digits: 1) } % of the wrench samples repeat the one before, for up to { MILLI($longest_s) } ms, and { PERCENT($lost_share, digits: 1) } % of the samples are missing.
    }
}
symptom-steps = { $channel } comes in steps of { $step }: { FIXED($times, digits: 1) } times its noise.
symptom-coarser-steps = { $channel } comes in steps of { $step }, stated are { $stated }: { FIXED($times, digits: 1) } times its noise.
symptom-line = There is a line at { $place } with amplitudes up to { $amplitude } on average; where it is strongest it reaches, with its harmonics, { FIXED($times, digits: 1) } times the noise in { $channel }.
symptom-frequency = { FIXED($frequency_hz, digits: 2) } Hz
symptom-mains = { FIXED($frequency_hz, digits: 2) } Hz (mains, { FIXED($source_hz, digits: 0) } Hz)
symptom-mains-alias = { FIXED($frequency_hz, digits: 2) } Hz (mains, { FIXED($source_hz, digits: 0) } Hz, seen as its alias at { FIXED($samples_per_second, digits: 0) } samples per second)
symptom-vibration = The payload shakes at { FIXED($frequency_hz, digits: 1) } Hz with { FIXED($force_n, digits: 2) } N ({ FIXED($acceleration_m_s2, digits: 2) } m/s²), { FIXED($times, digits: 1) } times the noise, as if the whole robot did.

# The payload against its reference.
symptom-other-payload = The payload is not { $reference }: { $differences }.
symptom-as-referred = The payload is { $reference } as far as it matters: { $differences }.
symptom-payload-or-gap = { $seen } But the gap in the wrench may be why.
symptom-reference = the reference
symptom-reference-of = the reference ({ $source })
symptom-heavier = { PERCENT($mass_share, digits: 1) } % heavier
symptom-lighter = { PERCENT($mass_share, digits: 1) } % lighter
symptom-first-moment-off = first moment off by { PERCENT($first_moment_share, digits: 1) } %
symptom-inertia-off = inertia off by { PERCENT($inertia_share, digits: 1) } %

# Friction in the joints.
symptom-friction = { FIXED($coulomb_nm, digits: 2) } ± { FIXED($coulomb_std_nm, digits: 2) } N m (Coulomb) and { FIXED($viscous_nms_per_rad, digits: 2) } ± { FIXED($viscous_std_nms_per_rad, digits: 2) } N m s/rad (viscous)
symptom-stated-friction = the cell states { FIXED($coulomb_nm, digits: 2) } and { FIXED($viscous_nms_per_rad, digits: 2) }
symptom-friction-differs = Joint { $joint } rubs with { $friction }; { $stated }.
symptom-friction-as-stated = Friction in the joints is as the cell states it: joint { $joint } differs most, { $friction }; { $stated }.
symptom-friction-not-stated = Joint { $joint } rubs with { $friction }; the cell states no friction to compare it with.
symptom-friction-in-tracking = Joint { $joint } lags its command by { MILLI($lag_rad, digits: 3) } ± { MILLI($lag_std_rad, digits: 3) } mrad in the direction of motion: Coulomb friction in the tracking error; without joint torques there is nothing to compare with the cell.
symptom-friction-and-tracking = { $seen } Joint { $joint } follows its command with an error of { DEGREES($tracking_rad, digits: 2) } deg, r.m.s. while it moves.
symptom-torque-offset = The torque of joint { $joint } is off by { FIXED($offset_nm, digits: 2) } ± { FIXED($offset_std_nm, digits: 2) } N m; { FIXED($tolerated_nm, digits: 2) } N m are tolerated.
symptom-velocity-lag = The recorded joint velocities are { MILLI($lag_s, digits: 1) } ± { MILLI($lag_std_s, digits: 1) } ms late against the positions, as a filter leaves them.
