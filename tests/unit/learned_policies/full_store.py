"""How long `learned` orders candidates when the store is full: everything that may be kept is known."""

import os
import random
import tempfile
import time
from typing import List

from arbitrator.plan import Candidate
from arbitrator.policy import LearnedPolicy, order
from experience.known import MOST_SUBJECTS
from experience.memory import Memory
from experience.snapshot import Snapshot
from experience.store import Store
from experience.trial import Circumstances, Outcome, Trial, kinds_of, referents_of
from typed_arguments import FilledFrame, TypedArgument

#: Trials that the node keeps.
FULL_STORE = 10_000
#: Servers of each frame; a sequence of two frames has the square of them as candidates.
_SERVERS = 4
_FRAMES = tuple(f"frame_{number}" for number in range(MOST_SUBJECTS // _SERVERS))
_PLACES, _KINDS, _THINGS = 8, 12, 40


def ordering_with_a_full_store(orderings: int = 2000) -> List[float]:
    """Return the processor time of orderings, seconds: clauses with up to 20 candidates, of known servers."""
    chance = random.Random(1)
    with tempfile.TemporaryDirectory() as folder:
        store = Store(os.path.join(folder, "full.sqlite"), most_trials=FULL_STORE)
        store.add([_trial(chance) for _ in range(FULL_STORE)])
        kept = store.trials()
        store.close()
    assert len(kept) == FULL_STORE
    experience = Memory(kept).experience
    assert len(experience.records) == MOST_SUBJECTS
    policy, found = LearnedPolicy(), []
    for _ in range(orderings):
        policy.learn(Snapshot(experience, (), frozenset(_FRAMES[::2]), _place(chance)))
        first, second = chance.sample(_FRAMES, 2)
        thing = _thing(chance)
        candidates = [Candidate((_frame(first, one, thing),)) for one in range(_SERVERS)]
        candidates += [
            Candidate((_frame(first, one, thing), _frame(second, other, thing)))
            for one in range(_SERVERS)
            for other in range(_SERVERS)
        ]
        began_s = time.thread_time()
        order(candidates, policy)
        found.append(time.thread_time() - began_s)
    return found


def _trial(chance: random.Random) -> Trial:
    frame = _frame(chance.choice(_FRAMES), chance.randrange(_SERVERS), _thing(chance))
    about = Circumstances(kinds_of(frame.arguments), referents_of(frame.arguments), _place(chance))
    outcome = chance.choice((Outcome.SUCCEEDED, Outcome.FAILED))
    return Trial("c", "Bring me the cup.", 0.0, frame.name, frame.server, "", about, 4.0, outcome)


def _frame(name: str, server: int, thing: TypedArgument) -> FilledFrame:
    return FilledFrame(name=name, arguments=(thing,), server=f"/{name}_{server}")


def _thing(chance: random.Random) -> TypedArgument:
    number = chance.randrange(_THINGS)
    kind = f"kind_{number % _KINDS}"
    return TypedArgument(name="theme", text=f"the {kind}", lemma=kind, referents=(f"thing_{number}",), referent_count=1)


def _place(chance: random.Random) -> str:
    return f"room_{chance.randrange(_PLACES)}"
