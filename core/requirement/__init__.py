"""How exactly a robot's controller has to know its payload, and whether an answer is good enough for it."""
