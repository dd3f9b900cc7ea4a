# Was in der Zelle steht oder sich in ihr bewegt.
body-zone = Zone „{ $name }“
body-obstacle = Hindernis „{ $name }“
body-link = „{ $name }“
body-payload = Last
body-floor = Boden
