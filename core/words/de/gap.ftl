# The verdict in a sentence.
gap-none = Simulation und Aufzeichnung stimmen überein; nichts von Belang trennt sie.
gap-explained = Die Abweichung ist erklärt: { $effects } (Stufe: { $stages }).
gap-ambiguous = Nicht entschieden: { $effects } (Stufe: { $stages }). Diese Aufzeichnung kann es nicht klären.
gap-unknown = Kein bekannter Effekt erklärt die Abweichung.
gap-nothing-to-say = Über die Abweichung lässt sich nichts sagen: { $reason }.
gap-summary-and = { $said } { $more }

# Why nothing can be said.
gap-no-wrench = die Aufzeichnung enthält keine Kräfte am Handgelenk: die Abweichung der Gelenkmomente allein zeigt nur die Seite der Gelenke
gap-joints-alone = Kräfte am Handgelenk fehlen, daher wurden nur die Gelenke betrachtet. { $seen }
gap-joints-two = eine Last, die nur eine von zwei Aufzeichnungen trägt, zeigt sich neben der anderen: heft identify LOADED --without EMPTY
gap-joints-as-ever = Nichts fällt auf.
gap-no-motion = die Aufzeichnung enthält weder Gelenke noch Lagen
gap-too-few-poses = { $poses } Lagen sind zu wenige, um eine Abweichung vom Rauschen zu unterscheiden: mindestens { $needed } werden gebraucht
gap-of-poses = es wurden nur Lagen aufgezeichnet: was auf dem Weg zwischen ihnen geschieht, ist nicht zu sehen
gap-noise-of-poses = das Rauschen einer Lage ist nicht angegeben: dafür steht, was ein linearer Sensor unter beliebiger Schwerkraft übrig ließe, und darin kann sich eine Abweichung anderer Art verbergen (`sensor.noise_std` gibt es an)
gap-too-short = { FIXED($lasts_s, digits: 1) } s sind zu kurz, um etwas zu sagen

# Where the gap lies.
gap-largest = Die Abweichung ist am größten in { $channel } bei { $phase } zwischen { SIGNIFICANT($low_hz, digits: 3) } und { SIGNIFICANT($high_hz, digits: 3) } Hz: das { FIXED($times, digits: 1) }-fache des Rauschens, { PERCENT($share) } % der ganzen Abweichung.
gap-phase-hold = Halt { $axis }
gap-phase-rotate = Drehung { $axis }
gap-phase-transfer = Fahrt
gap-at-joints = an den Gelenken
gap-in-readings = in den Messwerten des Sensors
gap-against-reference = gegen die Referenzlast

# What comes of it for the payload.
gap-payload-as-it-is = Die Größen der Last können verwendet werden, wie sie sind.
gap-payload-changed = Bleibt der Effekt unberücksichtigt, ändert er die Masse um { MILLI($mass_kg, digits: 1) } g ({ PERCENT($mass_share, digits: 2) } %), das statische Moment um { MILLI($first_moment_kg_m, digits: 2) } g m ({ PERCENT($first_moment_share, digits: 2) } %) und die Trägheit um bis zu { PERCENT($inertia_share, digits: 1) } % ihres größten Moments.
gap-payload-changed-but-inertia = Bleibt der Effekt unberücksichtigt, ändert er die Masse um { MILLI($mass_kg, digits: 1) } g ({ PERCENT($mass_share, digits: 2) } %) und das statische Moment um { MILLI($first_moment_kg_m, digits: 2) } g m ({ PERCENT($first_moment_share, digits: 2) } %); die Trägheit ist durch diese Aufzeichnung nicht bestimmt.
gap-payload-in-doubt = Solange die Ursache nicht bekannt ist, kann niemand sagen, was sie mit den Größen der Last macht: verwenden Sie sie mit Vorsicht.

# What this recording cannot say, and what would.
gap-minor = gefunden, aber zu klein, um von Belang zu sein
gap-hardly-turns = der Sensor dreht sich kaum: die Schwerkraft trennt Last und Nullpunkte hier nicht, das tun nur Beschleunigungen
gap-moments-left = { PERCENT($share) } % dessen, was der Effekt von der Abweichung lässt, liegen in wenigen Bewegungen, das meiste um { FIXED($at_s, digits: 1) } s: außerhalb davon erklärt er die Aufzeichnung, der Hergang dort ist nicht ganz der seines Modells
gap-sound-gears = der Arm schwingt auf seinen Getrieben, wie gesunde Arme es tun (weichstes Gelenk { FIXED($softest_nm_per_rad, digits: 0) } N m/rad): das gilt als Teil der Simulation, und Gelenke über { FIXED($least_nm_per_rad, digits: 0) } N m/rad werden nicht genannt
gap-not-shown = { $title }: { $reason }
gap-tied = mit anderen Lastparametern und Nullpunkten sagen beide diese Aufzeichnung voraus; sie unterscheiden sich um { FIXED($distance_sigma, digits: 1) } Standardabweichungen
gap-no-motion-splits = keine der möglichen Bewegungen für sich allein
gap-no-cell = keine Zelle wurde genannt, in der sie zu planen wäre
gap-no-motion-asked = es ist keine Bewegung

# What stands against adding an effect to the twin, and what would not.
gap-not-addable =
    .found = { $against }
    .expected = { $wanted }
gap-cannot-show = eine Aufzeichnung, die { $effect } nicht zeigen kann ({ $reason })
gap-wanted-shown = eine, die es kann
gap-tied-to-run = eine Aufzeichnung, aus der { $effect } nicht übernommen werden kann ({ $reason })
gap-wanted-stated = eine, die es angibt
gap-not-determined = { $effect } nicht bestimmt: kein Parameter ist mehr als { FIXED($away_sigma, digits: 1) } Standardabweichungen von seinem Fehlen entfernt
gap-wanted-livelier = mindestens { SIGNIFICANT($least_sigma, digits: 2) }; ein längerer oder lebhafterer Lauf zeigt mehr
gap-not-closed = { $effect } schließt { PERCENT($closure) } % der Abweichung ({ FIXED($gap_before, digits: 3) } vorher, { FIXED($gap_after, digits: 3) } nachher; Rauschen ist 1)
gap-wanted-closed = ein Effekt, der die Abweichung sicher verkleinert; `heft diagnose` nennt solche
gap-other-cell = eine Aufzeichnung der Zelle „{ $found }“
gap-wanted-cell = „{ $cell }“, deren Zwilling geändert werden soll
gap-other-joints = eine Aufzeichnung von { $joints } Gelenken
gap-wanted-joints = { $joints }, wie in der Zelle „{ $cell }“
gap-of-other-robot = eine Aufzeichnung eines anderen Roboters
gap-wanted-robot = eine des Roboters der Zelle '{ $cell }'
gap-wanted-addable = ein Effekt, den ein Zwilling aufnehmen kann
gap-earlier-version =
    .found = eine Diagnose einer früheren Version
    .expected = eine mit allem, was ein Zwilling braucht; untersuchen Sie die Aufzeichnung noch einmal
gap-not-named =
    .found = „{ $name }“
    .expected = einer, den die Diagnose nennt: { $names }
gap-names-none =
    .found = „{ $name }“
    .expected = einer, den die Diagnose nennt: sie nennt keinen

# Which effects were asked for.
gap-effect-asked = Effekt
gap-not-on-wrench =
    .found = „{ $name }“, { $title }: wirkt nicht auf Kraft und Moment
    .expected = ein Effekt, der darauf wirkt
gap-no-such-effect =
    .found = „{ $name }“
    .expected = { $wanted }
gap-too-many-effects =
    .found = { $count } Effekte auf einmal
    .expected = einer, oder zwei oder drei mit Pluszeichen dazwischen; fügen Sie die anderen danach hinzu
gap-one-is-enough =
    .found = mit beiden nicht mehr erklärt als mit { $best } allein
    .expected = „{ $best }“, falls das gemeint war
gap-says-nothing =
    .found = eine Aufzeichnung, die nichts über eine Abweichung sagt ({ $reason })
    .expected = eine von einem ganzen Lauf

# A proposed experiment and the recording that it continues.
gap-cell = Zelle { $cell }
gap-other-robot =
    .found = ein anderer Roboter als der der Aufzeichnung
    .expected = die Zelle der Aufzeichnung
gap-other-recording =
    .found = eine Aufzeichnung mit der SHA-256 { $found_sha256 }…
    .expected = die, für die der Versuch vorgeschlagen wurde, { $sha256 }…; nennen Sie ihren Ordner mit --recording
gap-contact = { FIXED($begin_s, digits: 1) } bis { FIXED($end_s, digits: 1) } s (bis { FIXED($most_n, digits: 0) } N)
gap-contacts = Etwas hat die Last { $count ->
    [one] { "" }
   *[other] { $count }-mal{ " " }
 }berührt, und das erklärt die Abweichung: { $contacts }.
gap-contacts-beside = Der Rest der Aufzeichnung zeigt außerdem { $effects }.
gap-contacts-rest = Außerhalb davon bleibt eine Abweichung vom { FIXED($gap, digits: 1) }-Fachen des Rauschens, die kein bekannter Effekt erklärt.
gap-contacts-left-out = die { PERCENT($share, digits: 0) } % der Aufzeichnung, in denen etwas die Last berührt hat: Last und verbleibende Abweichung sind die des Rests
gap-contact-passes = eine Berührung geht vorüber; die Simulation kann sie nicht wiederholen
