"""Clauses that describe a state: "the oven is hot", "the keys are on the table"."""

import random
from dataclasses import dataclass
from typing import Sequence

from . import words
from .nouns import Nouns
from .trees import Node


@dataclass(frozen=True)
class Clauses:
    """Builds finite clauses over the noun phrases of ``nouns``."""

    chooser: random.Random
    nouns: Nouns

    def maybe(self, chance: float) -> bool:
        return self.chooser.random() < chance

    def any(self, options: Sequence[str]) -> str:
        return self.chooser.choice(options)

    def state_clause(self) -> Node:
        """ "the oven is hot", "the lights in the hall are turned off", "there is milk in the fridge"."""
        draw = self.chooser.random()
        if draw < 0.12:
            verb = words.word("is/VERB")
            verb = verb.post("nsubj", self.nouns.thing()).post(
                "obl", self.nouns.marked(self.any(("in", "on")), self.nouns.fixture())
            )
            return verb.pre("expl", words.word("there/EX"))
        subject = self.nouns.fixture(self.maybe(0.2)) if self.maybe(0.6) else self.nouns.thing()
        subject = self.nouns.located(subject, 0.15)
        many = subject.xpos == "NNS"
        copula = words.word("are" if many else "is")
        if draw < 0.28:
            verb = words.participle(self.any("turn switch open close lock clean plug".split()))
            if verb.lemma in ("turn", "switch"):
                verb = verb.post("compound:prt", words.particle(self.any(("on", "off"))))
            return verb.pre("aux:pass", copula).pre("nsubj:pass", subject)
        if draw < 0.75:
            return self.state(subject, copula)
        place = self.nouns.marked(self.any("on in near under at next_to behind".split()), self.nouns.fixture())
        return place.pre("cop", copula).pre("nsubj", subject)

    def state(self, subject: Node, copula: Node) -> Node:
        form = self.any(self.nouns.lexicon.states)
        predicate = words.adverb(form) if form in ("on", "off", "here", "there") else words.adjective(form)
        if self.maybe(0.1) and predicate.upos == "ADJ":
            predicate = predicate.pre("advmod", words.adverb(self.any(("very", "too", "still", "really"))))
        return predicate.pre("cop", copula).pre("nsubj", subject)
