# The score sheet of blind trials, and its pictures
sheet-title = Blind trials
sheet-command = `heft trial --seeds { $seeds }` ({ $count ->
        [one] 1 trial
       *[other] { $count } trials
    }, Heft { $versions }).
sheet-how = Faults are planted by code that shares nothing with the effects; every answer was sealed (its hash printed) before the first diagnosis. Shares stand with their 95 % intervals (Wilson). A fault counts when it is material and at least { FIXED($sigma, digits: 0) } sigma from nothing (`core/trial/judgement.py`). How far a fault is from nothing comes from simulating each run again without it; how far from its nearest rival, from fitting the rivals to what the true effect predicts.
sheet-by-kind = By kind
sheet-by-effect = By effect
sheet-not-right = Not right
sheet-all-right = None.
sheet-confusion-numbers = Confusion in numbers

# The figures
sheet-figure = figure
sheet-wanted = wanted
sheet-here = here
sheet-share = { FIXED($percent, digits: 1) } % ({ $hits } of { $of }; { FIXED($low_percent, digits: 0) }-{ FIXED($high_percent, digits: 0) } %)
sheet-error-by-chance = { $error } (by chance { $low }-{ $high }, were each right as often as it says)
sheet-none-drawn = none drawn
sheet-none = none
sheet-false-alarms = false alarms on runs without effect
sheet-one-fault-outright = one fault: told outright (explained by its name alone, or read off beside no gap)
sheet-one-fault = one fault: named, and nothing else
sheet-one-fault-or-tie = the same with declared ties
sheet-one-fault-after = the same after the proposed motion ({ $count } asked for one)
sheet-verdicts = verdict of the right kind: no gap, a name or unknown
sheet-near-rival = nearest rival below { FIXED($sigma, digits: 0) } sigma: truth in the declared set
sheet-far-rival = nearest rival above { FIXED($sigma, digits: 0) } sigma: one name, the right one
sheet-calibration-first = calibration error of the first answer
sheet-calibration-all = calibration error of all classes from 1 %
sheet-unknown-as-unknown = unknown called unknown
sheet-exact-pair = two at once: the exact pair
sheet-parameter-error = parameter error, median of { $count }
sheet-parameters-covered = 95 % intervals of parameters hold the truth
sheet-closure-ratio = closure over the true effect's, median
sheet-closure-ratio-low = closure over the true effect's, 10th percentile
sheet-payload-before = payload error before, median over answered trials
sheet-payload-after = payload error after
sheet-payload-covered = 95 % intervals of the payload hold the truth
sheet-seconds = diagnosis on one core, median
sheet-the-noise = the noise: { $stated }

# By kind and by effect
sheet-kind = kind
sheet-kind-none = none
sheet-kind-single = single
sheet-kind-double = double
sheet-kind-unknown = unknown
sheet-trials = trials
sheet-count = count
sheet-right-of-counting = right of those that count
sheet-right-of-all = right of all
sheet-immaterial = immaterial
sheet-no-answer = no answer
sheet-effect = effect
sheet-named = named, material or not
sheet-halfway-size = size named in half the trials
sheet-halfway-sigma = the same in sigma from nothing
sheet-below = below { SIGNIFICANT($size, digits: 2) }
sheet-above = above { SIGNIFICANT($size, digits: 2) }

# What was not right
sheet-planted-faults = { $faults }, size { FIXED($size) }
sheet-planted-faults-at-sigma = { $faults }, size { FIXED($size) }, { FIXED($sigma, digits: 0) } sigma (material from { FIXED($material_sigma, digits: 0) })
sheet-failure = { $fault }, { $cell }, { $payload }: { $answer }
sheet-answer-beside = { $answer }, beside it { $effects }
sheet-answer-gap = { $answer }, gap { FIXED($before) } to { FIXED($after) }
sheet-does-not-count = { $line } (does not count)
sheet-verdict-no-gap = no_gap
sheet-verdict-explained = explained
sheet-verdict-ambiguous = ambiguous
sheet-verdict-unknown = unknown
sheet-verdict-not-enough = not_enough
sheet-verdict-stopped = stopped

# Pictures
sheet-confusion = Planted against answered, single faults that count
sheet-calibration = Calibration
sheet-closure = How far the gap closes
sheet-detection = What can be seen, and was
sheet-planted = planted
sheet-answered = answered
sheet-times = times
sheet-most-probable-class = most probable class
sheet-every-class = every class from 1 %
sheet-probability-given = probability given (numbers: answers)
sheet-share-right = share right
sheet-closure-of-truth = closure of the true effect
sheet-closure-of-first = closure of the first name
sheet-distance-from-nothing = distance from nothing, sigma (filled: named; dashed: 3 sigma)
