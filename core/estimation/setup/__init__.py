"""Whether a recording is what it says it is: signs, frames, axes, units and clock, before anything is estimated from it."""
