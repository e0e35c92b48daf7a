"""Writes trials until it is killed, and prints a line for each one that is stored."""

import sys

from experience.store import Store
from experience.trial import Circumstances, Outcome, Trial

store = Store(sys.argv[1])
while True:
    store.add([Trial("c", "Wave.", 1.0, "waving", "/arm", "waving by /arm", Circumstances(), 1.0, Outcome.SUCCEEDED)])
    print("stored", flush=True)
