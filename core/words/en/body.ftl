# What stands in the cell or moves in it.
body-zone = zone "{ $name }"
body-obstacle = obstacle "{ $name }"
body-link = "{ $name }"
body-payload = payload
body-floor = floor
