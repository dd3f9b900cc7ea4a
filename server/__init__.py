"""The service round the engine: people and machines told apart, the procedure as a job, everything that happened on record."""
