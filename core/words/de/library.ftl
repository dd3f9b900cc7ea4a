library-unknown = Werkzeugbibliothek der Zelle „{ $cell }“: es gibt nichts mit der Kennung „{ $saved }“. Sehen Sie nach, was es gibt, und versuchen Sie es noch einmal.
library-name-taken = Name: „{ $name }“ ist in der Zelle „{ $cell }“ schon vergeben, an { $by ->
    [obstacle] ein Hindernis
    [zone] eine Schutzzone
    [tool] ein Werkzeug aus cell.toml
    [payload] eine Last aus cell.toml
   *[saved] eine Last der Werkzeugbibliothek
}; wählen Sie einen anderen
library-full = Werkzeugbibliothek der Zelle „{ $cell }“: sie enthält schon { $most_saved } Lasten; löschen Sie eine, die nicht mehr gebraucht wird
library-run-of-other-cell = Lauf „{ $run }“: gehört nicht zur Zelle „{ $cell }“; speichern Sie das Ergebnis in der Zelle, in der er gemacht wurde
library-without-box = Quader: nichts sagt, was „{ $name }“ sicher enthält; geben Sie an, wie groß er ist und wo er vom Sensor aus liegt
library-mass-range =
    .found = { SIGNIFICANT($least_kg, digits: 6) } kg
    .expected = höchstens das obere Ende des Bereichs, { SIGNIFICANT($most_kg, digits: 6) } kg
