zone-unknown = Zone der Zelle „{ $cell }“: keine heißt „{ $zone }“. Sehen Sie nach, welche es gibt, und versuchen Sie es noch einmal.
zone-measured-before = Zone „{ $zone }“: gemessen um { $measured_at }, aber ihr Ort um { $known_at } ist schon bekannt; senden Sie Messungen der Reihe nach
zone-clock-ahead = Zeit der Messung: { $measured_at } liegt vor der Uhr des Dienstes, { $now }; stellen Sie die Uhr der Messung
zone-not-moved = Zone „{ $zone }“: steht, wo die Datei der Zelle sie hat; es gibt nichts zurückzunehmen
zone-moved-on = Zone „{ $zone }“: wurde { $moves }-mal verschoben, nicht { $seen_moves }-mal; sehen Sie nach, wo sie jetzt ist, und fragen Sie noch einmal
zone-not-looked-at = Zonen von { $cell }: es wurde nichts geprüft; senden Sie die Anfrage noch einmal
