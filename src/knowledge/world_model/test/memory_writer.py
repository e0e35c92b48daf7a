"""Writes objects to a memory file until it is killed, and prints a line for each one that is stored."""

import itertools
import sys

from world_model import WorldObject
from world_model.knowledge import Change, Learned
from world_model.store import Store

store = Store(sys.argv[1])
first = len(store.load())
for number in itertools.count(first):
    store.write(Change({f"thing_{number}": Learned(WorldObject(f"thing_{number}"))}))
    print(number, flush=True)
