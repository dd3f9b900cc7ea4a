flaw = { $where }: gefunden: { $found }, erwartet: { $expected }
    .found = { $found }
    .expected = { $expected }
text = { $text }
