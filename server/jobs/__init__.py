"""Work that takes a while and moves no robot: diagnoses, twins' additions, blind trials, proposed motions; their routes."""
