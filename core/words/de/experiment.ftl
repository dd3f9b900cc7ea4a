# Was als Nächstes gemessen werden soll.
experiment-swings = Drehung um die { $axis }-Achse des Sensors, waagrecht gehalten, { $down } nach unten: die Schwerkraft wandert durch den Sensor
experiment-tilted-holds = Halte mit der Schwerkraft längs vier Diagonalen des Sensorkoordinatensystems
experiment-revisit = der erste Halt noch einmal
experiment-both-sides = der erste Halt, von der einen und von der anderen Seite angefahren
experiment-wide-band = eine breitbandige Bewegung um alle Achsen zugleich, { SIGNIFICANT($lowest_hz) } bis { SIGNIFICANT($highest_hz) } Hz
experiment-other-posture = der erste Halt in einer anderen Haltung des Arms
experiment-second-payload = derselbe Lauf mit einer zweiten Last, deren Masse und Schwerpunkt bekannt sind: keine Bewegung mit dieser bringt die Erklärungen weiter auseinander als { FIXED($best_sigma, digits: 1) } Standardabweichungen

# Mängel.
experiment-name = das Experiment
experiment-without-stops =
    .found = keine Halte
    .expected = eine Bewegung; eine zweite Last wird von Hand angebracht und mit `heft run` gemessen
