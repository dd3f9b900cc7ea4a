store-unavailable = the database is locked, full or away; nothing was changed. Try again; if it stays so, see the service's log
store-release-waits = release: the database is locked, full or away, and nothing moves without it; release again when it is back
store-release-not-taken = release: the database did not take it, so nothing moves; the run was ended
store-resume-waits = resume: the database is locked, full or away, and nothing begins to move without it; resume when it is back
store-result-not-there = run { $run }: the database does not have its result yet; accept it again in some seconds
