"""Every test, and every process that it starts, computes with one thread for linear algebra.

Its matrices are small: a second thread mostly waits for the first, at full speed, and takes the core from the test beside it.
"""

import os

for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"):
    os.environ.setdefault(name, "1")  # read by NumPy's and SciPy's libraries when they are loaded, which is after this
