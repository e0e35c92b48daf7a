"""20 servers for 6 frames: some depend on the place or the thing, some break, some are mended.

Everything is drawn from the seed before any policy runs, and whether a server succeeds at a command is drawn once for
all policies: they differ only by their orders. The numbers were chosen once, before the policies were compared.
"""

import random
from dataclasses import dataclass
from typing import Dict, FrozenSet, List, Tuple

from arbitrator.plan import Candidate
from typed_arguments import FilledFrame, TypedArgument

COMMANDS = 1000
PLACES = ("kitchen", "office", "hall")
KINDS = ("cup", "glass", "plate")
FRAMES = ("pointing", "waving", "approaching", "grasping", "bringing", "clearing")
SERVERS = 20
#: The command before which servers break or are mended.
DRIFTS = (400, 700)
#: Frames that may also be carried out by two others.
SEQUENCES = {"bringing": ("approaching", "grasping"), "clearing": ("pointing", "grasping")}
#: A server that has broken succeeds at most so often.
MOST_BROKEN = 0.1
_STAYS = 0.8


@dataclass(frozen=True)
class Request:
    """A command: a frame, a thing, and where the robot is."""

    number: int
    frame: str
    kind: str
    place: str


class Home:
    """The servers of one seed, and how often each of them succeeds."""

    def __init__(self, seed: int) -> None:
        self._seed = seed
        chance = random.Random(seed)
        self.servers: Dict[str, List[str]] = {frame: [] for frame in FRAMES}
        for number in range(SERVERS):
            # Each frame gets its share; the last two serve one more.
            self.servers[FRAMES[number % len(FRAMES)]].append(f"server_{number:02d}")
        for name in ("server_18", "server_19"):
            frame = chance.choice([frame for frame in FRAMES if name not in self.servers[frame]])
            self.servers[frame].append(name)
        for servers in self.servers.values():
            chance.shuffle(servers)
        pairs = [(frame, server) for frame in FRAMES for server in self.servers[frame]]
        self._rates: Dict[Tuple[str, str, str, str], float] = {}
        self._times: Dict[Tuple[str, str], float] = {}
        for pair in pairs:
            self._draw(pair, chance)
        self._changes = self._drifts(pairs, chance)
        self._sequences_first = {frame: chance.random() < 0.5 for frame in SEQUENCES}
        self.requests = self._requests(chance)

    def _draw(self, pair: Tuple[str, str], chance: random.Random) -> None:
        base = chance.choice([chance.uniform(0.85, 0.99), chance.uniform(0.5, 0.85), chance.uniform(0.05, 0.5)])
        weak_place = chance.choice(PLACES) if chance.random() < 0.4 else ""
        weak_kind = chance.choice(KINDS) if chance.random() < 0.3 else ""
        for place in PLACES:
            for kind in KINDS:
                rate = base * (0.15 if place == weak_place else 1.0) * (0.15 if kind == weak_kind else 1.0)
                self._rates[(*pair, place, kind)] = rate
        self._times[pair] = chance.uniform(2.0, 20.0)

    def _drifts(self, pairs: List[Tuple[str, str]], chance: random.Random) -> Dict[int, Dict[Tuple[str, str], float]]:
        """At each drift, the best server of three frames breaks, and a poor server of the others is mended."""
        found: Dict[int, Dict[Tuple[str, str], float]] = {}
        for moment in DRIFTS:
            frames = list(FRAMES)
            chance.shuffle(frames)
            found[moment] = {}
            for number, frame in enumerate(frames):
                of_frame = sorted(
                    ((self._mean(pair, found), pair) for pair in pairs if pair[0] == frame), reverse=number < 3
                )
                found[moment][of_frame[0][1]] = (
                    chance.uniform(0.0, MOST_BROKEN) if number < 3 else chance.uniform(0.9, 0.99)
                )
        return found

    def _mean(self, pair: Tuple[str, str], changes: Dict[int, Dict[Tuple[str, str], float]]) -> float:
        for moment in sorted(changes, reverse=True):
            if pair in changes[moment]:
                return changes[moment][pair]
        rates = [self._rates[(*pair, place, kind)] for place in PLACES for kind in KINDS]
        return sum(rates) / len(rates)

    def _requests(self, chance: random.Random) -> List[Request]:
        found, place = [], chance.choice(PLACES)
        for number in range(COMMANDS):
            place = place if chance.random() < _STAYS else chance.choice(PLACES)
            found.append(Request(number, chance.choice(FRAMES), chance.choice(KINDS), place))
        return found

    def rate(self, request: Request, pair: Tuple[str, str]) -> float:
        """Return how often a server succeeds with a frame when this is asked."""
        for moment in sorted(self._changes, reverse=True):
            if request.number >= moment and pair in self._changes[moment]:
                return self._changes[moment][pair]
        return self._rates[(*pair, request.place, request.kind)]

    def broken(self, drift: int) -> FrozenSet[Tuple[str, str]]:
        """Return the frames with the servers that break at a drift."""
        return frozenset(pair for pair, rate in self._changes[drift].items() if rate <= MOST_BROKEN)

    def attempt(self, request: Request, pair: Tuple[str, str], time: int) -> Tuple[bool, float]:
        """Return whether a server succeeds the n-th time in a command, and how long it takes, seconds."""
        chance = random.Random(f"{self._seed} {request.number} {pair} {time}")
        return chance.random() < self.rate(request, pair), self._times[pair] * chance.uniform(0.7, 1.3)

    def candidates(self, request: Request) -> List[Candidate]:
        """Return the candidates of a command, in the order of a registrar."""

        def frame(name: str, server: str) -> FilledFrame:
            thing = TypedArgument(name="theme", text=f"the {request.kind}", lemma=request.kind)
            return FilledFrame(name=name, arguments=(thing,), server=server)

        found = [Candidate((frame(request.frame, server),)) for server in self.servers[request.frame]]
        if request.frame not in SEQUENCES:
            return found
        first, second = SEQUENCES[request.frame]
        longer = [
            Candidate((frame(first, one), frame(second, other)))
            for one in self.servers[first]
            for other in self.servers[second]
        ]
        return longer + found if self._sequences_first[request.frame] else found + longer
