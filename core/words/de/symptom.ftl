# What is read off a recording directly, beside the verdict.
symptom-noisier = In den Halten rauscht { $channel } { FIXED($times, digits: 2) }-mal so stark wie angegeben; Korrelation zwischen den Werten: { FIXED($correlation, digits: 2) }.
symptom-held-or-lost = { $held_share ->
    [0] { PERCENT($lost_share, digits: 1) } % der Messwerte fehlen.
   *[other] { $lost_share ->
        [0] { PERCENT($held_share, digits: 1) } % der Messwerte wiederholen den vorigen, bis zu { MILLI($longest_s) } ms lang.
       *[other] { PERCENT($held_share, digits: 1) } % der Messwerte wiederholen den vorigen, bis zu { MILLI($longest_s) } ms lang; { PERCENT($lost_share, digits: 1) } % fehlen.
    }
}
symptom-steps = { $channel } kommt in Stufen von { $step }: dem { FIXED($times, digits: 1) }-fachen seines Rauschens.
symptom-coarser-steps = { $channel } kommt in Stufen von { $step }, angegeben sind { $stated }: dem { FIXED($times, digits: 1) }-fachen seines Rauschens.
symptom-line = Eine Linie bei { $place } mit Amplituden von im Mittel bis zu { $amplitude }; wo sie am stärksten ist, erreicht sie mit ihren Oberwellen in { $channel } das { FIXED($times, digits: 1) }-fache des Rauschens.
symptom-frequency = { FIXED($frequency_hz, digits: 2) } Hz
symptom-mains = { FIXED($frequency_hz, digits: 2) } Hz (Netz, { FIXED($source_hz, digits: 0) } Hz)
symptom-mains-alias = { FIXED($frequency_hz, digits: 2) } Hz (Netz, { FIXED($source_hz, digits: 0) } Hz, sichtbar als Spiegelfrequenz bei { FIXED($samples_per_second, digits: 0) } Messwerten je Sekunde)
symptom-vibration = Die Last schwingt mit { FIXED($frequency_hz, digits: 1) } Hz und { FIXED($force_n, digits: 2) } N ({ FIXED($acceleration_m_s2, digits: 2) } m/s²), dem { FIXED($times, digits: 1) }-fachen des Rauschens, als schwänge der ganze Roboter.

# The payload against its reference.
symptom-other-payload = Die Last ist nicht { $reference }: { $differences }.
symptom-as-referred = Die Last ist { $reference }, soweit es von Belang ist: { $differences }.
symptom-payload-or-gap = { $seen } Der Grund kann aber die Abweichung in Kraft und Moment sein.
symptom-reference = die Referenz
symptom-reference-of = die Referenz ({ $source })
symptom-heavier = { PERCENT($mass_share, digits: 1) } % schwerer
symptom-lighter = { PERCENT($mass_share, digits: 1) } % leichter
symptom-first-moment-off = statisches Moment um { PERCENT($first_moment_share, digits: 1) } % anders
symptom-inertia-off = Trägheit um { PERCENT($inertia_share, digits: 1) } % anders

# Friction in the joints.
symptom-friction = { FIXED($coulomb_nm, digits: 2) } ± { FIXED($coulomb_std_nm, digits: 2) } N m (Coulomb) und { FIXED($viscous_nms_per_rad, digits: 2) } ± { FIXED($viscous_std_nms_per_rad, digits: 2) } N m s/rad (viskos)
symptom-stated-friction = die Zelle gibt { FIXED($coulomb_nm, digits: 2) } und { FIXED($viscous_nms_per_rad, digits: 2) } an
symptom-friction-differs = Gelenk { $joint } reibt mit { $friction }; { $stated }.
symptom-friction-as-stated = Die Reibung in den Gelenken ist, wie die Zelle sie angibt: am weitesten entfernt ist Gelenk { $joint } mit { $friction }; { $stated }.
symptom-friction-not-stated = Gelenk { $joint } reibt mit { $friction }; die Zelle gibt keine Reibung an, mit der das zu vergleichen wäre.
symptom-friction-in-tracking = Gelenk { $joint } bleibt in Bewegungsrichtung um { MILLI($lag_rad, digits: 3) } ± { MILLI($lag_std_rad, digits: 3) } mrad hinter seinem Befehl zurück: Coulombsche Reibung im Schleppfehler; ohne Gelenkmomente lässt sie sich nicht mit der Zelle vergleichen.
symptom-friction-and-tracking = { $seen } Gelenk { $joint } weicht in Bewegung um { DEGREES($tracking_rad, digits: 2) }° (quadratisches Mittel) von seinem Befehl ab.
symptom-torque-offset = Das Moment von Gelenk { $joint } liegt um { FIXED($offset_nm, digits: 2) } ± { FIXED($offset_std_nm, digits: 2) } N m daneben; zulässig sind { FIXED($tolerated_nm, digits: 2) } N m.
symptom-velocity-lag = Die aufgezeichneten Gelenkgeschwindigkeiten folgen den Stellungen { MILLI($lag_s, digits: 1) } ± { MILLI($lag_std_s, digits: 1) } ms verspätet, wie es ein Filter hinterlässt.
