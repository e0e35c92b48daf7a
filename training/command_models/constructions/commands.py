"""Commands as people give them: several in a row, by sides and amounts alone, with names, hearers and receivers."""

from command_models import words
from command_models.trees import Node

from . import inflection
from .phrases import Phrases
from .registry import construction

_LETTERS = tuple("ABCDEFGHKX")
_TITLES = "Uncle Aunt Doctor Professor Mister Mrs Dr".split()
_ROLES = "sister brother friend son daughter colleague mother father boss neighbour".split()
_DRINKS = "tea coffee water milk juice soup bread lunch beer lemonade sugar salt rice".split()


def side(p: Phrases) -> Node:
    return words.adverb(p.one("left right left right forward back backwards ahead"))


def amount(p: Phrases, head: Node, heading: Node) -> Node:
    """Hang a side and its amount on a verb."""
    kind = "turn" if heading.form in ("left", "right") else "move"
    head = head.post("advmod", heading)
    return head.post("obl:unmarked", p.nouns.measure(kind)) if p.maybe(0.6) else head


@construction(weight=3)
def sides_in_a_row(p: Phrases) -> Node:
    """ "Turn right 90 degrees, then left 45 degrees." "Go forward two metres, left, and then forward." """
    verb = amount(p, inflection.imperative(p.one("turn turn go move rotate drive")), side(p))
    for _ in range(p.any((1, 1, 2))):
        heading = side(p)
        if p.maybe(0.5):
            heading = heading.pre("advmod", words.word("then"))
            heading = heading.pre("cc", words.word("and")) if p.maybe(0.3) else heading
        if p.maybe(0.6):
            heading = heading.pre("punct", words.comma())
        verb = amount(p, verb, heading)
    return verb


@construction(weight=3)
def side_alone(p: Phrases) -> Node:
    """ "Forward two metres." "Left 90 degrees." "Back a bit." "A little to the left." """
    heading = side(p)
    kind = "turn" if heading.form in ("left", "right") else "move"
    if p.maybe(0.15):
        bit = words.noun("bit") if p.maybe(0.5) else words.noun("little")
        return heading.post("obl:unmarked", bit.pre("det", words.word("a")))
    heading = heading.post("obl:unmarked", p.nouns.measure(kind))
    if p.maybe(0.2):
        other = p.phrase(inflection.imperative).pre("cc", words.word("and"))
        return heading.post("conj", other)
    return heading


@construction(weight=2)
def turn_as_noun(p: Phrases) -> Node:
    """ "Make a 30 degree turn to the left." "Do a quarter turn right." "Take a left turn." """
    turn = words.noun("turn")
    draw = p.chooser.random()
    if draw < 0.45:
        turn = turn.pre("compound", words.noun(p.one("degree degree radian")).pre("nummod", p.nouns.numeral()))
    elif draw < 0.6:
        turn = turn.pre("compound", words.noun(p.one("quarter half")))
    elif draw < 0.7:
        turn = turn.pre("amod", words.adjective(p.one("full complete small sharp slight")))
    else:
        turn = turn.pre("amod", words.adjective(p.one("left right")))
    turn = turn.pre("det", words.word(p.one("a a a another")))
    verb = inflection.imperative(p.one("make do take perform make")).post("obj", turn)
    if draw < 0.7 and p.maybe(0.7):
        if p.maybe(0.3):
            return verb.post("advmod", words.adverb(p.one("left right clockwise")))
        way = words.noun(p.one("left right")).pre(p.any(("det", "det", "nmod:poss")), words.word("the"))
        way = words.noun(way.form).pre("nmod:poss", words.word("your")) if way.left[0].rel != "det" else way
        return verb.post("obl", way.pre("case", words.adposition("to")))
    if p.maybe(0.4):
        return verb.post("obl", p.nouns.marked(p.one("at at behind before"), p.nouns.fixture()))
    return verb


@construction(weight=2)
def turned_now(p: Phrases) -> Node:
    """ "Turn right now." "Veer left to the grey couch." "Go closer to the shelf." "Drive close to the window." """
    draw = p.chooser.random()
    if draw < 0.3:
        verb = inflection.imperative(p.one("turn go look move")).post("advmod", words.adverb(p.one("left right")))
        return verb.post("advmod", words.adverb(p.one("now again here immediately slowly")))
    if draw < 0.6:
        verb = inflection.imperative(p.one("veer bear turn go head keep")).post(
            "advmod", words.adverb(p.one("left right"))
        )
        return verb.post("obl", p.nouns.marked(p.one("to toward towards into"), p.nouns.fixture()))
    verb = inflection.imperative(p.one("go drive move come get walk stand roll"))
    verb = verb.post("advmod", words.adverb(p.one("closer close nearer near further")))
    return verb.post("obl", p.nouns.marked("to", p.nouns.fixture() if p.maybe(0.8) else p.person_name()))


@construction(weight=3)
def receiver_first(p: Phrases) -> Node:
    """ "Bring Anna tea." "Give Anna and Bill the cup." "Show the visitors the kitchen." "Get Rose one." """
    whom = p.person_name() if p.maybe(0.6) else p.person()
    if p.maybe(0.15):
        whom = whom.post("conj", p.person_name().pre("cc", words.word("and")))
    if p.maybe(0.2):
        whom = p.nouns.located(p.the(words.noun(p.any(p.lexicon.people))), 1.0)
    draw = p.chooser.random()
    if draw < 0.3:
        what = words.noun(p.any(_DRINKS))
    elif draw < 0.4:
        what = words.number(p.one("one two three"))
    elif draw < 0.5:
        what = words.noun(p.any(p.lexicon.things).split("_")[-1]).pre(
            "nmod:poss", words.word(p.one("his her their my"))
        )
    else:
        what = p.place() if draw > 0.9 else p.thing(p.maybe(0.2))
    verb = inflection.imperative(p.one("bring give get hand pass show serve fetch offer"))
    return verb.post("iobj", whom).post("obj", what)


@construction(weight=2)
def object_late(p: Phrases) -> Node:
    """ "Describe to me the person at the door." "Bring to the guests the tray." """
    hearer = words.word(p.one("me us him her them")) if p.maybe(0.7) else p.person()
    what = p.the(words.noun(p.any(p.lexicon.people))) if p.maybe(0.5) else p.thing()
    if what.upos == "NOUN" and p.maybe(0.5):
        doing = words.gerund(p.one("sit stand wait wave point lie"), "Tense=Pres|VerbForm=Part")
        what = what.post("acl", doing.post("obl", p.nouns.marked(p.one("at in near by"), p.nouns.fixture())))
    verb = inflection.imperative(p.one("describe bring deliver show explain carry introduce"))
    return verb.post("obl", p.nouns.marked("to", hearer)).post("obj", what)


@construction(weight=2)
def doing_person(p: Phrases) -> Node:
    """ "Bring the tray to the person pointing to the left in the kitchen." "Tell a joke to the man waving." """
    person = p.the(words.noun(p.any(p.lexicon.people)))
    draw = p.chooser.random()
    doing = words.gerund(p.one("point wave stand sit raise wear hold lie"), "Tense=Pres|VerbForm=Part")
    if doing.lemma in ("raise", "wear", "hold"):
        held = words.noun(p.one("arm hand coat hat bag cup")).pre("amod", words.adjective(p.one("left right red blue")))
        doing = doing.post("obj", held.pre("nmod:poss" if p.maybe(0.5) else "det", words.word("the")))
        doing = doing if doing.right[0].left[0].rel == "det" else _with_an_owner(p, doing)
    elif doing.lemma == "point":
        way = words.noun(p.one("left right")).pre("det", words.word("the"))
        doing = doing.post("obl", way.pre("case", words.adposition("to")))
    if p.maybe(0.6):
        doing = doing.post("obl", p.nouns.marked("in", p.nouns.place()))
    person = person.post("acl", doing)
    if draw < 0.3:
        return inflection.imperative(p.one("greet follow find meet guide")).post("obj", person)
    verb, what = p.any(
        (("bring", p.thing()), ("deliver", p.thing()), ("say", p.the(words.noun("time"))), ("give", p.thing()))
    )
    return inflection.imperative(verb).post("obj", what).post("obl", p.nouns.marked("to", person))


def _with_an_owner(p: Phrases, doing: Node) -> Node:
    """The same with "their" in the place of "the"."""
    held = words.noun(doing.right[0].form).pre("nmod:poss", words.word(p.one("their his her")))
    return words.gerund(doing.lemma, "Tense=Pres|VerbForm=Part").post("obj", held)


@construction(weight=2)
def named_by_letter(p: Phrases) -> Node:
    """ "Bring the mug to room C." "Take the box from shelf A to room B." "Go to gate 4." """

    def lettered() -> Node:
        letter = p.any(_LETTERS)
        name = (
            Node(letter, letter, "PROPN", "NNP", "Number=Sing")
            if p.maybe(0.7)
            else words.number(p.any("1 2 3 4 7 12 204".split()))
        )
        head = words.noun(p.one("room shelf gate table point station level bay desk dock line"))
        return head.post("flat", name)

    if p.maybe(0.4):
        verb = inflection.imperative(p.one("go drive walk move"))
        return verb.post("obl", p.nouns.marked("to", lettered()))
    verb = inflection.imperative(p.one("bring take carry deliver move")).post("obj", p.thing())
    if p.maybe(0.4):
        verb = verb.post("obl", p.nouns.marked("from", lettered()))
    return verb.post("obl", p.nouns.marked("to", lettered()))


@construction(weight=2)
def person_with_a_role(p: Phrases) -> Node:
    """ "Find my sister Anna." "Give Uncle Bill the cup." "Bring the book to Professor Miller." """
    name = p.person_name()
    if p.maybe(0.5):
        role = words.noun(p.any(_ROLES)).pre("nmod:poss", words.word(p.one("my my your our his her")))
        person = role.post("appos", name)
    else:
        title = p.any(_TITLES)
        person = Node(title, title, "PROPN", "NNP", "Number=Sing").post("flat", name)
    draw = p.chooser.random()
    if draw < 0.4:
        return inflection.imperative(p.one("find follow greet call meet")).post("obj", person)
    if draw < 0.6:
        verb = inflection.imperative(p.one("bring give hand show"))
        return verb.post("iobj", person).post("obj", p.thing())
    verb = inflection.imperative(p.one("bring take give deliver")).post("obj", p.thing())
    return verb.post("obl", p.nouns.marked("to", person))


@construction(weight=2)
def short_commands_in_a_row(p: Phrases) -> Node:
    """ "Turn right walk to the sofa." "Turn around head to the door." "Take a step turn left to face the sink." """

    def one() -> Node:
        draw = p.chooser.random()
        if draw < 0.35:
            verb = inflection.imperative(p.one("turn turn rotate go look"))
            return verb.post("advmod", words.adverb(p.one("left right around left right")))
        if draw < 0.5:
            step = words.noun("step").pre("det", words.word("a")) if p.maybe(0.5) else None
            step = step or words.noun("step", True).pre("nummod", p.nouns.numeral(True))
            return inflection.imperative("take").post("obj", step)
        if draw < 0.6:
            face = inflection.imperative(p.one("face face cross pass enter leave"))
            return face.post("obj", p.nouns.fixture())
        verb = inflection.imperative(p.one("walk head go drive proceed move"))
        return verb.post("obl", p.nouns.marked(p.one("to to towards"), p.nouns.fixture()))

    first = one()
    for _ in range(p.any((1, 1, 2, 3))):
        first = first.post("parataxis", one())
    return first


@construction(weight=2)
def bare_object(p: Phrases) -> Node:
    """ "Open door." "Clean mirror." "Lower lights." "Welcome visitors." "Dry dishes slowly." """
    verb = inflection.imperative(
        p.one(
            "open clean lower dry welcome warm empty cool slow clear close light water dice slice free secure correct"
        )
    )
    verb = verb.post("obj", p.kind(p.maybe(0.4)))
    if p.maybe(0.3):
        verb = verb.post("obl", p.located_at())
    return verb


@construction(weight=1.5)
def pronoun_with_a_place(p: Phrases) -> Node:
    """ "Bring me something in a bowl." "Put everything on the table into the box." "Bring them both a cup." """
    draw = p.chooser.random()
    if draw < 0.3:
        both = words.word(p.one("them us")).post("det", words.word(p.one("both all")))
        return inflection.imperative(p.one("bring give hand")).post("iobj", both).post("obj", p.thing())
    form = p.one("something everything anything something")
    pronoun = Node(form, form, "PRON", "NN", "Number=Sing").post("nmod", p.located_at())
    if draw < 0.65:
        return inflection.imperative(p.one("bring give hand get")).post("iobj", words.word("me")).post("obj", pronoun)
    verb = inflection.imperative(p.one("put place move take bring")).post("obj", pronoun)
    return verb.post("obl", p.nouns.marked(p.one("into onto to"), p.nouns.fixture()))


@construction(weight=1.5)
def said_then_commanded(p: Phrases) -> Node:
    """ "The fridge is in the kitchen open it." "I am tired switch off the light." """
    if p.maybe(0.5):
        told = p.predicate(p.located_at(), (p.the(words.noun(p.any(p.lexicon.fixtures).split("_")[-1])), "3"))
    else:
        told = p.predicate(words.adjective(p.one("tired cold busy hungry dirty dark wet full late")), p.subject())
    return told.post("parataxis", p.phrase(inflection.imperative))
