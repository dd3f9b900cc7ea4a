"""The gap between simulation and reality: where it lies, which effect causes it, how far it shrinks, what to do next."""
