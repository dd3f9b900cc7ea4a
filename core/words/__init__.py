"""The catalogue of every message: what Heft has to say as a code with named parameters, and its words in each language."""
