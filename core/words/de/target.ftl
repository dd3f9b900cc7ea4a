# What a target cannot be
target-unreadable =
    .found = { $text }
    .expected = requirement, oder halbe Breiten von 95-%-Intervallen wie mass=0.1%,com=0.5mm,inertia=1%
target-out-of-range =
    .found = { $text }
    .expected = mehr als nichts und höchstens 100 % oder 1 m
target-without-cell =
    .found = die Anforderung einer Zelle, die nicht genannt ist
    .expected = --cell ZELLE dazu, oder halbe Breiten wie mass=0.1%,inertia=1%
target-beside-experiment =
    .found = ein Ziel neben einem Experiment
    .expected = eines von beiden: Ein Experiment läuft ab wie vorgeschlagen
# How far it is met
target-title = Was verlangt war
target-requirement = was die Zelle verlangt
target-reached-home = Ziel erreicht: Der Roboter fährt nach Hause.
target-reached = Ziel erreicht.
target-reached-early = Ziel erreicht nach { $made } von { $planned } Bewegungen: Der Roboter fuhr { FIXED($saved_s, digits: 0) } s früher nach Hause.
target-reached-with-fewer = Ziel erreicht mit { $repetitions ->
    [one] einer Wiederholung
   *[other] { $repetitions } Wiederholungen
 } weniger: { FIXED($saved_s, digits: 0) } s gespart.
target-type-b = Ziel nicht erreicht ({ $names }): Übrig ist Typ B, mehr Wiederholungen würden nicht helfen. Bessere Angaben zu Sensor, Roboter und Standort schon.
target-open = Ziel nicht erreicht ({ $names }): Mehr Wiederholungen würden helfen.
target-quantity = { $name }: { PERCENT($total, digits: 0) } % dessen, was das Ziel zulässt; Wiederholbarkeit allein { PERCENT($repeatability, digits: 0) } %, Typ B allein { PERCENT($systematic, digits: 0) } %
target-quantity-unknown = { $name }: nicht bestimmt
