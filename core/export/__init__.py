"""The payload as robot controllers and simulators take it: one file per target, and what each of them cannot hold."""
