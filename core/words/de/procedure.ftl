procedure-interrupted = nach { FIXED($moved_s, digits: 1) } s Bewegung unterbrochen; der Roboter wurde gestoppt.
procedure-interrupted-recorded = nach { FIXED($moved_s, digits: 1) } s Bewegung unterbrochen; der Roboter wurde gestoppt, die Aufzeichnung bis dahin steht in { $folder }.
