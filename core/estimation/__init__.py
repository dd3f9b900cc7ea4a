"""From a recording to the payload's inertial parameters with their uncertainty; the paper's Algorithms 1 to 5 beside it."""
