xacro-declaration =
    .found = ein Dokumenttyp oder eine Entität
    .expected = eine URDF- oder xacro-Datei ohne sie
xacro-arguments-of-urdf =
    .found = eine einfache URDF mit --xacro-arg
    .expected = eine xacro-Datei, oder keines dieser Argumente
xacro-too-slow =
    .found = xacro, das nach { FIXED($limit_s, digits: 0) } s nicht ausgeführt ist
    .expected = eine xacro-Datei, die ein Ende hat
xacro-ended =
    .found = xacro, das sich nicht ausführen lässt (der Prozess endete mit { $status }: Zeit oder Speicher)
    .expected = eine xacro-Datei, die weniger davon braucht
xacro-not-expanded =
    .found = xacro, das sich nicht ausführen lässt ({ $reason })
    .expected = xacro, die Argumente als --xacro-arg NAME:=VALUE angegeben
xacro-unwanted =
    .found = xacro, das { $wanted } verlangt
    .expected = kein $(eval ...); Dateien in seinem Ordner oder einem --package-path DIR

xacro-wants-package = $(find { $name })
xacro-wants-eval = $(eval ...)
xacro-wants-attribute = das Attribut { $name } in einem Ausdruck
xacro-wants-name = den Namen { $name } in einem Ausdruck
xacro-wants-file = die Datei { $file }
xacro-wants-system = { $event }
xacro-long-expression = einen Ausdruck von { $characters } Zeichen
xacro-long-urdf = { $characters } Zeichen URDF
