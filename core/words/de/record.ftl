# Was ein Bericht über sich selbst sagt.
record-date = Datum
record-run = Lauf
record-order = Auftrag
record-work-order = Fertigungsauftrag
record-serial-number = Seriennummer
record-operator = Freigegeben von
record-accepted = Angenommen von
record-not-accepted = nicht angenommen
record-cell = Zelle
record-software = Software
record-plan = Plan (SHA-256)
