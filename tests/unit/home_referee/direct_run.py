"""Commands in a home without ROS: the pipeline from text to candidates, and the skills of the home's servers.

It is quick, for work on the skills. What counts is the live graph: there the robot also resolves what words refer to,
and asks.
"""

import sys
from typing import Any, List, Sequence, Tuple

from home_servers.body import CannotDo, Interrupted
from home_servers.frames import FRAMES, STATEMENTS
from home_servers.skills import Skills
from offline_pipeline.knowledge import load_knowledge, shipped_domains
from offline_pipeline.pipeline import Pipeline, Understanding
from roboframenet_sim.home_arranging import arranged
from roboframenet_sim.home_engine import Home
from roboframenet_sim.home_file import load_home_file
from roboframenet_sim.home_floor import Floor
from roboframenet_sim.home_state import NO_FAULTS, Faults
from roboframenet_sim.home_truth import truth_of
from roboframenet_testing.workspace import package
from semantic_frames.server_statement import stated_profile

from .annotated import HOME_FILE
from .commands import Command
from .judging import ROBOT, Run, Saying
from .walking import Walk

sys.path.append(str(package("home_servers") / "test" / "unit"))
from direct_body import DirectBody  # it is beside the tests of home_servers

#: A command takes no longer; seconds.
_MOST_S = 900.0


class _Body(DirectBody):  # type: ignore[misc] (it has no types)
    """A body whose referee lets the person walk who is followed."""

    def __init__(self, home: Home, walk: Walk, **values: Any) -> None:
        self.reasons: List[str] = []
        self._walk = walk
        super().__init__(home, **values)

    def do(self, action: Any) -> Any:
        order = self._walk.order(truth_of(self.home.plan, self.home.state))
        if order:
            self.home.tell_person(*order.split())
        if self._walk.is_over:
            raise Interrupted("the referee ends it")
        failure = super().do(action)
        if failure is not None:
            self.reasons.append(failure.sentence)
        return failure


class DirectRun:
    """Carries commands out.

    Args:
        speaker: id of the person who speaks
        seed: of persons and faults
        faults: of the home
        servers: each of them carries out all frames of the home
    """

    def __init__(
        self, *, speaker: str, seed: int = 0, faults: Faults = NO_FAULTS, servers: Sequence[str] = ("home",)
    ) -> None:
        knowledge = load_knowledge([shipped_domains()])
        for frame in FRAMES:
            for server in servers:
                assert knowledge.graph.register(frame, server, stated_profile(STATEMENTS.get(frame, {}))) == ()
        self._pipeline = Pipeline(knowledge)
        self._speaker, self._seed, self._faults = speaker, seed, faults
        self._plan, self._state = load_home_file(HOME_FILE)
        self._floor = Floor(self._plan)
        self._count = 0

    def run(self, command: Command) -> Run:
        """Carry a command out in a home that is arranged for it."""
        body, walk = self.body_for(command)
        plan, home = self._plan, body.home
        before = truth_of(plan, home.state)
        outcome, sentence = self._carry_out(command.text, Skills(body, speaker=self._speaker))
        after = truth_of(plan, home.state)
        said = [Saying(one.what, one.to) for one in home.state.events if one.kind == "said" and one.who == ROBOT]
        return Run(command, before, after, tuple(said), outcome, sentence, tuple(body.reasons), walk.is_over)

    def body_for(self, command: Command) -> Tuple[DirectBody, Walk]:
        """Return a body in a home that is arranged for a command, and who walks there."""
        self._count += 1
        plan, state = self._plan, self._state
        home = Home(plan, state, seed=self._seed + self._count, faults=self._faults, floor=self._floor)
        home.start_anew(arranged(plan, home.floor, state, command.arranged))
        walk = Walk(command)
        return _Body(home, walk, most_s=_MOST_S), walk

    def understand(self, text: str) -> Understanding:
        """Return the candidates of a command, or the reply."""
        return self._pipeline.understand(text)

    def _carry_out(self, text: str, skills: Skills) -> Tuple[str, str]:
        understanding = self.understand(text)
        if understanding.reply.outcome != "DONE":
            return understanding.reply.outcome, understanding.reply.sentence
        for candidates in understanding.candidates:
            reason = ""
            for candidate in candidates:
                try:
                    for frame in candidate.frames:
                        FRAMES[frame.name](skills, frame)
                        skills.tidy()
                    reason = ""
                    break
                except CannotDo as cannot:
                    reason = str(cannot)
                except Interrupted as interrupted:
                    return "FAILED", str(interrupted)
            if reason:
                return "FAILED", reason
        return "DONE", "Done."
