zone-unknown = zone of cell "{ $cell }": there is none called "{ $zone }". List what there is and ask again.
zone-measured-before = zone "{ $zone }": measured at { $measured_at }, but its place at { $known_at } is known already; send measurements in order
zone-clock-ahead = measured_at: { $measured_at } is ahead of the service's clock, { $now }; set the measuring clock
zone-not-moved = zone "{ $zone }": is where the cell's file has it; there is nothing to undo
zone-moved-on = zone "{ $zone }": has moved { $moves } times, not { $seen_moves }; look where it is now and ask again
zone-not-looked-at = zones of { $cell }: nothing was looked at; send it again
