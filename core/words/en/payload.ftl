payload-not-ten-numbers =
    .found = { $values }
    .expected = ten finite numbers [{ $names }]
# Two runs side by side
payload-runs-nothing-in-common = The runs have no parameter in common, so they cannot be compared.
payload-runs-agree = No significant difference: one at least as large is seen in { PERCENT($chance) } % of repetitions with the same payload.
payload-runs-differ = The runs differ by more than chance ({ SIGNIFICANT($chance, digits: 1) }), most clearly in { $parameter } by { SIGNIFICANT($difference, digits: 3) } { $unit }, { FIXED($times, digits: 1) } times its uncertainty.
