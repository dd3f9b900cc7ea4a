# Blind trials
trial-dask-missing =
    .found = no package `distributed`
    .expected = it to be installed: pip install 'heft[dask]'
trial-no-scheduler =
    .found = no scheduler ({ $reason })
    .expected = the address of a running Dask scheduler
trial-not-a-run =
    .found = something that is not a run of trials
    .expected = a new name, or the folder of an earlier run
trial-no-payload =
    .found = no payload
    .expected = at least one, `[payloads.NAME]`, that the virtual robot is to carry
trial-line = { $file }, line { $line }
trial-bad-outcome =
    .found = no outcome of this version ({ $count ->
        [one] 1 problem
       *[other] { $count } problems
    })
    .expected = a new folder
trial-seed = seed { $seed }
trial-other-seal =
    .found = the seal { $there } in the folder
    .expected = { $drawn }; take a new one
trial-failed = { $error }: { $reason }
trial-planted = { $faults }
trial-planted-nothing = nothing
trial-right = right
trial-right-does-not-count = right (does not count: too small, or another effect describes it)
trial-not-right = not right
trial-not-right-does-not-count = not right (does not count: too small, or another effect describes it)
