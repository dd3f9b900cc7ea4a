payload-not-ten-numbers =
    .found = { $values }
    .expected = ten finite numbers [{ $names }]
# Two runs side by side
payload-runs-nothing-in-common = The runs have no parameter in common, so they cannot be compared.
payload-runs-agree = No significant difference: one at least as large is seen in { PERCENT($chance) } % of repetitions with the same payload.
payload-runs-differ = The runs differ by more than chance ({ SIGNIFICANT($chance, digits: 1) }), most clearly in { $parameter } by { SIGNIFICANT($difference, digits: 3) } { $unit }, { FIXED($times, digits: 1) } times its uncertainty.
# A series of runs
payload-conditions-of-other-runs =
    .found = { $count ->
        [one] { $count } condition
       *[other] { $count } conditions
    }
    .expected = one for each of the { $runs } runs
payload-series-of-nothing =
    .found = runs that determine nothing
    .expected = at least one that determines the mass
payload-series-of-one = A single run: it agrees with itself. Give several to see how they scatter.
payload-series-agrees = The { $runs } runs agree: differences at least as large are seen in { PERCENT($chance) } % of series with the same payload.
payload-series-differs = The { $runs } runs scatter by more than they state (chance { SIGNIFICANT($chance, digits: 1) }); beyond that by { $scatter }. The mean's interval allows for it.
payload-scatter-mass = { SIGNIFICANT($std, digits: 2) } kg
payload-scatter-first-moment = { SIGNIFICANT($std, digits: 2) } kg m
payload-scatter-inertia = { SIGNIFICANT($std, digits: 2) } kg m2
payload-few-runs = the scatter between { $runs } runs is hardly known: five and more tell it
payload-one-condition = all runs count as made under one condition: name conditions (day, plan, robot) to see the reproducibility
payload-mostly-prior = more what was known before than what was measured: { $parameters }
