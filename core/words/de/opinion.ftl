# Warum die zweite Prüfung von zwei Körpern verlangt, was sie verlangt, oder nichts.
opinion-clearance = der Abstand der Zelle
opinion-self-clearance = der Eigenabstand der Zelle
opinion-mounted-there = nie so weit auseinander wie der Abstand: der Roboter steht darauf
opinion-cannot-touch = sie können sich nicht berühren, wie ein Raster der Winkel zwischen ihnen zeigt
opinion-always-near = nie so weit auseinander wie der Eigenabstand
opinion-shapes-overlap = ihre Formen überschneiden sich bei jedem Winkel: das liegt am Bau
opinion-no-joint-between = kein Gelenk zwischen ihnen: sie bewegen sich nicht gegeneinander
opinion-declared-adjacent = in der Zelle so erklärt: robot.adjacent
opinion-neighbours = Nachbarn: ein Gelenk verbindet sie
