# The certificate of a run: one page for the record.
certificate-title = Certificate of payload identification
certificate-not-stated = not stated
certificate-payload = Payload
certificate-sensor = Sensor
certificate-sensor-in-frame = { $name }, frame '{ $frame }', range { $range }
certificate-calibration = Calibration
certificate-calibration-stated = { $source }: gain u = { $gain }, cross-talk u = { $crosstalk } of the range
certificate-calibration-assumed = { $size } (assumed)
certificate-recording = Recording (SHA-256)
certificate-version = Heft { $version }
# Values
certificate-values = Values with uncertainty
certificate-symbol = Quantity
certificate-value = Value
certificate-expanded = U (95 %)
certificate-repeatability = U, type A
certificate-unit = Unit
certificate-mostly = Largest contributions (share of the variance)
certificate-contribution = { $source } { PERCENT($share) } %
certificate-not-determined = not determined
certificate-reason = { $names } not determined: { $reason }
certificate-frame = Of all that the sensor carries, in the sensor frame '{ $frame }': mass m, centre of mass c, inertia I about the centre of mass. U = { FIXED($factor, digits: 2) } u is the expanded uncertainty of a coverage interval of 95 %, all sources together (types A and B, JCGM 100:2008); beside it that of the repeatability alone (type A).
certificate-workpiece = Without { $tools }: m = { $mass }; c = { $com }; I = { $inertia }.
certificate-workpiece-unknown = Without { $tools }: not determined.
certificate-twin = Effects taken into account, as the cell's twin has them: { $effects }.
# What was assumed
certificate-remarks = Assumptions and remarks
certificate-no-remarks = No assumption that matters, no warning.
certificate-no-budget = the result is of an earlier version: its uncertainty is the repeatability alone (type A), and that of the sensor's calibration is not in it
# Statement of conformity
certificate-conformity = Statement of conformity
certificate-conforms = Conforms.
certificate-conforms-to-assumed = Conforms to an assumed threshold.
certificate-not-shown = Conformity is not shown.
certificate-not-judged-at-all = No statement.
certificate-margin = Margin: a factor of { SIGNIFICANT($margin, digits: 2) } on every uncertainty.
certificate-rule = Decision rule (JCGM 106:2012, ISO/IEC Guide 98-4): conformity is stated where the error of the values stays below every threshold of the cell, at every time of the motion, with a probability of at least { PERCENT($probability) } % (risk of wrong acceptance at most { PERCENT($risk) } %). Computed with { $draws } draws from the covariance, all sources together, along { FIXED($motion_s, digits: 0) } s of motion as brisk as the cell's limits allow.
certificate-no-cell = The cell is not at hand, so its thresholds are not known.
certificate-nothing-identified = Nothing was identified.
certificate-not-judged = The cell cannot be used: { $reason }
# Acceptance
certificate-acceptance = Acceptance
certificate-place = Place, date
certificate-signature = Name, signature
certificate-data = The same as data: JSON, format { $format }, SHA-256
certificate-disclaimer = Heft is not a safety function (safety_rated: false), and this is not a calibration certificate: the values are as traceable as the calibration of the sensor that is named above.
# What the command cannot do
certificate-nothing-asked =
    .found = neither --json nor --pdf
    .expected = at least one of them: where to write the certificate
