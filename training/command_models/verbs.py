"""Verb phrases: the frames of robot commands.

Every frame is a method that takes a ``Form``, the inflection to use (imperative, infinitive, gerund), and returns the
phrase headed by its verb. One rule governs attachment: the place to which something goes depends on the verb
(``obl``), the place at which something is depends on its noun (``nmod``).
"""

from dataclasses import dataclass
from typing import Dict, List, Tuple

from . import words
from .framewords import (
    CARRIERS,
    GIVERS,
    OBLIQUE,
    PARTICLE_ALONE,
    PARTICLE_OBJECT,
    PLACERS,
    TAKERS,
    VERBAL_NOUNS,
)
from .motion import Form, Motion
from .trees import Node


@dataclass(frozen=True)
class Verbs(Motion):
    """Builds verb phrases over the noun phrases of ``nouns``."""

    def phrase(self, form: Form, short: bool = False) -> Node:
        """One verb phrase of any frame; ``short`` keeps to frames of few words."""
        frames: Dict[str, float] = dict(_SHORT if short else _FRAMES)
        drawn = self.chooser.choices(list(frames), list(frames.values()))[0]
        head: Node = getattr(self, drawn)(form)
        if self.maybe(0.06):
            head = self.manner(head)
        return head

    def manner(self, head: Node) -> Node:
        adverb = words.adverb(self.any(self.nouns.lexicon.manners))
        if self.maybe(0.15):
            adverb = adverb.pre("advmod", words.adverb("very"))
        if self.maybe(0.25):
            return head.near("advmod", adverb)
        return head.first("advmod", adverb) if not head.right or self.maybe(0.1) else head.post("advmod", adverb)

    # -- one word, one object -------------------------------------------------------------------

    def alone(self, form: Form) -> Node:
        verb = form(self.nouns.pick(self.nouns.lexicon.intransitive, self.nouns.mined.intransitive, "VERB"))
        if self.maybe(0.25):
            adverbs = self.nouns.lexicon.manners + ("again", "now", "here", "there", "home", "back", "away")
            verb = verb.post("advmod", words.adverb(self.any(adverbs)))
        return verb

    def objects(self, form: Form) -> Node:
        """A verb and its object, with or without a place of the object."""
        verb = form(self.nouns.pick(self.nouns.lexicon.transitive, self.nouns.mined.transitive, "VERB"))
        draw = self.chooser.random()
        if draw < 0.15:
            return verb.post("obj", self.nouns.pronoun())
        if draw < 0.25:
            return verb.post("obj", self.nouns.joined(self.nouns.thing, self.chooser.choice((1, 1, 2))))
        if draw < 0.4:
            return verb.post("obj", self.nouns.fixture())
        if draw < 0.46:
            return verb.post("obj", self.nouns.place())
        return verb.post("obj", self.nouns.located(self.nouns.thing(), 0.3))

    def taking(self, form: Form) -> Node:
        """Take and similar verbs: the place of the object depends on the object, a source on the verb.

        After verbs of searching, the place is where to search and depends on the verb.
        """
        verb = form(self.any(TAKERS if self.maybe(0.75) else self.nouns.lexicon.transitive))
        if verb.lemma == "pick":
            verb = verb.post("compound:prt", words.particle("up"))
        if self.maybe(0.22):
            source = self.nouns.fixture() if self.maybe(0.6) else self.nouns.place()
            return verb.post("obj", self.nouns.thing()).post("obl", self.oblique("from", source))
        if verb.lemma in ("find", "search", "locate", "inspect") and self.maybe(0.75):
            preposition = self.any("in in in on on near behind under next_to inside".split())
            inner = self.nouns.place() if preposition in ("in", "inside") else self.nouns.fixture()
            if self.maybe(0.1):
                inner = self.nouns.located(inner)
            return verb.post("obj", self.nouns.thing()).post("obl", self.oblique(preposition, inner))
        return verb.post("obj", self.nouns.located(self.nouns.thing(), 0.85))

    def following(self, form: Form) -> Node:
        verb = form(self.any("follow follow follow follow guide lead accompany escort help greet meet".split()))
        if self.maybe(0.35):
            verb = verb.post("obj", words.word(self.any("me me me him her us them".split())))
        else:
            person = self.nouns.person()
            if person.upos == "NOUN" and self.maybe(0.4):
                where = self.any("in_front_of behind with with in near on".split())
                inner = (
                    words.word(self.any(("me", "you/ACC")))
                    if where in ("in_front_of", "behind")
                    else self.nouns.thing()
                )
                person = person.post("nmod", self.oblique(where, inner))
            verb = verb.post("obj", person)
        if self.maybe(0.35):
            verb = verb.post("obl", self.oblique(self.any("to to to into around through".split()), self.nouns.place()))
        if self.maybe(0.15):
            verb = verb.post("advmod", words.adverb(self.any(self.nouns.lexicon.manners)))
        return verb

    # -- transfer -------------------------------------------------------------------------------

    def placing(self, form: Form) -> Node:
        """Put and similar verbs: the place depends on the verb."""
        verb = form(self.any(PLACERS))
        if self.maybe(0.15):
            what = self.nouns.pronoun()
        elif self.maybe(0.1):
            what = self.nouns.joined(self.nouns.thing)
        else:
            what = self.nouns.thing()
            if self.maybe(0.1):
                what = what.post("nmod", self.oblique(self.any(("from", "on", "in", "near")), self.nouns.fixture()))
        verb = verb.post("obj", what)
        draw = self.chooser.random()
        if draw < 0.06:
            return verb.post("advmod", words.adverb(self.any(("here", "there", "down", "away", "back"))))
        if draw < 0.14:
            verb = verb.post("advmod", words.adverb(self.any(("back", "down"))))
        if draw > 0.93:
            return verb.post("obl", self.nouns.side())
        place = self.nouns.placing()
        if self.maybe(0.25):
            where = self.nouns.place() if self.maybe(0.5) else self.nouns.fixture()
            place = place.post("nmod", self.oblique(self.any(("in", "near", "of", "next_to")), where))
        return verb.post("obl", place)

    def giving(self, form: Form) -> Node:
        """ "give me the cup (from the table)", "bring my sister a glass of water", "give me five"."""
        verb = form(self.any(GIVERS))
        whom = (
            words.word(self.any("me me me me me him her us them".split())) if self.maybe(0.8) else self.nouns.person()
        )
        verb = verb.post("iobj", whom)
        draw = self.chooser.random()
        if draw < 0.05 and verb.lemma == "give":
            return verb.post("obj", words.number(self.any("five 5 ten 10".split())))
        if draw < 0.14:
            gift = self.nouns.lemma_noun(self.any(self.nouns.lexicon.gestures))
            return verb.post("obj", gift.pre("det", words.article(gift.parts()[0].form, False) or words.word("a")))
        if draw < 0.5:
            return verb.post("obj", self.nouns.located(self.nouns.thing(), 0.35))
        verb = verb.post("obj", self.nouns.thing())
        if draw < 0.72:
            source = self.nouns.fixture() if self.maybe(0.6) else self.nouns.place()
            verb = verb.post("obl", self.oblique("from", source))
        return verb

    def carrying(self, form: Form) -> Node:
        """ "bring the mug (on the table) to the kitchen", "give the cup to Anna", "take it there"."""
        verb = form(
            self.any(CARRIERS) if self.maybe(0.75) else self.any(("give", "give", "hand", "pass", "show", "connect"))
        )
        if self.maybe(0.2):
            what = self.nouns.pronoun()
        elif self.maybe(0.1):
            what = self.nouns.joined(self.nouns.thing)
        else:
            what = self.nouns.located(self.nouns.thing(), 0.3)
        verb = verb.post("obj", what)
        if self.maybe(0.15):
            verb = verb.post("obl", self.oblique("from", self.nouns.fixture()))
        goal = (
            self.nouns.person()
            if verb.lemma in ("give", "hand", "pass", "show") or self.maybe(0.2)
            else self.nouns.place()
            if self.maybe(0.5)
            else self.nouns.fixture()
        )
        if goal.upos == "NOUN":
            goal = self.nouns.located(goal, 0.1)
        if verb.lemma in ("take", "bring", "carry", "move", "drag", "deliver") and self.maybe(0.4):
            # with these verbs a place is where the thing goes, even without "to"
            return verb.post(
                "obl", self.oblique(self.any("near near on on next_to in behind under beside".split()), goal)
            )
        preposition = "to" if self.maybe(0.75) else self.any("into for over_to towards back_to for into".split())
        if preposition in ("over_to", "back_to"):
            verb = verb.post("advmod", words.adverb(preposition[:4]))
            preposition = "to"
        return verb.post("obl", self.oblique(preposition, goal))

    def benefit(self, form: Form) -> Node:
        """ "find a drink for me", "cut the bread with the knife", "search the kitchen for the keys"."""
        verb = form(self.nouns.pick(self.nouns.lexicon.transitive, self.nouns.mined.transitive, "VERB"))
        draw = self.chooser.random()
        if draw < 0.35:
            return verb.post("obj", self.nouns.thing()).post("obl", self.oblique("for", self.nouns.person()))
        if draw < 0.65:
            return verb.post("obj", self.nouns.thing()).post("obl", self.oblique("with", self.nouns.thing()))
        if draw < 0.77:
            verb = form(self.any("enter enter leave reach cross".split())).post("obj", self.nouns.place())
            way = self.any("through through by via from".split())
            return verb.post("obl", self.oblique(way, self.nouns.fixture()))
        verb = form(self.any("search search check scan inspect".split())).post("obj", self.nouns.place())
        return verb.post("obl", self.oblique("for", self.nouns.thing()))

    # -- particles and prepositions -----------------------------------------------------------------

    def particles(self, form: Form) -> Node:
        """ "pick up the cup", "turn the light on", "pick it up", "put the cup down on the table"."""
        lemma, particle = self.chooser.choice(PARTICLE_OBJECT)
        if self.maybe(0.55):
            # "turn on the light" is by far the most frequent, and looks like "turn" with "on the light"
            lemma, particle = self.chooser.choice(PARTICLE_OBJECT[:11])
        verb = form(lemma)
        if self.maybe(0.15):
            # particle verbs that are in no list
            lemma = self.nouns.pick(self.nouns.lexicon.transitive, self.nouns.mined.transitive, "VERB")
            particle = self.any("up up off out down in on".split())
        adverbial = particle in ("away", "back", "over", "go")
        part = words.adverb(particle) if adverbial else words.particle(particle)
        relation = "advmod" if adverbial else "compound:prt"
        if lemma in ("turn", "switch", "power", "shut"):
            what = self.nouns.fixture(self.maybe(0.25))
        else:
            what = self.nouns.thing()
        what = self.nouns.located(what, 0.2)
        draw = self.chooser.random()
        if particle == "go" or draw < 0.27:
            verb = verb.post("obj", self.nouns.pronoun()).post(relation, part)
        elif draw < 0.5:
            verb = verb.post("obj", what).post(relation, part)
        else:
            verb = verb.post(relation, part).post("obj", what)
        if particle in ("up", "down", "back") and self.maybe(0.12):
            verb = verb.post("obl", self.oblique(self.any(("from", "on", "near", "to")), self.nouns.fixture()))
        return verb

    def particle_alone(self, form: Form) -> Node:
        lemma, particle = self.chooser.choice(PARTICLE_ALONE)
        if particle == "around":
            return form(lemma).post("advmod", words.adverb(particle))
        return form(lemma).post("compound:prt", words.particle(particle))

    def obliques(self, form: Form) -> Node:
        """ "look at the window", "search for the keys in the kitchen"."""
        lemma, preposition = self.chooser.choice(OBLIQUE)
        verb = form(lemma)
        inner = (
            self.nouns.person() if self.maybe(0.3) else self.nouns.thing() if self.maybe(0.6) else self.nouns.fixture()
        )
        if lemma in ("go", "come", "walk") and preposition == "with" and self.maybe(0.3):
            verb = verb.post("advmod", words.adverb(self.any(("along", "together"))))
        if lemma in ("search", "look") and self.maybe(0.12):
            verb = verb.post("obl", self.oblique("in", self.nouns.place()))
        searching = lemma in ("search", "look") and preposition == "for"
        if inner.upos == "NOUN" and not searching:
            inner = self.nouns.located(inner, 0.2)
        verb = verb.post("obl", self.oblique(preposition, inner))
        if self.maybe(0.4 if searching else 0.1):
            verb = verb.post("obl", self.oblique(self.any(("in", "in", "on")), self.nouns.place()))
        return verb

    def waiting(self, form: Form) -> Node:
        verb = form(self.any("wait wait wait wait stay sleep pause rest stop hold stand".split()))
        draw = self.chooser.random()
        if draw < 0.2:
            verb = verb.post("advmod", words.adverb(self.any(("here", "there", "outside"))))
        if draw < 0.65:
            return verb.post("obl", self.oblique("for", self.nouns.measure("time")))
        if draw < 0.75:
            moment = words.noun(self.any(("moment", "minute", "second"))).pre("det", words.word("a"))
            return verb.post("obl:unmarked", moment)
        if draw < 0.85:
            return verb.post("obl:unmarked", self.nouns.measure("time"))
        return verb.post("obl", self.oblique(self.any(("in", "at", "near", "by")), self.nouns.place()))

    # -- fixed frames ---------------------------------------------------------------------------

    def saying(self, form: Form) -> Node:
        """ "say hello to the class", "tell me a joke", "introduce yourself", "shake hands"."""
        draw = self.chooser.random()
        if draw < 0.4:
            what = words.interjection(self.any("hello hi goodbye bye yes no hello sorry".split()))
            verb = form("say").post("obj", what)
            return verb.post("obl", self.oblique("to", self.nouns.person())) if self.maybe(0.75) else verb
        noise = words.noun(self.any(self.nouns.lexicon.noise))
        if draw < 0.65:
            verb = form(self.any("tell sing read play".split()))
            verb = verb.post("iobj", self.nouns.person()) if self.maybe(0.7) else verb
            return verb.post("obj", self.nouns.determined(noise, False))
        if draw < 0.75:
            time = words.noun(self.any(("time", "name", "date", "weather"))).pre("det", words.word("the"))
            return form("tell").post("iobj", words.word("me")).post("obj", time)
        if draw < 0.85:
            return form(self.any(("introduce", "charge", "clean", "disconnect", "calibrate"))).post(
                "obj", words.word("yourself")
            )
        if draw < 0.92:
            return form(self.any(("shake", "clap", "wash"))).post("obj", words.noun("hand", True))
        greeting = words.noun("five").near("amod", words.adjective("high"))
        return form(self.any(("pound", "hit", "do"))).post("obj", self.nouns.pronoun() if self.maybe(0.6) else greeting)

    def picturing(self, form: Form) -> Node:
        """ "take a picture of the room", "take a step forward"."""
        what = self.any(VERBAL_NOUNS)
        verb = form("take")
        if what == "step":
            many = self.maybe(0.5)
            steps = words.noun("step", many)
            steps = steps.pre("nummod", self.nouns.numeral(True)) if many else steps.pre("det", words.word("a"))
            return verb.post("obj", steps).post(
                "advmod", words.adverb(self.any("forward back left right backwards".split()))
            )
        head = words.noun(what).pre("det", words.word(self.any(("a", "a", "another"))))
        if what in ("picture", "photo", "photograph", "video") and self.maybe(0.5):
            of = (
                self.nouns.person()
                if self.maybe(0.3)
                else self.nouns.fixture()
                if self.maybe(0.5)
                else self.nouns.place()
            )
            head = head.post("nmod", of.pre("case", words.adposition("of")))
        return verb.post("obj", head)

    def serial(self, form: Form) -> Node:
        """ "go get the cup", "come see me", "go and fetch the keys"."""
        inner = self.chooser.choice((self.taking, self.giving, self.objects))
        verb = form(self.any(("go", "go", "go", "come")))
        if self.maybe(0.45):
            second = self.chooser.choice((self.taking, self.giving))(form)
            return verb.post("conj", second.pre("cc", words.word("and")))
        return verb.post("xcomp", inner(words.infinitive))

    def helping(self, form: Form) -> Node:
        """ "help me clean the table", "let me know", "try to grasp the cup", "stop dancing", "keep walking"."""
        draw = self.chooser.random()
        if draw < 0.25:
            whom = words.word(self.any(("me", "us", "him", "her")))
            inner = self.phrase(words.infinitive, True)
            if self.maybe(0.3):
                inner = inner.pre("mark", words.word("to"))
            return form("help").post("obj", whom).post("xcomp", inner)
        if draw < 0.4:
            whom = words.word(self.any(("me", "us", "it", "him", "her", "them")))
            return form("let").post("obj", whom).post("xcomp", self.phrase(words.infinitive, True))
        if draw < 0.6:
            verb = form(self.any("try start remember continue begin learn forget prepare".split()))
            return verb.post("xcomp", self.phrase(words.infinitive, True).pre("mark", words.word("to")))
        if draw < 0.9:
            verb = form(self.any("stop stop start keep finish continue".split()))
            return verb.post("xcomp", self.phrase(words.gerund, True))
        return form("get").post("xcomp", words.adjective("ready"))

    def naming(self, form: Form) -> Node:
        """ "call me Roger", "name this room the office"."""
        verb = form(self.any(("call", "call", "name", "label")))
        what = self.nouns.pronoun() if self.maybe(0.5) else self.nouns.place()
        if verb.lemma == "call" and self.maybe(0.4):
            what = words.word("me")
        return verb.post("obj", what).post("xcomp", self.nouns.name() if self.maybe(0.6) else self.nouns.place())

    def clauses(self, form: Form) -> Node:
        """ "check whether the oven is hot", "make sure that the door is closed", "tell me where the keys are"."""
        draw = self.chooser.random()
        if draw < 0.6:
            verb = form(self.any("check check check see verify find".split()))
            if verb.lemma == "find":
                verb = verb.post("compound:prt", words.particle("out"))
            clause = self.clauses_of.state_clause().pre("mark", words.word(self.any(("if", "if", "whether"))))
            return verb.post("ccomp", clause)
        if draw < 0.75:
            sure = words.adjective("sure")
            clause = self.clauses_of.state_clause()
            if self.maybe(0.4):
                clause = clause.pre("mark", words.word("that/SCONJ"))
            return form("make").post("xcomp", sure.post("ccomp", clause))
        if draw < 0.88:
            clause = self.clauses_of.state_clause().pre("mark", words.word(self.any(("if", "whether"))))
            return form(self.any(("tell", "tell", "show"))).post("iobj", words.word("me")).post("ccomp", clause)
        subject = self.nouns.fixture() if self.maybe(0.5) else self.nouns.thing()
        copula = words.word("are" if subject.xpos == "NNS" else "is")
        clause = words.word("where").post("nsubj", subject).post("cop", copula)
        return form(self.any(("tell", "show"))).post("iobj", words.word("me")).post("ccomp", clause)

    def being(self, form: Form) -> Node:
        """ "be quiet", "be careful"."""
        head = words.adjective(self.any("quiet careful nice gentle ready polite patient honest".split()))
        verb = form("be")
        return head.pre("cop", Node(verb.form, "be", "AUX", verb.xpos, verb.feats))


_FRAMES: Tuple[Tuple[str, float], ...] = (
    ("alone", 5),
    ("objects", 13),
    ("taking", 13),
    ("following", 6),
    ("going", 13),
    ("turning", 8),
    ("shifting", 7),
    ("shifting_thing", 4),
    ("placing", 10),
    ("giving", 8),
    ("carrying", 11),
    ("benefit", 4),
    ("particles", 14),
    ("particle_alone", 2.5),
    ("obliques", 6),
    ("waiting", 3),
    ("saying", 4),
    ("picturing", 2),
    ("serial", 2.5),
    ("helping", 2.5),
    ("naming", 1.2),
    ("clauses", 4),
    ("being", 0.6),
)
_SHORT: Tuple[Tuple[str, float], ...] = (
    ("alone", 4),
    ("objects", 6),
    ("taking", 3),
    ("following", 2),
    ("going", 4),
    ("turning", 2),
    ("shifting", 2),
    ("placing", 3),
    ("giving", 3),
    ("carrying", 3),
    ("particles", 3),
    ("obliques", 2),
    ("waiting", 1),
)


def frame_names() -> List[str]:
    """Names of all verb-phrase frames."""
    return [frame for frame, _ in _FRAMES]
