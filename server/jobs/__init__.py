"""Work that takes a while and moves no robot: diagnoses, blind trials, proposed motions; their routes, and those of the twins, which take
what a diagnosis found."""
