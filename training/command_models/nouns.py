"""Noun phrases: determiners, adjectives, compounds, possessors, numbers, places on and near things."""

import random
from dataclasses import dataclass
from typing import Callable, Sequence, Tuple

from . import words
from .lexicon import Lexicon
from .mining import Mined, nonce
from .trees import Node

_NUMBER_WORDS = "two three four five six seven eight nine ten twelve fifteen twenty thirty forty fifty ninety".split()
_TENS = "twenty thirty forty fifty sixty seventy eighty ninety".split()
_DIGITS = "one two three four five six seven eight nine".split()
_UNITS = {
    "turn": "degree degree degree radian".split(),
    "move": (
        "metre meter foot centimetre centimeter cm m inch step step yard millimetre mm km mile ft decimetre".split()
    ),
    "time": "second minute hour".split(),
}
_ABBREVIATIONS = ("cm", "m", "mm", "km", "ft")
_LANDMARK = "on on on in in near near near by next_to under behind beside at above inside below against".split()
_PLACING = "on on on in in into onto near next_to under behind beside in_front_of between inside on_top_of at".split()
_SIDES = ("left", "right")
# First parts of multi-word nouns that EWT tags as adjectives; all others are noun compounds.
_ADJECTIVE_PARTS = frozenset("main front high remote mobile".split())


@dataclass(frozen=True)
class Nouns:
    """Builds noun phrases from a lexicon; ``wide`` is the share of mined and made-up words."""

    chooser: random.Random
    lexicon: Lexicon
    mined: Mined
    wide: float

    def pick(self, own: Sequence[str], mined: Sequence[str], kind: str) -> str:
        """Return a word of the given list, or a mined or made-up one."""
        draw = self.chooser.random()
        if draw < self.wide * 0.7 and mined:
            return self.chooser.choice(mined)
        if draw < self.wide:
            return nonce(self.chooser, kind)
        return self.chooser.choice(own)

    def maybe(self, chance: float) -> bool:
        return self.chooser.random() < chance

    def lemma_noun(self, entry: str, many: bool = False) -> Node:
        """A noun of one or more words; the parts before the last are compounds."""
        parts = entry.split("_")
        head = words.noun(parts[-1], many)
        for part in parts[:-1]:
            if part in _ADJECTIVE_PARTS:
                head = head.near("amod", words.adjective(part))
            else:
                head = head.near("compound", words.noun(part))
        return head

    def name(self) -> Node:
        return words.name(self.pick(self.lexicon.names, self.mined.names, "PROPN"))

    def possessor(self) -> Node:
        """ "my", or an owner with 's: "Roger's", "the boy's"."""
        if self.maybe(0.6):
            return words.word(self.chooser.choice("my my my your his her/POSS our their".split()))
        owner = self.name()
        if self.maybe(0.35):
            owner = words.noun(self.chooser.choice(self.lexicon.people)).pre("det", words.word("the"))
        return owner.post("case", Node("'s", "'s", "PART", "POS", glued=True))

    def adjectives(self, head: Node, chance: float) -> Node:
        """One adjective or two before the noun's compounds."""
        while self.maybe(chance):
            chosen = words.adjective(self.pick(self.lexicon.adjectives, self.mined.adjectives, "ADJ"))
            if self.maybe(0.06):
                chosen = chosen.pre("advmod", words.adverb("very"))
            head = head.pre("amod", chosen)
            chance *= 0.3
        return head

    def determined(self, head: Node, many: bool, mass: bool = False, bare: float = 0.05) -> Node:
        """The phrase with determiner, possessor or number, or none."""
        if self.maybe(bare) or (mass and self.maybe(0.5)):
            return head
        draw = self.chooser.random()
        if draw < 0.55:
            return head.pre("det", words.word("the"))
        if draw < 0.75:
            owner = self.possessor()
            return head.pre("nmod:poss", owner)
        if draw < 0.83:
            return head.pre("det", words.word(self.chooser.choice(("these", "those") if many else ("this", "that"))))
        if many:
            if draw < 0.92:
                return head.pre("nummod", self.numeral(small=True))
            return head.pre("det", words.word(self.chooser.choice(("some", "all", "both", "any"))))
        if mass:
            return head.pre("det", words.word("some"))
        first = head.parts()[0].form
        return head.pre("det", words.article(first, False) or words.word("the"))

    def thing(self, plain: float = 0.75) -> Node:
        """Something that can be taken: "the red mug", "Roger's keys", "some water"."""
        many = self.maybe(0.16)
        if not many and self.maybe(0.12):
            return self.determined(
                self.adjectives(words.noun(self.chooser.choice(self.lexicon.masses)), 0.08), False, True
            )
        entry = self.pick(self.lexicon.things, self.mined.nouns, "NOUN")
        head = self.lemma_noun(entry, many)
        if self.maybe(0.05) and "_" not in entry:
            head = head.near("compound", words.noun(self.chooser.choice(self.lexicon.things).split("_")[-1]))
        head = self.determined(self.adjectives(head, 1.0 - plain), many)
        if self.maybe(0.05):
            inside = words.noun(self.chooser.choice(self.lexicon.masses + self.lexicon.things).split("_")[-1])
            head = head.post("nmod", inside.pre("case", words.adposition("of")))
        return head

    def fixture(self, many: bool = False) -> Node:
        """A landmark: "the kitchen table", "my bed"."""
        entry = self.pick(self.lexicon.fixtures, self.mined.nouns, "NOUN")
        if self.maybe(0.04):
            return self.numbered(entry)
        return self.determined(self.adjectives(self.lemma_noun(entry, many), 0.15), many, bare=0.06)

    def numbered(self, entry: str) -> Node:
        """ "room 204", "table two"."""
        value = self.chooser.choice("1 2 3 4 7 12 101 204 310".split() + _DIGITS)
        return self.lemma_noun(entry.split("_")[-1]).post("flat", words.number(value))

    def place(self) -> Node:
        """A room or region: "the living room", "Roger's office", "room 204", "kitchen"."""
        if self.maybe(0.04):
            return self.numbered(self.chooser.choice(("room", "office", "floor", "hall", "lab")))
        entry = (
            self.pick(self.lexicon.places, self.mined.nouns, "NOUN")
            if self.maybe(0.5)
            else self.chooser.choice(self.lexicon.places)
        )
        head = self.determined(self.adjectives(self.lemma_noun(entry), 0.08), False, bare=0.12)
        if self.maybe(0.07):
            head = head.post("nmod", self.fixture().pre("case", words.adposition("of")))
        return head

    def person(self) -> Node:
        """A person by name or by description."""
        if self.maybe(0.4):
            return self.name()
        if self.maybe(0.25):
            return words.word(self.chooser.choice("me him her us them everyone someone me".split()))
        head = self.adjectives(words.noun(self.chooser.choice(self.lexicon.people)), 0.15)
        return self.determined(head, False, bare=0.0)

    def pronoun(self) -> Node:
        return words.word(self.chooser.choice("it it it it them them this/PRON that/PRON him her everything".split()))

    def numeral(self, small: bool = False) -> Node:
        """A number: digits, decimals, one or several number words."""
        draw = self.chooser.random()
        if small:
            return words.number(self.chooser.choice(_NUMBER_WORDS[:6] if draw < 0.7 else "2 3 4 5 10".split()))
        if draw < 0.4:
            return words.number(
                self.chooser.choice("1 2 3 4 5 8 10 15 20 30 45 60 75 90 100 120 135 180 270 360".split())
            )
        if draw < 0.48:
            return words.number(f"{self.chooser.randrange(10)}.{self.chooser.choice((5, 25, 2, 75, 8))}")
        if draw < 0.76:
            return words.number(self.chooser.choice(["one"] + _NUMBER_WORDS))
        if draw < 0.9:
            last = words.number(self.chooser.choice(_DIGITS))
            return last.pre("compound", words.number(self.chooser.choice(_TENS)))
        hundred = words.number("hundred").pre("compound", words.number(self.chooser.choice(_DIGITS[:3])))
        if draw < 0.93:
            return hundred
        rest = words.number(self.chooser.choice(_TENS))
        if self.maybe(0.6):
            return hundred.post("conj", rest.pre("cc", words.word("and")))
        return rest.pre(
            "compound", words.number("hundred").pre("compound", words.number(self.chooser.choice(_DIGITS[:3])))
        )

    def measure(self, kind: str) -> Node:
        """A measure phrase headed by its unit: "2 radians", "half a metre", "a couple of metres", "another 3 feet"."""
        unit = self.chooser.choice(_UNITS[kind])
        short = unit in _ABBREVIATIONS
        draw = self.chooser.random()
        if draw < 0.07 and not short:
            return words.noun(unit).pre("det", words.word("half"), words.article(unit, False) or words.word("a"))
        if draw < 0.12 and not short:
            couple = words.noun("couple").pre("det", words.word("a"))
            return couple.post("nmod", words.noun(unit, True).pre("case", words.adposition("of")))
        if draw < 0.17 and not short:
            return words.noun(unit, True).pre("amod", words.word("few")).pre("det", words.word("a"))
        if draw < 0.22 and not short:
            return words.noun(unit).pre("det", words.article(unit, False) or words.word("a"))
        if draw < 0.25 and not short:
            whole = words.number(self.chooser.choice(("one", "two", "three", "1", "2")))
            part = words.noun("half").pre("det", words.word("a")).pre("cc", words.word("and"))
            return words.noun(unit, True).pre("nummod", whole.post("conj", part))
        value = self.numeral()
        many = value.form not in ("one", "1") and not short
        if self.maybe(0.07):
            value = value.pre(
                "advmod", words.adverb(self.chooser.choice(("about", "almost", "exactly", "minus", "approximately")))
            )
        head = words.noun(unit, many).pre("nummod", value)
        if self.maybe(0.04):
            head = head.pre("det", words.word("another"))
        elif self.maybe(0.04) and many:
            head = head.near("amod", words.word("more"))
        return head

    def marked(self, preposition: str, inner: Node) -> Node:
        """A prepositional phrase; ``in_front_of`` and ``on_top_of`` are headed by front and top, as in EWT."""
        if preposition in ("in_front_of", "on_top_of"):
            first, middle, _ = preposition.split("_")
            inner = inner.pre("case", words.adposition("of"))
            return words.noun(middle).pre("case", words.adposition(first)).post("nmod", inner)
        if preposition == "between":
            other = self.fixture().pre("cc", words.word("and"))
            return inner.post("conj", other).pre("case", words.adposition("between"))
        return inner.pre("case", *[words.adposition(part) for part in preposition.split("_")])

    def side(self) -> Node:
        """ "to the left of the box", "on your right", "at the right side of the bed"."""
        head = words.noun(self.chooser.choice(_SIDES))
        if self.maybe(0.3):
            head = words.noun(self.chooser.choice(("side", "hand", "side"))).pre("amod", words.adjective(head.form))
        elif self.maybe(0.25):
            head = self.chooser.choice(
                (
                    words.noun("end"),
                    words.noun("head"),
                    words.noun("side"),
                    words.noun("front"),
                    words.noun("top"),
                    words.noun("bottom"),
                    words.noun("edge"),
                    words.noun("middle"),
                )
            )
        owned = self.maybe(0.3)
        head = head.pre("nmod:poss", words.word("your")) if owned else head.pre("det", words.word("the"))
        if not owned and self.maybe(0.6):
            head = head.post("nmod", self.fixture().pre("case", words.adposition("of")))
        return head.pre("case", words.adposition(self.chooser.choice("to on at to on".split())))

    def located(self, head: Node, chance: float = 1.0) -> Node:
        """The phrase with a place said of it: "the mug on the table", "the cup that is on the table"."""
        if not self.maybe(chance):
            return head
        draw = self.chooser.random()
        if draw < 0.12:
            return head.post("nmod", self.side())
        if draw < 0.2:
            return head.post("nmod", self.fixture().pre("case", words.adposition("of")))
        if draw < 0.26:
            return head.post(
                "nmod", self.thing().pre("case", words.adposition(self.chooser.choice(("with", "with", "for"))))
            )
        preposition = self.chooser.choice(_LANDMARK)
        inner = self.place() if preposition == "in" and self.maybe(0.6) else self.fixture()
        phrase = self.marked(preposition, inner)
        if self.maybe(0.1):
            phrase = phrase.post("nmod", self.place().pre("case", words.adposition(self.chooser.choice(("in", "of")))))
        if draw > 0.96:
            verb = words.participle(self.chooser.choice("place keep leave put store hang".split()))
            if self.maybe(0.3):
                verb = words.gerund(self.chooser.choice("lie stand sit hang".split()), "Tense=Pres|VerbForm=Part")
            return head.post("acl", verb.post("obl", phrase))
        if draw > 0.85:
            return head.post("acl:relcl", self.relative(phrase, head.xpos == "NNS"))
        return head.post("nmod", phrase)

    def relative(self, phrase: Node, many: bool) -> Node:
        """ "that is on the table": in UD the place is the head of the clause."""
        pronoun = words.word(self.chooser.choice(("that/REL", "that/REL", "which")))
        return phrase.pre("cop", words.word("are" if many else "is")).pre("nsubj", pronoun)

    def placing(self) -> Node:
        """The goal of put and its like: "on the table", "in the red box", "next to the lamp"."""
        preposition = self.chooser.choice(_PLACING)
        inner = self.place() if preposition in ("in", "into") and self.maybe(0.3) else self.fixture()
        if preposition in ("in", "into", "inside") and self.maybe(0.3):
            inner = self.thing()
        return self.marked(preposition, inner)

    def joined(self, make: Callable[[], Node], extra: int = 1) -> Node:
        """Two or three phrases joined: "the cup and the plate", "the cup, the fork and the plate"."""
        head = make()
        others: Tuple[Node, ...] = ()
        for at in range(extra):
            other = make()
            if at == extra - 1:
                other = other.pre("cc", words.word("or" if self.maybe(0.08) else "and"))
            else:
                other = other.pre("punct", words.comma())
            others += (other,)
        return head.post("conj", *others)
