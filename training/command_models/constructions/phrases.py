"""Pieces of sentences: verb phrases over units, their subjects, clauses in every tense, and times."""

import random
from typing import Callable, List, Optional, Sequence, Tuple, TypeVar

from command_models import words
from command_models.clauses import Clauses
from command_models.lexicon import Lexicon
from command_models.mining import Mined
from command_models.nouns import Nouns
from command_models.trees import Node
from command_models.verbs import Verbs

from . import inflection
from .units import ADVERBS, Slot, Unit

Form = Callable[[str], Node]
Maker = Callable[[Form], Node]
_T = TypeVar("_T")

_PERSON_ROLES = frozenset("addressee beneficiary recipient partner person perceiver cotheme donor individual".split())
_PLACE_ROLES = frozenset("goal source path place location ground area station avoided target side".split())
#: Names that are verbs, nouns or adjectives as well.
NAMES_THAT_ARE_WORDS = "Mark Bill Will Rob Pat Drew Chase Grant Rose Grace Faith Dawn Jack Carol Bob Nick Sue".split()
_HAPPENINGS = "arrive leave return come wake fall move stop start appear call wave speak sleep cry ring open".split()
_FINITE = {
    "be": {"I": "am", "3": "is", "": "are"},
    "was": {"I": "was", "3": "was", "": "were"},
    "have": {"3": "has", "": "have"},
    "do": {"3": "does", "": "do"},
    "did": {"": "did"},
}
_LEMMA = {"was": "be", "did": "do"}
_PAST = frozenset(("was", "did"))


def auxiliary(which: str, person: str) -> Node:
    """Return a finite "be", "was", "have", "do", "did" or a modal in the form of a person ("I", "3" or another)."""
    forms = _FINITE.get(which)
    if forms is None:
        return words.modal(which)
    form = forms.get(person, forms[""])
    xpos = "VBD" if which in _PAST else "VBZ" if person == "3" and form != "are" else "VBP"
    return Node(form, _LEMMA.get(which, which), "AUX", xpos, "VerbForm=Fin")


def _no(glued: bool) -> Node:
    return Node("n't", "not", "PART", "RB", "Polarity=Neg", glued=True) if glued else words.word("not")


class Phrases:
    """Builds the pieces; all draws come from one chooser."""

    def __init__(
        self, chooser: random.Random, lexicon: Lexicon, mined: Mined, wide: float, units: Sequence[Unit]
    ) -> None:
        """
        Args:
            chooser: draws
            lexicon: open-class words
            mined: more of them
            wide: share of mined and made-up words, 0 to 1
            units: the verbs
        """
        self.chooser, self.lexicon = chooser, lexicon
        self.nouns = Nouns(chooser, lexicon, mined, wide)
        self.clauses = Clauses(chooser, self.nouns)
        self.verbs = Verbs(chooser, self.nouns, self.clauses)
        self._units = units
        self._transitive = [unit for unit in units if unit.objects]

    def maybe(self, chance: float) -> bool:
        return self.chooser.random() < chance

    def any(self, options: Sequence[_T]) -> _T:
        return self.chooser.choice(options)

    def one(self, text: str) -> str:
        """Return one word of a text."""
        return self.chooser.choice(text.split())

    # -- noun phrases -----------------------------------------------------------------------------

    def person_name(self) -> Node:
        if self.maybe(0.25):
            return words.name(self.any(NAMES_THAT_ARE_WORDS))
        return words.name(self.any(self.lexicon.names))

    def the(self, head: Node) -> Node:
        return head.pre("det", words.word("the"))

    def person(self) -> Node:
        """A person that can be a subject."""
        if self.maybe(0.5):
            return self.person_name()
        if self.maybe(0.25):
            form = self.one("somebody someone everybody anyone nobody")
            return Node(form, form, "PRON", "NN", "Number=Sing")
        return words.noun(self.any(self.lexicon.people)).pre("det", words.word(self.one("the the the a that")))

    def subject(self, who: str = "") -> Tuple[Node, str]:
        """Return a subject and its person: "I", "2", "3", "p" (plural). ``who`` is you, person or thing."""
        who = who or self.one("you you person person thing I we they he")
        if who == "you":
            return words.word("you"), "2"
        if who == "I":
            return words.word("I"), "I"
        if who in ("he", "she"):
            return words.word(who), "3"
        if who == "we":
            return words.word("we"), "p"
        if who == "they":
            return Node("they", "they", "PRON", "PRP", "Case=Nom"), "p"
        if who == "person":
            return self.person(), "3"
        many = self.maybe(0.15)
        head = self.nouns.fixture(many) if self.maybe(0.6) else self.thing(many)
        return head, "p" if head.xpos == "NNS" else "3"

    def thing(self, many: bool = False, located: float = 0.0) -> Node:
        """A definite or indefinite thing in the singular or plural, without a place of its own unless wanted."""
        if not many and self.maybe(0.5):
            found = self.nouns.thing(0.85)
        else:
            head = self.nouns.lemma_noun(self.nouns.pick(self.lexicon.things, self.nouns.mined.nouns, "NOUN"), many)
            found = self.nouns.determined(self.nouns.adjectives(head, 0.15), many)
        return self.nouns.located(found, located) if located else found

    def kind(self, many: bool = False) -> Node:
        """A bare noun of a thing, a fixture or a place, without determiner."""
        pool = self.any((self.lexicon.things, self.lexicon.things, self.lexicon.fixtures, self.lexicon.places))
        return self.nouns.lemma_noun(self.nouns.pick(pool, self.nouns.mined.nouns, "NOUN"), many)

    def place(self) -> Node:
        return self.nouns.place() if self.maybe(0.6) else self.nouns.fixture()

    def located_at(self) -> Node:
        """ "on the table", "in the kitchen", "next to the door"."""
        if self.maybe(0.4):
            return self.nouns.marked("in", self.nouns.place())
        preposition = self.one("on on in near under next_to behind beside at by in_front_of inside above on_top_of")
        return self.nouns.marked(preposition, self.nouns.fixture())

    # -- verb phrases -----------------------------------------------------------------------------

    def unit(self, transitive: bool = False) -> Unit:
        return self.any(self._transitive if transitive else self._units)

    def phrase(self, form: Form) -> Node:
        """A verb phrase of any kind: over a unit, or one of the frames of commands."""
        draw = self.chooser.random()
        if draw < 0.25:
            return self.verbs.phrase(form, True)
        if draw < 0.3:
            return self.verbs.phrase(form)
        return self.of_unit(form, self.unit())

    def of_unit(self, form: Form, unit: Unit, adjuncts: Tuple[int, ...] = (0, 0, 0, 1, 1, 2)) -> Node:
        """A phrase over a unit with its object, if it has one, and some of what it takes besides."""
        verb = form(unit.verb)
        if unit.objects:
            return self._with_object(verb, unit, self._object(unit), adjuncts)
        return self._with_slots(self._with_particle(verb, unit), unit, adjuncts)

    def transitive(self, form: Form, what: Optional[Node] = None, adjuncts: Tuple[int, ...] = (0, 0, 1)) -> Node:
        """A phrase over a unit with an object: this one, or none at all if there is None."""
        unit = self.unit(True)
        verb = form(unit.verb)
        if what is not None:
            return self._with_object(verb, unit, what, adjuncts)
        return self._with_slots(self._with_particle(verb, unit), unit, adjuncts, ditransitive=False)

    def acting_on(self, form: Form) -> Node:
        """A phrase over a unit with an object of its own."""
        return self.of_unit(form, self.unit(True))

    def _object(self, unit: Unit) -> Node:
        role = unit.objects[0]
        if role in _PERSON_ROLES or self.maybe(0.06):
            return self.nouns.person()
        if role in _PLACE_ROLES:
            return self.place()
        if self.maybe(0.15):
            return self.nouns.pronoun()
        if self.maybe(0.2):
            return self.nouns.fixture()
        return self.thing(self.maybe(0.15))

    @staticmethod
    def _particle(unit: Unit) -> Tuple[str, Node]:
        if unit.particle in ADVERBS:
            return "advmod", words.adverb(unit.particle)
        return "compound:prt", words.particle(unit.particle)

    def _with_particle(self, verb: Node, unit: Unit) -> Node:
        return verb.post(*self._particle(unit)) if unit.particle else verb

    def _with_object(self, verb: Node, unit: Unit, what: Node, adjuncts: Tuple[int, ...]) -> Node:
        # "pick it up", "pick up the mug", "pick the mug up"; an adverb rather follows
        late = what.upos == "PRON" or (len(what.parts()) < 4 and self.maybe(0.4))
        if unit.particle and not late:
            verb = verb.post(*self._particle(unit))
        verb = verb.post("obj", what)
        if unit.particle and late:
            verb = verb.post(*self._particle(unit))
        return self._with_slots(verb, unit, adjuncts)

    def _with_slots(self, verb: Node, unit: Unit, adjuncts: Tuple[int, ...], *, ditransitive: bool = True) -> Node:
        slots = [slot for slot in unit.slots if "iobj" not in slot.relations]
        self.chooser.shuffle(slots)
        for slot in slots[: self.any(adjuncts)]:
            verb = self._with_slot(verb, slot)
        receivers = [slot for slot in unit.slots if "iobj" in slot.relations]
        if receivers and ditransitive and self.maybe(0.4) and verb.has("obj") and verb.right[0].rel == "obj":
            whom = words.word(self.one("me me me him her us them")) if self.maybe(0.7) else self.nouns.person()
            if verb.right[0].upos != "PRON":
                verb = verb.first("iobj", whom)
        return verb

    def _with_slot(self, verb: Node, slot: Slot) -> Node:
        relation = self.any(slot.relations)
        if relation == "advmod":
            return verb.post("advmod", words.adverb(self._adverb(slot.role)))
        if relation in ("measure", "tmod"):
            kind = "time" if slot.role == "duration" else "turn" if slot.role.startswith("angle") else "move"
            return verb.post("obl:unmarked", self.nouns.measure(kind))
        preposition = relation[len("prep_") :]
        if preposition in ("of", "where", "using", "avoiding", "close_to", "off_of", "ahead_of", "out"):
            return verb
        if slot.role in ("duration", "distance", "angle"):
            kind = {"duration": "time", "distance": "move", "angle": "turn"}[slot.role]
            return verb.post("obl", self.nouns.marked(preposition, self.nouns.measure(kind)))
        if slot.role in _PERSON_ROLES:
            inner = self.nouns.person()
        elif slot.role in _PLACE_ROLES or preposition in ("into", "onto", "through", "along"):
            inner = self.place()
        else:
            inner = self.thing()
        return verb.post("obl", self.nouns.marked(preposition, inner))

    def _adverb(self, role: str) -> str:
        if role == "direction":
            return self.one("left right forward back backwards up down around straight")
        if role in ("goal", "place", "location", "path"):
            return self.one("here there back away upstairs outside home")
        return self.any(self.lexicon.manners)

    def happening(self, form: Form) -> Node:
        """What somebody or something does by itself: "arrives", "comes back", "rings"."""
        verb = form(self.any(_HAPPENINGS))
        if self.maybe(0.25):
            verb = verb.post("advmod", words.adverb(self.one("back here again home inside")))
        return verb

    def doing(self, form: Form) -> Node:
        """What a person may do: happening, over a unit, with an object."""
        draw = self.chooser.random()
        return self.happening(form) if draw < 0.25 else self.phrase(form)

    # -- clauses ----------------------------------------------------------------------------------

    def clause(
        self,
        make: Maker,
        subject: Optional[Tuple[Node, str]],
        tense: str = "present",
        *,
        asked: bool = False,
        negative: bool = False,
        adverb: Optional[Node] = None,
    ) -> Node:
        """A finite clause of a verb.

        Args:
            make: its verb phrase, given the form of its verb
            subject: and its person; None where a question word is the subject
            tense: present, past, progressive, was_progressive, perfect, or a modal
            asked: whether the auxiliary stands before the subject
            negative: whether it is denied
            adverb: before the verb: "ever", "already"
        """
        person = subject[1] if subject else "3"
        chain: List[Tuple[str, Node]] = []
        if tense in ("present", "past"):
            if negative or asked:
                chain.append(("aux", auxiliary("do" if tense == "present" else "did", person)))
                root = make(inflection.infinitive)
            elif tense == "past":
                root = make(inflection.past)
            else:
                root = make(inflection.third if person == "3" else inflection.present)
        elif tense in ("progressive", "was_progressive"):
            chain.append(("aux", auxiliary("be" if tense == "progressive" else "was", person)))
            root = make(inflection.progressive)
        elif tense == "perfect":
            chain.append(("aux", auxiliary("have", person)))
            root = make(inflection.perfect)
        else:
            chain.append(("aux", auxiliary(tense, person)))
            root = make(inflection.infinitive)
        return self.assembled(root, chain, subject, asked=asked, negative=negative, adverb=adverb)

    def predicate(
        self,
        root: Node,
        subject: Optional[Tuple[Node, str]],
        tense: str = "present",
        *,
        asked: bool = False,
        negative: bool = False,
        passive: bool = False,
        adverb: Optional[Node] = None,
    ) -> Node:
        """A clause of "be": with a predicate ("on the table"), or of a passive; tenses as in :meth:`clause`."""
        person = subject[1] if subject else "3"
        last = "aux:pass" if passive else "cop"
        being = {"present": "be", "past": "was", "progressive": "be"}.get(tense)
        chain: List[Tuple[str, Node]]
        if tense == "progressive":
            chain = [("aux", auxiliary("be", person)), (last, Node("being", "be", "AUX", "VBG", "VerbForm=Part"))]
        elif being:
            chain = [(last, auxiliary(being, person))]
        elif tense == "perfect":
            chain = [("aux", auxiliary("have", person)), (last, Node("been", "be", "AUX", "VBN", "VerbForm=Part"))]
        else:
            chain = [("aux", auxiliary(tense, person)), (last, Node("be", "be", "AUX", "VB", "VerbForm=Inf"))]
        relation = "nsubj:pass" if passive else "nsubj"
        return self.assembled(root, chain, subject, asked=asked, negative=negative, relation=relation, adverb=adverb)

    def assembled(
        self,
        root: Node,
        chain: List[Tuple[str, Node]],
        subject: Optional[Tuple[Node, str]],
        *,
        asked: bool,
        negative: bool,
        relation: str = "nsubj",
        adverb: Optional[Node] = None,
    ) -> Node:
        """Put auxiliaries, subject, "not" and an adverb before a verb or predicate, in the order of English."""
        glued = negative and self.maybe(0.6) and chain[0][1].form not in ("am", "may", "might", "shall")
        if glued and chain[0][1].form in ("can", "will"):
            glued = False  # "can't" and "won't" are written otherwise
        front: List[Tuple[str, Node]] = []
        said = [(relation, subject[0])] if subject else []
        no = [("advmod", _no(glued))] if negative else []
        extra = [("advmod", adverb)] if adverb is not None else []
        if asked:
            front = chain[:1] + (no + said if glued else said + no) + extra + chain[1:]
        else:
            front = said + chain[:1] + no + extra + chain[1:]
        for name, node in reversed(front):
            root = root.pre(name, node)
        return root

    def passive(self, form: Form = inflection.passive, agent: float = 0.25) -> Node:
        """A passive participle with what it has: "cleaned (by Anna)", "put on the table"."""
        root = self.transitive(form, None)
        if self.maybe(agent):
            root = root.post("obl:agent", self.person_name().pre("case", words.adposition("by")))
        return root

    def state(self) -> Node:
        """A predicate: adjective, place or adverb."""
        draw = self.chooser.random()
        if draw < 0.45:
            form = self.any(self.lexicon.states)
            if form in ("on", "off", "here", "there"):
                return words.adverb(form)
            return words.adjective(form)
        if draw < 0.6:
            return words.adjective(self.any(self.lexicon.adjectives))
        return self.located_at()

    def stated(self, **how: object) -> Node:
        """A clause about a state: "the door is (not) open", "the mug is on the table"."""
        tense = str(how.pop("tense", "present"))
        return self.predicate(self.state(), self.subject("thing"), tense, **how)  # type: ignore[arg-type]

    def event(self) -> Node:
        """Any clause that says what happens or how something is, without a marker."""
        draw = self.chooser.random()
        if draw < 0.3:
            return self.stated(negative=self.maybe(0.15))
        if draw < 0.4:
            return self.predicate(self.passive(), self.subject("thing"), self.one("present perfect past"), passive=True)
        if draw < 0.65:
            tense = self.one("present perfect perfect past progressive")
            return self.clause(self.phrase, self.subject("you"), tense, negative=self.maybe(0.15))
        if draw < 0.72:
            return self.existing(self.maybe(0.2))
        if draw < 0.78:
            return self.below()
        return self.clause(
            self.doing,
            self.subject(self.one("person person person thing I he they we")),
            self.one("present present present perfect past progressive"),
            negative=self.maybe(0.12),
        )

    def existing(self, negative: bool = False) -> Node:
        """ "there is a mug on the table", "there are no keys here"."""
        many = self.maybe(0.4)
        head = self.kind(many)
        if negative:
            head = head.pre("det", Node("no", "no", "DET", "DT", "PronType=Neg"))
        elif many:
            head = head.pre("nummod", self.nouns.numeral(True)) if self.maybe(0.6) else head
        else:
            article = words.article(head.parts()[0].form, False)
            head = head.pre("det", article or words.word("the"))
        verb = words.word("are/VERB" if many else "is/VERB").post("nsubj", head)
        if self.maybe(0.7):
            verb = verb.post("obl", self.located_at())
        return verb.pre("expl", words.word("there/EX"))

    def below(self) -> Node:
        """ "the battery is below 20 percent", "it is colder than ten degrees"."""
        unit = self.one("percent degrees volts kilos")
        amount = words.noun(unit, False) if unit == "percent" else Node(unit, unit[:-1], "NOUN", "NNS", "Number=Plur")
        amount = amount.pre("nummod", words.number(self.one("10 20 30 five twelve fifty")))
        about = words.noun(self.one("battery temperature level charge humidity"))
        root = amount.pre("case", words.adposition(self.one("below below above under over at")))
        return self.predicate(root, (self.the(about), "3"))

    # -- times and amounts ------------------------------------------------------------------------

    def clock(self) -> Node:
        """A time of day without its preposition: "20:15", "8 pm", "half past eight", "noon"."""
        draw = self.chooser.random()
        if draw < 0.3:
            return words.number(f"{self.chooser.randrange(24)}:{self.chooser.choice(('00', '15', '30', '45', '05'))}")
        hour = words.number(self.one("one two three four five six seven eight nine ten eleven twelve 3 5 7 8 9 10 11"))
        if draw < 0.5:
            half = self.one("am pm am pm a.m. p.m.")
            return hour.post("nmod:unmarked", Node(half, half, "NOUN", "NN", "Number=Sing"))
        if draw < 0.62:
            part = words.noun(self.one("half quarter"))
            past = self.one("past past past to") if part.form == "quarter" else "past"
            return part.post("nmod", hour.pre("case", words.adposition(past)))
        if draw < 0.72:
            return words.noun(self.one("noon midnight lunchtime"))
        if draw < 0.8:
            return Node("o'clock", "o'clock", "NOUN", "NN", "Number=Sing").pre("nummod", hour)
        return hour

    def when(self) -> Tuple[str, Node]:
        """Return a time and its relation to the verb."""
        draw = self.chooser.random()
        if draw < 0.4:
            return "obl", self.clock().pre("case", words.adposition("at"))
        if draw < 0.5:
            day = self.one("Monday Tuesday Wednesday Thursday Friday Saturday Sunday")
            return "obl", words.name(day).pre("case", words.adposition("on"))
        if draw < 0.65:
            return "obl", self.nouns.measure("time").pre("case", words.adposition(self.one("in in for for after")))
        if draw < 0.8:
            return "obl:unmarked", words.noun(self.one("today tomorrow tonight yesterday"))
        if draw < 0.9:
            part = words.noun(self.one("morning evening afternoon night"))
            if part.form == "night":
                return "obl", part.pre("case", words.adposition("at"))
            return "obl", self.the(part).pre("case", words.adposition("in"))
        every = words.noun(self.one("day morning evening hour week night monday")).pre("det", words.word("every"))
        return "obl:unmarked", every


def before_all(root: Node, relation: str, child: Node, comma: bool) -> Node:
    """Put a dependant at the front, with or without a comma that depends on it."""
    return root.pre(relation, child.post("punct", words.comma()) if comma else child)
