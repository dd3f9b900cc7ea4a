# Bags von ROS und MCAP-Dateien.
bag-broken =
    .found = ein Bag, der sich nicht lesen lässt ({ $reason })
    .expected = eine vollständige MCAP-Datei, ein Bag von ROS 1 oder der Ordner eines Bags von ROS 2; `mcap recover` rettet einen abgebrochenen
bag-too-many-topics =
    .found = mehr als { $most } Topics
    .expected = ein Bag mit weniger; `ros2 bag convert` oder `mcap filter` wählt einige aus
