"""Utterances with more than one clause: conditions, repetitions, lists, second thoughts, roundabout requests.

They are rare among the plain commands. The last steps of the tagger and the parser see as many of them as of those.
"""

from dataclasses import dataclass
from typing import Dict, Tuple

from . import words
from .motion import Form
from .sentences import Sentences
from .trees import Node

_HAPPENINGS = "leave leave arrive return come ring move stop start appear call wave speak fall open close".split()
_WAVERS = "raise wave wear hold carry point sit stand lie wait read watch clean".split()


@dataclass(frozen=True)
class Elaborate(Sentences):
    """Builds plain utterances and, as often, utterances with more clauses."""

    def utterance_frames(self) -> Dict[str, float]:
        return super().utterance_frames() if self.maybe(0.5) else dict(_FRAMES)

    # -- conditions -----------------------------------------------------------------------------

    def conditioned(self) -> Node:
        """ "when Anna arrives, turn around twice", "stay here until the phone rings", "if it is off switch it on"."""
        root = self.repeated() if self.maybe(0.3) else self.verbs.phrase(words.imperative, self.maybe(0.5))
        marker = self.any("if if if when when whenever once until unless while in_case".split())
        clause = self.marked(marker, self.happening())
        if self.maybe(0.12):
            other = self.happening()
            if self.maybe(0.5):
                other = other.pre(
                    "mark" if marker != "when" else "advmod", words.word("if" if marker != "when" else marker)
                )
            clause = clause.post("conj", other.pre("cc", words.word(self.any(("and", "or")))))
        if marker in ("until", "while") or self.maybe(0.25):
            return root.post("advcl", clause)
        if self.maybe(0.65):
            clause = clause.post("punct", words.comma())
        return root.pre("advcl", clause)

    def marked(self, marker: str, clause: Node) -> Node:
        """A clause behind the word that makes it a condition or a time."""
        if marker == "in_case":
            case = Node("case", "case", "NOUN", "NN", "Number=Sing")
            return clause.pre("mark", words.adposition("in").post("fixed", case))
        if marker in ("when", "whenever"):
            return clause.pre("advmod", Node(marker, marker, "ADV", "WRB", "PronType=Int"))
        return clause.pre("mark", Node(marker, marker, "SCONJ", "IN"))

    def happening(self) -> Node:
        """What somebody does, or how something is: "Anna comes back", "the phone isn't here", "you see me"."""
        draw = self.chooser.random()
        if draw < 0.3:
            return self.clauses.state_clause()
        if draw < 0.42:
            subject = self.nouns.name() if self.maybe(0.6) else self.nouns.fixture()
            gone = words.adverb("here") if self.maybe(0.5) else words.adjective(self.any(self.nouns.lexicon.states[:2]))
            no = Node("n't", "not", "PART", "RB", "Polarity=Neg", glued=True) if self.maybe(0.6) else words.word("not")
            return gone.pre("advmod", no).pre("cop", words.word("is")).pre("nsubj", subject)
        if draw < 0.55:
            seen = self.nouns.person() if self.maybe(0.6) else self.nouns.thing()
            verb = words.present(self.any("see find hear reach meet get".split()), 2)
            return verb.post("obj", seen).pre("nsubj", words.word("you"))
        verb = words.present(self.nouns.pick(_HAPPENINGS, self.nouns.mined.intransitive, "VERB"), 3)
        if self.maybe(0.2):
            verb = words.present(self.any("enter leave reach open close need want".split()), 3)
            verb = verb.post("obj", self.nouns.place())
        elif self.maybe(0.2):
            verb = verb.post("advmod", words.adverb(self.any(("back", "here", "again", "now"))))
        if self.maybe(0.45):
            return verb.pre("nsubj", self.nouns.name())
        subject = self.nouns.fixture() if self.maybe(0.6) else self.any_person()
        return verb.pre("nsubj", subject if subject.xpos != "NNS" else self.any_person())

    def any_person(self) -> Node:
        return words.noun(self.any(self.nouns.lexicon.people)).pre("det", words.word(self.any(("the", "the", "a"))))

    # -- repetitions and amounts ----------------------------------------------------------------

    def repeated(self) -> Node:
        """ "turn around twice", "wave three times", "turn right now"."""
        draw = self.chooser.random()
        verb = self.verbs.phrase(words.imperative, True)
        if draw < 0.45:
            verb = words.imperative(self.any("turn turn spin rotate go move drive step swing look".split()))
            sides = "around around left right back forward up".split()
            verb = verb.post("advmod", words.adverb(self.any(sides)))
        if draw < 0.2:
            return verb.post("advmod", words.adverb(self.any("now again slowly quickly carefully immediately".split())))
        if self.maybe(0.6):
            return verb.post("advmod", words.adverb(self.any(("twice", "twice", "once"))))
        return verb.post("obl:unmarked", words.noun("time", True).pre("nummod", self.nouns.numeral(True)))

    def crossings(self) -> Node:
        """ "take the second left", "make a right turn", "take one left turn"."""
        side = self.any(("left", "right"))
        verb = words.imperative(self.any(("take", "take", "make", "do")))
        if self.maybe(0.5):
            order = words.adjective(self.any("first second third next last".split()))
            way = words.noun(side).pre("amod", order).pre("det", words.word("the"))
        else:
            way = words.noun("turn").pre("amod", words.adjective(side))
            one = (
                ("nummod", words.number("one")) if self.maybe(0.3) else ("det", words.word(self.any(("a", "another"))))
            )
            way = way.pre(*one)
        verb = verb.post("obj", way)
        if self.maybe(0.25):
            verb = verb.post("obl", self.oblique("at", self.nouns.fixture()))
        return verb

    def oblique(self, preposition: str, inner: Node) -> Node:
        return self.nouns.marked(preposition, inner)

    # -- persons and ways -----------------------------------------------------------------------

    def described(self) -> Node:
        """ "say hello to everybody who leaves", "tell the man raising his hand a joke"."""
        whom = Node(*(self.any(("everybody", "everyone", "somebody", "anyone")),) * 2, "PRON", "NN", "Number=Sing")
        if self.maybe(0.6):
            whom = self.any_person()
        if self.maybe(0.55):
            who = Node("who", "who", "PRON", "WP", "PronType=Rel")
            verb = words.present(self.nouns.pick(_HAPPENINGS, self.nouns.mined.intransitive, "VERB"), 3)
            if self.maybe(0.3):
                verb = words.gerund(self.any(_WAVERS), "Tense=Pres|VerbForm=Part").pre("aux", words.word("is"))
            whom = whom.post("acl:relcl", verb.pre("nsubj", who))
        else:
            doing = words.gerund(self.any(_WAVERS[:5]), "Tense=Pres|VerbForm=Part")
            thing = self.nouns.thing() if self.maybe(0.6) else words.noun(self.any(("hand", "arm", "hat")))
            if thing.lemma in ("hand", "arm", "hat") and not thing.left:
                thing = thing.pre("nmod:poss", words.word(self.any(("his", "her/POSS", "their"))))
            whom = whom.post("acl", doing.post("obj", thing))
        draw = self.chooser.random()
        if draw < 0.4:
            what = words.interjection(self.any("hello hi goodbye bye hello".split()))
            return words.imperative("say").post("obj", what).post("obl", self.oblique("to", whom))
        if draw < 0.6:
            joke = self.nouns.determined(words.noun(self.any(self.nouns.lexicon.noise)), False)
            return words.imperative(self.any(("tell", "give", "bring"))).post("iobj", whom).post("obj", joke)
        if draw < 0.75:
            return words.imperative(self.any(("go", "talk", "wave", "speak"))).post("obl", self.oblique("to", whom))
        return words.imperative(self.any("follow greet find guide help meet".split())).post("obj", whom)

    def avoiding(self) -> Node:
        """ "go to the kitchen avoiding the hall", "following me, carry the box"."""
        root = self.verbs.going(words.imperative) if self.maybe(0.7) else self.verbs.phrase(words.imperative, True)
        way = words.gerund(self.any("avoid avoid cross pass follow use hold".split()), "VerbForm=Ger")
        where = self.nouns.place() if self.maybe(0.6) else self.nouns.fixture()
        way = way.post("obj", where)
        if self.maybe(0.3):
            return root.pre("advcl", way.post("punct", words.comma()))
        if self.maybe(0.5):
            way = way.pre("punct", words.comma())
        return root.post("advcl", way)

    # -- several commands -----------------------------------------------------------------------

    def listed(self) -> Node:
        """ "find Bob, greet Anna, and wave": a comma before "and"."""
        root = self.verbs.phrase(words.imperative, True)
        count = self.chooser.choice((1, 1, 2))
        for at in range(count + 1):
            other = self.verbs.alone(words.imperative) if self.maybe(0.4) else self.greeted(words.imperative)
            if at == count:
                other = other.pre("cc", words.word("and"))
            root = root.post("conj", other.pre("punct", words.comma()))
        return root

    def greeted(self, form: Form) -> Node:
        verb = form(self.nouns.pick(self.nouns.lexicon.transitive, self.nouns.mined.transitive, "VERB"))
        return verb.post("obj", self.nouns.name() if self.maybe(0.5) else self.nouns.thing())

    def run_on(self) -> Node:
        """ "go to the office wait", "move forward three feet stop turn left"."""
        root = self.verbs.phrase(words.imperative, True)
        for _ in range(self.chooser.choice((1, 1, 2))):
            short = self.maybe(0.4)
            verb = words.imperative(self.any(("stop", "wait", "stop", "wait", "come", "look", "listen", "help")))
            root = root.post("conj", verb if short else self.verbs.phrase(words.imperative, True))
        return root

    def corrected(self) -> Node:
        """ "turn left no turn right", "go to the hall, no, wait, to the kitchen" as two commands."""
        other = self.verbs.phrase(words.imperative, True)
        no = words.interjection(self.any(("no", "no", "no", "sorry", "oops")))
        if self.maybe(0.4):
            no = no.post("punct", words.comma())
        return self.verbs.phrase(words.imperative, True).post("conj", other.pre("discourse", no))

    def wondering(self) -> Node:
        """ "I was wondering if you could (not) turn left", "do you think you could open it"."""
        inner = self.verbs.phrase(words.infinitive)
        if self.maybe(0.15):
            inner = inner.pre("advmod", words.word("not"))
        inner = inner.pre("aux", words.modal(self.any(("could", "could", "can", "would"))))
        inner = inner.pre("nsubj", words.word("you"))
        if self.maybe(0.6):
            was = Node("was", "be", "AUX", "VBD", "Mood=Ind|Number=Sing|Person=1|Tense=Past|VerbForm=Fin")
            root = words.gerund("wonder", "Tense=Pres|VerbForm=Part")
            root = root.post("ccomp", inner.pre("mark", words.word(self.any(("if", "if", "whether")))))
            return root.pre("aux", was).pre("nsubj", words.word("I"))
        root = words.infinitive("think").post("ccomp", inner)
        return root.pre("nsubj", words.word("you")).pre("aux", words.word("do/Q"))


_FRAMES: Tuple[Tuple[str, float], ...] = (
    ("conditioned", 30),
    ("repeated", 12),
    ("described", 11),
    ("listed", 11),
    ("run_on", 9),
    ("avoiding", 6),
    ("corrected", 6),
    ("crossings", 5),
    ("wondering", 4),
)


def frame_names() -> Tuple[str, ...]:
    """Names of the utterance frames that plain commands do not have."""
    return tuple(frame for frame, _ in _FRAMES)
