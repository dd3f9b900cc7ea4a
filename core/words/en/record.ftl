# What a report says of itself.
record-date = Date
record-run = Run
record-order = Order
record-work-order = Work order
record-serial-number = Serial number
record-operator = Released by
record-accepted = Accepted by
record-not-accepted = not accepted
record-cell = Cell
record-software = Software
record-plan = Plan (SHA-256)
