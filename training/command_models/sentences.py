"""Whole utterances as people say them: commands with politeness, addressee and clauses; questions; statements."""

import random
from dataclasses import dataclass
from typing import Dict, Sequence, Tuple

from . import words
from .clauses import Clauses
from .motion import Form
from .nouns import Nouns
from .trees import Node
from .verbs import Verbs

_FILLERS = "uh um okay ok so well now alright hey hello hi oh yeah yes no right hmm er".split()
_STOPPERS = "stop ping dock speak wait go dance undock freeze sit stand jump sleep wake help charge halt return".split()


@dataclass(frozen=True)
class Sentences:
    """Builds utterances; each frame is a method that returns a tree without final punctuation."""

    chooser: random.Random
    nouns: Nouns
    clauses: Clauses
    verbs: Verbs

    def maybe(self, chance: float) -> bool:
        return self.chooser.random() < chance

    def any(self, options: Sequence[str]) -> str:
        return self.chooser.choice(options)

    def utterance(self) -> Node:
        frames = self.utterance_frames()
        drawn = self.chooser.choices(list(frames), list(frames.values()))[0]
        built: Node = getattr(self, drawn)()
        return built

    def utterance_frames(self) -> Dict[str, float]:
        """The frames of which one is drawn, with how often each is."""
        return dict(_FRAMES)

    # -- pieces ---------------------------------------------------------------------------------

    def address(self) -> Node:
        """The addressee: "robot", "Max", "hey robot"."""
        draw = self.chooser.random()
        if draw < 0.4:
            # the most frequent words, which both lexicons share
            return words.noun("robot")
        called = self.any(self.nouns.lexicon.robots) if draw < 0.65 else self.nouns.name().form
        return words.name(called) if called[0].isupper() else words.noun(called)

    def addressed(self, root: Node, front: bool = True) -> Node:
        """Add an addressee; its comma depends on the addressee at the front, and on the root at the end."""
        who = self.address()
        if not front:
            if self.maybe(0.5):
                who = who.pre("punct", words.comma())
            return root.post("vocative", who)
        if self.maybe(0.4):
            who = who.post("punct", words.comma())
        root = root.pre("vocative", who)
        if self.maybe(0.15):
            root = root.pre("discourse", words.interjection(self.any("hey hi hello ok okay hey so".split())))
        return root

    def polite(self, root: Node, front: float = 0.5) -> Node:
        please = words.interjection("please")
        if self.maybe(front):
            return root.pre("discourse", please)
        if self.maybe(0.2):
            please = please.pre("punct", words.comma())
        return root.post("discourse", please)

    def filled(self, root: Node) -> Node:
        """Add a filler at the front; its comma, if any, depends on the filler."""
        filler = words.interjection(self.any(_FILLERS))
        if filler.form in ("now", "right", "so"):
            filler = words.adverb(filler.form)
            relation = "advmod"
        else:
            relation = "discourse"
        if self.maybe(0.35):
            filler = filler.post("punct", words.comma())
        return root.pre(relation, filler)

    def thanks(self, root: Node) -> Node:
        if self.maybe(0.5):
            return root.post("discourse", words.word("thanks"))
        return root.post("parataxis", words.present("thank").post("obj", words.word("you/ACC")))

    # -- commands -------------------------------------------------------------------------------

    def command(self) -> Node:
        root = self.verbs.phrase(words.imperative)
        if self.maybe(0.04):
            root = self.timed(root)
        if self.maybe(0.05):
            root = self.thanks(self.polite(root) if self.maybe(0.5) else root)
        return root

    def timed(self, root: Node) -> Node:
        """With a time: "tomorrow", "in five minutes", "at 5"."""
        draw = self.chooser.random()
        if draw < 0.4:
            return root.post("obl:unmarked", words.noun(self.any("today tomorrow tonight tomorrow".split())))
        if draw < 0.75:
            span = self.nouns.measure("time")
            return root.post("obl", span.pre("case", words.adposition(self.any(("in", "in", "after", "for")))))
        return root.post(
            "obl", words.number(self.any("5 7 eight noon".split()[:3])).pre("case", words.adposition("at"))
        )

    def request(self) -> Node:
        return self.polite(self.command())

    def called(self) -> Node:
        """With addressee, perhaps polite: "robot please go to the sink", "stop, Max"."""
        root = self.command()
        if self.maybe(0.3):
            root = self.polite(root)
        return self.addressed(root, self.maybe(0.85))

    def bare(self) -> Node:
        """One word, a known or unknown verb: "Stop", "Ping"."""
        if self.maybe(0.4):
            return words.imperative(self.any(_STOPPERS))
        pool = self.nouns.lexicon.intransitive + self.nouns.lexicon.transitive
        return words.imperative(self.nouns.pick(pool, self.nouns.mined.intransitive, "VERB"))

    def modal(self) -> Node:
        """ "could you please take it to the restroom", "can you bring the mug please"."""
        root = self.verbs.phrase(words.infinitive)
        draw = self.chooser.random()
        if draw < 0.3:
            root = root.pre("discourse", words.interjection("please"))
        root = root.pre("nsubj", words.word("you"))
        root = root.pre("aux", words.modal(self.any("can can can could could could would will may".split())))
        if 0.3 < draw < 0.5:
            root = self.polite(root, 0.0)
        if 0.5 < draw < 0.6:
            root = self.polite(root, 1.0)
        if self.maybe(0.2):
            root = self.addressed(root, self.maybe(0.85))
        if self.maybe(0.05):
            root = self.thanks(root)
        if self.maybe(0.04):
            root = root.pre("discourse", words.interjection("sorry"))
        return self.second(root, words.infinitive) if self.maybe(0.25) else root

    def mind(self) -> Node:
        """ "would you mind closing the door"."""
        inner = self.verbs.phrase(words.gerund)
        auxiliary = words.modal("would") if self.maybe(0.75) else words.word("do/Q")
        root = words.infinitive("mind").post("xcomp", inner).pre("nsubj", words.word("you"))
        return root.pre("aux", auxiliary)

    def prohibition(self) -> Node:
        """ "don't touch the stove", "do not move", "never open it"."""
        root = self.verbs.phrase(words.imperative)
        draw = self.chooser.random()
        if draw < 0.3:
            root = root.pre("advmod", words.word("never"))
        elif draw < 0.6:
            root = root.pre("advmod", words.word("not")).pre("aux", words.word("do"))
        else:
            root = root.pre("advmod", Node("n't", "not", "PART", "RB", "Polarity=Neg", glued=True))
            root = root.pre("aux", words.word("do"))
        return self.polite(root, 1.0) if self.maybe(0.2) else root

    def second(self, root: Node, form: Form = words.imperative) -> Node:
        """The utterance with a second action: "... and (then) VP"."""
        other = self.verbs.phrase(form)
        if self.maybe(0.2):
            other = other.pre("advmod", words.word("then"))
        other = other.pre("cc", words.word("and"))
        if self.maybe(0.15):
            other = other.pre("punct", words.comma())
        return root.post("conj", other)

    def two(self) -> Node:
        root = self.second(self.verbs.phrase(words.imperative))
        if self.maybe(0.15):
            root = self.polite(root)
        if self.maybe(0.15):
            root = self.addressed(root)
        return root

    def then(self) -> Node:
        """ "go to the table, then grab the cup", "turn left then go forward"."""
        other = self.verbs.phrase(words.imperative).pre("advmod", words.word("then"))
        if self.maybe(0.5):
            other = other.pre("punct", words.comma())
        return self.verbs.phrase(words.imperative, self.maybe(0.5)).post("conj", other)

    def several(self) -> Node:
        """Three or four actions, with commas or run on: "turn right go to the door and open it"."""
        root = self.verbs.phrase(words.imperative, True)
        commas = self.maybe(0.5)
        count = self.chooser.choice((1, 2, 2, 3))
        for at in range(count):
            other = self.verbs.phrase(words.imperative, True)
            if self.maybe(0.15):
                other = other.pre("advmod", words.word("then"))
            if at == count - 1 and self.maybe(0.75):
                other = other.pre("cc", words.word("and"))
            elif commas:
                other = other.pre("punct", words.comma())
            root = root.post("conj", other)
        return root

    def wish(self) -> Node:
        """ "I want you to follow me", "I'd like you to stop", "you have to turn left", "I need the cup"."""
        draw = self.chooser.random()
        if draw < 0.2:
            subject = words.word(self.any(("I", "I", "we")))
            root = words.present(self.any("need want need".split())).post(
                "obj", self.nouns.located(self.nouns.thing(), 0.2)
            )
            return root.pre("nsubj", subject)
        inner = self.verbs.phrase(words.infinitive)
        if draw < 0.35:
            must = self.any("should must can will need have".split())
            if must in ("need", "have"):
                root = words.present(must, 2).post("xcomp", inner.pre("mark", words.word("to")))
                return root.pre("nsubj", words.word("you"))
            return inner.pre("aux", words.modal(must)).pre("nsubj", words.word("you"))
        inner = inner.pre("mark", words.word("to"))
        if draw < 0.6:
            like = words.infinitive("like").post("obj", words.word("you/ACC")).post("xcomp", inner)
            if self.maybe(0.5):
                would = Node("'d", "would", "AUX", "MD", "VerbForm=Fin", glued=True)
            else:
                would = words.modal("would")
            return like.pre("aux", would).pre("nsubj", words.word("I"))
        root = words.present(self.any(("want", "need", "want", "expect"))).post("obj", words.word("you/ACC"))
        return root.post("xcomp", inner).pre("nsubj", words.word("I"))

    def conditional(self) -> Node:
        """ "if the door is open, close it", "stop when you see the wall", "wait until I come back"."""
        draw = self.chooser.random()
        if draw < 0.45:
            clause = self.clauses.state_clause()
        elif draw < 0.6:
            clause = words.present("say").post("advmod", words.word("so"))
            clause = clause.pre("nsubj", words.word("I"))
        elif draw < 0.8:
            seen = self.nouns.person() if self.maybe(0.5) else self.nouns.thing()
            clause = words.present(self.any(("see", "find", "hear", "reach", "meet")), 2).post("obj", seen)
            clause = clause.pre("nsubj", words.word("you"))
        else:
            clause = words.present(self.any("come leave return arrive call".split()))
            clause = clause.pre("nsubj", words.word("I"))
            if self.maybe(0.4):
                clause = clause.post("advmod", words.adverb("back"))
        marker = self.any("if if if when when until/SCONJ before/SCONJ after/SCONJ because".split())
        clause = clause.pre("advmod" if marker == "when" else "mark", words.word(marker))
        root = self.verbs.phrase(words.imperative)
        if self.maybe(0.2):
            root = self.polite(root)
        if marker in ("if", "when", "before/SCONJ", "after/SCONJ") and self.maybe(0.55):
            if self.maybe(0.5):
                clause = clause.post("punct", words.comma())
            return root.pre("advcl", clause)
        return root.post("advcl", clause)

    # -- questions, statements, fragments -----------------------------------------------------------

    def question(self) -> Node:
        """ "where is the cup", "what is on the table", "do you see Anna", "is the door open"."""
        draw = self.chooser.random()
        subject = (
            self.nouns.fixture() if self.maybe(0.3) else self.nouns.thing() if self.maybe(0.7) else self.nouns.person()
        )
        copula = words.word("are" if subject.xpos == "NNS" else "is")
        if draw < 0.3:
            if self.maybe(0.2):
                subject, copula = words.word("you"), words.word("are/2")
            return words.word("where").post("cop", copula).post("nsubj", subject)
        if draw < 0.42:
            asked = words.word(self.any(("what", "who")))
            if self.maybe(0.5):
                place = self.nouns.marked(self.any("on in at near".split()), self.nouns.fixture())
                return place.pre("cop", words.word("is")).pre("nsubj", asked)
            return asked.post("cop", copula).post("nsubj", subject)
        if draw < 0.62:
            inner = self.clauses.state_clause()
            cut = [child for child in inner.left if child.rel in ("cop", "aux:pass")]
            if not cut:
                return words.word("is/VERB").post("expl", words.word("there/EX")).post("nsubj", self.nouns.thing())
            rest = tuple(child for child in inner.left if child.rel not in ("cop", "aux:pass"))
            return Node(
                inner.form, inner.lemma, inner.upos, inner.xpos, inner.feats, "root", tuple(cut) + rest, inner.right
            )
        if draw < 0.85:
            verb = words.infinitive(self.any("see know have need hear like want find".split()))
            verb = verb.post("obj", self.nouns.located(self.nouns.thing(), 0.2)).pre("nsubj", words.word("you"))
            auxiliary = words.word("do/Q") if self.maybe(0.7) else words.modal("can")
            return verb.pre("aux", auxiliary)
        counted = self.nouns.lemma_noun(self.any(self.nouns.lexicon.things), True)
        many = Node("many", "many", "ADJ", "JJ", "Degree=Pos").pre("advmod", words.word("how"))
        root = words.word("are/VERB").post("expl", words.word("there/EX")).pre("nsubj", counted.pre("amod", many))
        return root.post("obl", self.nouns.marked(self.any(("on", "in")), self.nouns.fixture()))

    def statement(self) -> Node:
        """ "this is the office", "there are two couches in the living room", "you are in the bedroom"."""
        draw = self.chooser.random()
        if draw < 0.35:
            head = (
                self.nouns.place()
                if self.maybe(0.55)
                else self.nouns.fixture()
                if self.maybe(0.5)
                else self.nouns.thing()
            )
            if self.maybe(0.2):
                head = self.nouns.name()
            elif self.maybe(0.35):
                head = head.post(
                    "nmod",
                    self.nouns.marked(self.any(("with", "with", "for", "of")), self.nouns.joined(self.nouns.thing)),
                )
            elif self.maybe(0.15):
                head = head.post("acl:relcl", self.clauses.state_clause().pre("advmod", words.word("where")))
            copula = words.word("is")
            if self.maybe(0.15):
                copula = Node("'s", "be", "AUX", "VBZ", words.word("is").feats, glued=True)
                return head.pre("cop", copula).pre("nsubj", words.word("that/PRON"))
            return head.pre("cop", copula).pre(
                "nsubj", words.word(self.any(("this/PRON", "this/PRON", "that/PRON", "it/NOM")))
            )
        if draw < 0.6:
            many = self.maybe(0.4)
            entry = self.any(self.nouns.lexicon.fixtures + self.nouns.lexicon.things)
            head = self.nouns.lemma_noun(entry, many)
            if many:
                head = head.pre("nummod", self.nouns.numeral(True))
            else:
                head = head.pre("det", words.article(head.parts()[0].form, False) or words.word("a"))
            if self.maybe(0.2):
                head = head.post("nmod", self.nouns.marked("with", self.nouns.thing()))
            verb = words.word("are/VERB" if many else "is/VERB").post("nsubj", head)
            where = self.nouns.marked(
                self.any("in in on on near next_to behind".split()),
                self.nouns.place() if self.maybe(0.5) else self.nouns.fixture(),
            )
            if self.maybe(0.12):
                return verb.pre("expl", words.word("there/EX")).pre("obl", where)
            return verb.post("obl", where).pre("expl", words.word("there/EX"))
        if draw < 0.7:
            place = self.nouns.marked("in", self.nouns.place())
            if self.maybe(0.3):
                place = self.nouns.side()
            copula = words.word("are/2")
            return place.pre("cop", copula).pre("nsubj", words.word("you"))
        if draw < 0.78:
            naming = words.noun("name").pre("nmod:poss", words.word(self.any(("my", "your"))))
            return self.nouns.name().pre("cop", words.word("is")).pre("nsubj", naming)
        if draw < 0.84:
            copula = (
                Node("'m", "be", "AUX", "VBP", words.word("am").feats, glued=True)
                if self.maybe(0.5)
                else words.word("am")
            )
            predicate = (
                self.nouns.name()
                if self.maybe(0.5)
                else words.adjective(self.any("thirsty hungry tired here ready cold".split()))
            )
            return predicate.pre("cop", copula).pre("nsubj", words.word("I"))
        root = self.clauses.state_clause()
        if self.maybe(0.25):
            other = self.clauses.state_clause().pre("cc", words.word("and"))
            root = root.post("conj", other)
        return root

    def greeting(self) -> Node:
        """ "hello", "yes", "thank you", "good morning robot"."""
        draw = self.chooser.random()
        if draw < 0.25:
            root = words.present("thank").post("obj", words.word("you/ACC"))
        elif draw < 0.35:
            root = words.word("thanks")
        elif draw < 0.5:
            root = words.noun(self.any("morning job evening robot".split())).pre("amod", words.adjective("good"))
        else:
            root = words.interjection(self.any("hello hi hey yes no okay ok goodbye bye please sorry".split()))
        return self.addressed(root, False) if self.maybe(0.35) else root

    def fragment(self) -> Node:
        """ "the red cup on the table", "two metres", "to the left", "left", "and take a photo"."""
        draw = self.chooser.random()
        if draw < 0.3:
            return self.nouns.located(self.nouns.thing(), 0.4)
        if draw < 0.4:
            return self.nouns.place()
        if draw < 0.5:
            return self.nouns.measure(self.any(("turn", "move", "time")))
        if draw < 0.6:
            return self.nouns.side()
        if draw < 0.68:
            return words.adverb(self.any("left right forward back faster slower again here there now".split()))
        if draw < 0.74:
            return words.noun("five").near("amod", words.adjective("high"))
        root = self.verbs.phrase(words.imperative)
        if self.maybe(0.3):
            root = root.pre("advmod", words.word("then"))
        return root.pre("cc", words.word("and"))

    def hesitant(self) -> Node:
        """Any command with a filler in front: "uh move forward", "ok so turn left"."""
        root = self.chooser.choice((self.command, self.modal, self.two, self.command))()
        root = self.filled(root)
        return self.filled(root) if self.maybe(0.12) else root


_FRAMES: Tuple[Tuple[str, float], ...] = (
    ("command", 34),
    ("request", 8),
    ("called", 11),
    ("bare", 4),
    ("modal", 12),
    ("mind", 1.2),
    ("prohibition", 3),
    ("two", 11),
    ("then", 3),
    ("several", 4),
    ("wish", 4),
    ("conditional", 4),
    ("question", 4.5),
    ("statement", 5),
    ("greeting", 1.2),
    ("fragment", 3),
    ("hesitant", 3.5),
)


def frame_names() -> Tuple[str, ...]:
    """Names of all utterance frames."""
    return tuple(frame for frame, _ in _FRAMES)
