"""Verb phrases of motion: of the robot or a thing, to a place, by a measure, to a side."""

import random
from dataclasses import dataclass
from typing import Callable, Sequence

from . import words
from .clauses import Clauses
from .framewords import GOALS, HEADINGS, MOVERS, TURNERS
from .nouns import Nouns
from .trees import Node

Form = Callable[[str], Node]


@dataclass(frozen=True)
class Motion:
    """Builds the frames of motion."""

    chooser: random.Random
    nouns: Nouns
    clauses_of: Clauses

    def maybe(self, chance: float) -> bool:
        return self.chooser.random() < chance

    def any(self, options: Sequence[str]) -> str:
        return self.chooser.choice(options)

    def oblique(self, preposition: str, inner: Node) -> Node:
        return self.nouns.marked(preposition, inner)

    def going(self, form: Form) -> Node:
        """ "go to the kitchen", "come here", "go back to the table", "go out of the room"."""
        verb = form(self.any(MOVERS) if self.maybe(0.85) else self.any(self.nouns.lexicon.intransitive))
        draw = self.chooser.random()
        if draw < 0.1:
            return verb.post(
                "advmod", words.adverb(self.any("back home there here upstairs downstairs outside away".split()))
            )
        if draw < 0.13:
            there = words.adverb("there").pre("advmod", words.adverb(self.any(("over", "back", "up", "down"))))
            return verb.post("advmod", there)
        if draw < 0.24:
            verb = verb.post(
                "advmod",
                words.adverb(self.any("back back back over straight forward down up away quickly slowly".split())),
            )
        if draw > 0.93:
            return verb.post("obl", self.nouns.side())
        goal = (
            self.nouns.person() if self.maybe(0.1) else self.nouns.place() if self.maybe(0.55) else self.nouns.fixture()
        )
        goal = self.nouns.located(goal, 0.12) if goal.upos == "NOUN" else goal
        verb = verb.post("obl", self.oblique(self.any(GOALS), goal))
        if self.maybe(0.07):
            verb = verb.post("obl", self.oblique(self.any("from through via in by".split()), self.nouns.fixture()))
        elif self.maybe(0.03):
            crossing = words.gerund(self.any("cross pass use follow enter open".split())).post(
                "obj", self.nouns.fixture()
            )
            verb = verb.post("advcl", crossing.pre("mark", words.word("by/SCONJ")))
        return verb

    def turning(self, form: Form) -> Node:
        """ "turn left 120 degrees", "turn ninety degrees to the left", "rotate by 30 degrees"."""
        verb = form(self.any(TURNERS))
        draw = self.chooser.random()
        side = words.adverb(self.any("left right left right left right around back clockwise counterclockwise".split()))
        toward = words.noun(self.any(("left", "right"))).pre("det", words.word("the"))
        if self.maybe(0.25):
            toward = words.noun(toward.form).pre("nmod:poss", words.word("your"))
        toward = toward.pre("case", words.adposition(self.any(("to", "to", "to", "towards"))))
        measure = self.nouns.measure("turn")
        if draw < 0.25:
            verb = verb.post("advmod", side)
        elif draw < 0.5:
            verb = verb.post("advmod", side).post("obl:unmarked", measure)
        elif draw < 0.58:
            verb = verb.post("advmod", side).post("obl", measure.pre("case", words.adposition("by")))
        elif draw < 0.66:
            verb = verb.post("obl:unmarked", measure)
        elif draw < 0.76:
            verb = verb.post("obl:unmarked", measure).post("advmod", side)
        elif draw < 0.86:
            verb = verb.post("obl:unmarked", measure).post("obl", toward)
        elif draw < 0.94:
            verb = verb.post("obl", toward)
        elif draw < 0.97:
            verb = verb.post("obl", toward).post("obl", measure.pre("case", words.adposition("by")))
        else:
            verb = verb.post("advmod", side).post(
                "obl", self.oblique(self.any(("at", "into", "towards")), self.nouns.fixture())
            )
        return verb

    def shifting(self, form: Form) -> Node:
        """ "move forward 3 feet", "go two metres back", "move backwards by one metre"."""
        verb = form(self.any(MOVERS) if self.maybe(0.85) else self.any("back drift slide reverse hop jump".split()))
        heading = words.adverb(self.any(HEADINGS))
        measure = self.nouns.measure("move")
        draw = self.chooser.random()
        if draw < 0.18:
            return verb.post("advmod", heading)
        if draw < 0.55:
            return verb.post("advmod", heading).post("obl:unmarked", measure)
        if draw < 0.64:
            return verb.post("advmod", heading).post("obl", measure.pre("case", words.adposition("by")))
        if draw < 0.8:
            return verb.post("obl:unmarked", measure).post("advmod", heading)
        if draw < 0.86:
            return verb.post("obl:unmarked", measure)
        if draw < 0.9:
            return form("back").post("compound:prt", words.particle("up")).post("obl:unmarked", measure)
        if draw < 0.94:
            bit = words.noun("bit").pre("det", words.word("a"))
            if self.maybe(0.5):
                bit = bit.near("amod", words.adjective("little"))
            return verb.post("advmod", heading).post("obl:unmarked", bit)
        goal = (
            self.nouns.side()
            if self.maybe(0.4)
            else self.oblique(self.any(("towards", "to", "into")), self.nouns.fixture())
        )
        return verb.post("obl:unmarked", measure).post("obl", goal)

    def shifting_thing(self, form: Form) -> Node:
        """ "move the arm up 10 cm", "raise your left arm", "push the box two metres to the right"."""
        verb = form(
            self.any("move move raise lower lift push pull slide turn rotate tilt drive shift bend extend".split())
        )
        part = words.noun(
            self.any("arm arm hand head gripper camera base leg wrist torso elbow neck finger body wheel".split())
        )
        if self.maybe(0.25):
            part = part.pre("amod", words.adjective(self.any(("left", "right", "upper"))))
        draw = self.chooser.random()
        if draw < 0.5:
            part = part.pre("nmod:poss", words.word("your")) if self.maybe(0.5) else part.pre("det", words.word("the"))
        elif draw < 0.7:
            part = self.nouns.thing()
        verb = verb.post("obj", part)
        if self.maybe(0.65):
            verb = verb.post(
                "advmod", words.adverb(self.any("up up down down left right forward back backwards".split()))
            )
        if self.maybe(0.5):
            measure = self.nouns.measure("move" if self.maybe(0.7) else "turn")
            if self.maybe(0.25):
                verb = verb.post("obl", measure.pre("case", words.adposition("by")))
            else:
                verb = verb.post("obl:unmarked", measure)
        elif self.maybe(0.2):
            verb = verb.post("obl", self.nouns.side())
        return verb
