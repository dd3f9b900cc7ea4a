"""One page for the record: what a finished run found, how certainly, and who answers for it."""
