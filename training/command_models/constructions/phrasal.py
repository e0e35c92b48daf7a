"""Phrases: lists with and without commas and "and", times and amounts, superlatives, counted things, exclusion."""

from typing import Callable, Tuple

from command_models import words
from command_models.trees import Node

from . import inflection
from .phrases import Phrases, before_all
from .registry import construction

_SUPERLATIVES: Tuple[Tuple[str, str], ...] = tuple(
    (entry.split(":")[0], entry.split(":")[1])
    for entry in """heavy:heaviest big:biggest small:smallest large:largest old:oldest new:newest light:lightest
    tall:tallest near:nearest close:closest thin:thinnest cheap:cheapest clean:cleanest dirty:dirtiest cold:coldest
    warm:warmest hot:hottest short:shortest long:longest far:farthest bright:brightest dark:darkest""".split()
)
_LONG = "expensive beautiful dangerous comfortable important recent colourful fragile".split()
_WAYS = """
    underneath beneath under along across through past over around between beyond alongside amongst onto inside outside
    toward by"""
_ORDERS = "first second third fourth fifth last next".split()


def superlative(p: Phrases, head: Node) -> Node:
    """ "heaviest box", "most expensive box"."""
    if p.maybe(0.15):
        return head.pre("amod", words.adjective(p.any(_LONG)).pre("advmod", Node("most", "most", "ADV", "RBS")))
    lemma, form = p.any(_SUPERLATIVES)
    return head.pre("amod", Node(form, lemma, "ADJ", "JJS", "Degree=Sup"))


def used(p: Phrases, what: Node) -> Node:
    """A command about a phrase: bring it, go to it."""
    if p.maybe(0.65):
        return p.transitive(inflection.imperative, what, (0, 0, 1))
    verb = inflection.imperative(p.one("go drive walk come move point"))
    return verb.post("obl", p.nouns.marked(p.one("to to near next_to"), what))


def listed(p: Phrases, make: Callable[[], Node], count: int, commas: bool, final: str) -> Node:
    """Several phrases joined; ``final`` is "and", "or" or empty."""
    head = make()
    for at in range(1, count):
        other = make()
        if at == count - 1 and final:
            other = other.pre("cc", words.word(final))
            if commas and count > 2 and p.maybe(0.3):
                other = other.pre("punct", words.comma())
        elif commas:
            other = other.pre("punct", words.comma())
        head = head.post("conj", other)
    return head


def places(p: Phrases) -> Node:
    return p.nouns.place() if p.maybe(0.6) else p.the(words.noun(p.any([x for x in p.lexicon.places if "_" not in x])))


@construction(weight=2)
def places_run_on(p: Phrases) -> Node:
    """ "Go to the kitchen the office and the hall." """
    what = listed(p, lambda: places(p), p.any((3, 3, 4)), False, "and")
    if p.maybe(0.5):
        return inflection.imperative("go").post("obl", p.nouns.marked("to", what))
    return inflection.imperative(p.one("visit clean check inspect search explore")).post("obj", what)


@construction(weight=1.5)
def places_with_commas(p: Phrases) -> Node:
    """ "Go to the kitchen, the office and the hall." "Visit the hall, the lab, the office." """
    what = listed(p, lambda: places(p), p.any((3, 3, 4)), True, p.one("and and and or") if p.maybe(0.75) else "")
    if p.maybe(0.5):
        return inflection.imperative(p.one("go drive walk")).post("obl", p.nouns.marked("to", what))
    return inflection.imperative(p.one("visit clean check inspect search")).post("obj", what)


@construction(weight=2.5)
def things_listed(p: Phrases) -> Node:
    """ "Bring the mug the plate and the fork to the table." """
    what = listed(p, lambda: p.thing(p.maybe(0.2)), p.any((2, 3, 3, 4)), p.maybe(0.5), "and")
    return p.transitive(inflection.imperative, what)


@construction()
def people_listed(p: Phrases) -> Node:
    """ "Say hello to Anna Mark and the guest." "Greet Anna, Bill and Rose." """
    what = listed(p, p.nouns.person if p.maybe(0.3) else p.person_name, p.any((2, 3, 3)), p.maybe(0.5), "and")
    if p.maybe(0.5):
        return inflection.imperative(p.one("greet follow call find meet")).post("obj", what)
    hello = words.interjection(p.one("hello hi goodbye"))
    return inflection.imperative("say").post("obj", hello).post("obl", p.nouns.marked("to", what))


@construction(weight=2.5)
def deeds_listed(p: Phrases) -> Node:
    """ "Take the mug go to the kitchen and clean it." with and without commas"""
    return listed(
        p,
        lambda: p.phrase(inflection.imperative),
        p.any((2, 3, 3)),
        p.maybe(0.5),
        p.one("and and and or") if p.maybe(0.8) else "",
    )


@construction()
def phrases_listed(p: Phrases) -> Node:
    """ "Go to the kitchen and then to the hall." "Look under the bed and behind the sofa." """
    first, second = p.nouns.marked("to", places(p)), p.nouns.marked("to", places(p))
    verb = p.one("go drive walk")
    if p.maybe(0.4):
        verb, first, second = p.one("look search"), p.located_at(), p.located_at()
    if p.maybe(0.5):
        second = second.pre("advmod", words.word("then"))
    return inflection.imperative(verb).post("obl", first.post("conj", second.pre("cc", words.word("and"))))


@construction(weight=2)
def adjectives_listed(p: Phrases) -> Node:
    """ "Bring the red and the blue mug." "Bring the big, red box." """
    first, second = (words.adjective(p.any(p.lexicon.adjectives)) for _ in range(2))
    head = p.kind()
    if p.maybe(0.5):
        second = second.pre("cc", words.word(p.one("and and or")))
        head = head.pre("amod", first.post("conj", second))
    else:
        if p.maybe(0.4):
            # In EWT the comma hangs on the first: 41 of 41.
            first = first.post("punct", words.comma())
        head = head.pre("amod", second).pre("amod", first)
    return used(p, p.the(head))


@construction(weight=2)
def at_a_time(p: Phrases) -> Node:
    """ "Close the window at 20:15." "Wake me at half past eight." """
    return p.phrase(inflection.imperative).post("obl", p.clock().pre("case", words.adposition("at")))


@construction(weight=1.5)
def at_some_time(p: Phrases) -> Node:
    """ "Clean the table on Monday." "In five minutes go to the hall." """
    relation, when = p.when()
    root = p.phrase(inflection.imperative)
    if p.maybe(0.4):
        return before_all(root, relation, when, p.maybe(0.4))
    return root.post(relation, when)


@construction()
def day_and_time(p: Phrases) -> Node:
    """ "Remind me tomorrow at eight." "Wake me on Monday at 7 am." """
    clock = p.clock().pre("case", words.adposition("at"))
    root = p.phrase(inflection.imperative)
    if p.maybe(0.6):
        root = root.post("obl:unmarked", words.noun(p.one("today tomorrow tonight")))
        return root.post("obl", clock)
    day = words.name(p.one("Monday Tuesday Wednesday Thursday Friday Saturday Sunday"))
    return root.post("obl", day.pre("case", words.adposition("on"))).post("obl", clock)


@construction()
def for_a_while(p: Phrases) -> Node:
    """ "Wait for five minutes." "Go forward for a distance of two metres." """
    if p.maybe(0.5):
        return p.phrase(inflection.imperative).post("obl", p.nouns.marked("for", p.nouns.measure("time")))
    root = inflection.imperative(p.one("go move drive walk roll back"))
    root = root.post("advmod", words.adverb(p.one("forward back straight left right ahead")))
    if p.maybe(0.5):
        distance = words.noun("distance").pre("det", words.word("a"))
        distance = distance.post("nmod", p.nouns.marked("of", p.nouns.measure("move")))
        return root.post("obl", p.nouns.marked("for", distance))
    return root.post("obl", p.nouns.marked(p.one("for by"), p.nouns.measure("move")))


@construction()
def until_time(p: Phrases) -> Node:
    """ "Stay here until five o'clock." "Work from 8 to 10 am" """
    root = p.phrase(inflection.imperative)
    return root.post("obl", p.clock().pre("case", words.adposition(p.one("until until till after"))))


@construction()
def every_so_often(p: Phrases) -> Node:
    """ "Check the door every five minutes." "Feed the cat twice a day." "Water it three times a week." """
    root = p.phrase(inflection.imperative)
    draw = p.chooser.random()
    span = words.noun(p.one("day week hour month minute"))
    if draw < 0.45:
        if p.maybe(0.5):
            span = words.noun(p.one("minute hour day second week"), True).pre("nummod", p.nouns.numeral(True))
        return root.post("obl:unmarked", span.pre("det", words.word("every")))
    span = span.pre("det", words.article(span.form, False) or words.word("a"))
    if draw < 0.75:
        return root.post("advmod", words.adverb(p.one("once twice")).post("obl:unmarked", span))
    times = words.noun("time", True).pre("nummod", p.nouns.numeral(True))
    return root.post("obl:unmarked", times.post("nmod:unmarked", span) if p.maybe(0.6) else times)


@construction()
def amount_of(p: Phrases) -> Node:
    """ "Bring me two litres of water." "Get a glass of juice." "Weigh 200 grams of flour." """
    unit = p.one("litre gram kilo glass bottle cup bag box spoon slice piece bowl")
    many = p.maybe(0.6)
    head = words.noun(unit, many)
    head = (
        head.pre("nummod", p.nouns.numeral())
        if many
        else head.pre("det", words.article(unit, False) or words.word("a"))
    )
    what = words.noun(p.any(p.lexicon.masses))
    return p.transitive(inflection.imperative, head.post("nmod", p.nouns.marked("of", what)))


@construction()
def at_least(p: Phrases) -> Node:
    """ "Bring at least two mugs." "Wait more than five minutes." """
    number = p.nouns.numeral(True)
    if p.maybe(0.55):
        least = Node("least", "least", "ADJ", "JJS", "Degree=Sup").pre("case", words.adposition("at"))
        number = number.pre("nmod", least)
    else:
        than = Node("than", "than", "ADP", "IN")
        form = p.one("more more less")
        more = Node(form, "more" if form == "more" else "less", "ADJ", "JJR", "Degree=Cmp").post("fixed", than)
        number = number.pre("advmod", more)
    if p.maybe(0.6):
        return used(p, p.kind(True).pre("nummod", number))
    amount = words.noun(p.one("minute second hour metre degree"), True).pre("nummod", number)
    return inflection.imperative(p.one("wait stay rest sleep")).post("obl", p.nouns.marked("for", amount))


@construction()
def about_so_many(p: Phrases) -> Node:
    """ "Bring exactly two mugs." "Wait about ten minutes." "Move almost three metres." """
    number = p.nouns.numeral(True).pre("advmod", words.adverb(p.one("about exactly almost nearly over roughly")))
    if p.maybe(0.6):
        return used(p, p.kind(True).pre("nummod", number))
    amount = words.noun(p.one("minute second hour metre degree step"), True).pre("nummod", number)
    if p.maybe(0.5):
        return inflection.imperative(p.one("wait stay rest move turn")).post("obl:unmarked", amount)
    return inflection.imperative(p.one("wait stay rest sleep")).post("obl", p.nouns.marked("for", amount))


@construction()
def as_fast_as(p: Phrases) -> Node:
    """ "Clean the table as quickly as possible." "Come as fast as you can." """
    if p.maybe(0.5):
        clause = words.adjective("possible")
    else:
        clause = words.modal(p.one("can can could")).pre("nsubj", p.subject(p.one("you you they person"))[0])
    clause = clause.pre("mark", Node("as", "as", "SCONJ", "IN"))
    how = words.adverb(p.one("fast quickly far quietly carefully slowly often gently")).pre(
        "advmod", words.adverb("as")
    )
    return p.phrase(inflection.imperative).post("advmod", how.post("advcl", clause))


@construction(weight=1.5)
def the_heaviest(p: Phrases) -> Node:
    """ "Bring the heaviest box." "Go to the nearest door in the hall." """
    head = p.the(superlative(p, p.kind(p.maybe(0.15))))
    if p.maybe(0.35):
        head = head.post("nmod", p.located_at())
    return used(p, head)


@construction(weight=1.5)
def the_three_heaviest(p: Phrases) -> Node:
    """ "Bring the three heaviest boxes." """
    head = p.the(superlative(p, p.kind(True)).pre("nummod", p.nouns.numeral(True)))
    if p.maybe(0.3):
        head = head.post("nmod", p.located_at())
    return used(p, head)


@construction()
def the_second_from_the_left(p: Phrases) -> Node:
    """ "Take the second box from the left." "Open the third door on the right." """
    head = p.the(p.kind().pre("amod", words.adjective(p.any(_ORDERS))))
    side = p.the(words.noun(p.one("left right top bottom")))
    return used(p, head.post("nmod", side.pre("case", words.adposition(p.one("from from on")))))


@construction()
def nearest_to(p: Phrases) -> Node:
    """ "Bring the mug nearest to the door." "Take the box closest to me." """
    lemma, form = p.any((("near", "nearest"), ("close", "closest"), ("near", "nearest"), ("next", "next")))
    to = (words.word("me") if p.maybe(0.3) else p.nouns.fixture()).pre("case", words.adposition("to"))
    near = Node(form, lemma, "ADJ", "JJS" if form != "next" else "JJ", "Degree=Sup").post("obl", to)
    if form == "next":
        return used(p, p.the(p.kind()).post("nmod", p.nouns.marked("next_to", p.nouns.fixture())))
    return used(p, p.the(p.kind()).post("amod", near))


@construction()
def one_of(p: Phrases) -> Node:
    """ "Bring one of the mugs." "Take two of them." "Clean each of the tables." "Bring all of the plates." """
    form = p.one("one two three both all each some any")
    them = words.word("them") if p.maybe(0.3) else p.the(p.kind(True))
    if form in ("one", "two", "three"):
        head = words.number(form)
    else:
        head = Node(form, form, "DET", "DT", "PronType=Tot")
    return used(p, head.post("nmod", p.nouns.marked("of", them)))


@construction()
def all_things(p: Phrases) -> Node:
    """ "Bring all the red mugs." "Clean every table." "Take both boxes." """
    head = p.kind(True)
    if p.maybe(0.3):
        head = head.pre("amod", words.adjective(p.any(p.lexicon.adjectives)))
    draw = p.chooser.random()
    if draw < 0.45:
        head = p.the(head).pre("det:predet", words.word("all/PDT"))
    elif draw < 0.7:
        head = head.pre("det", words.word(p.one("all both some any")))
    else:
        head = p.kind().pre("det", words.word(p.one("every each every")))
    return used(p, head.post("nmod", p.located_at()) if p.maybe(0.3) else head)


@construction()
def except_this(p: Phrases) -> Node:
    """ "Bring all mugs except the red one." "Clean every room but the kitchen." """
    head = (
        p.the(p.kind(True)).pre("det:predet", words.word("all/PDT"))
        if p.maybe(0.5)
        else p.kind().pre("det", words.word("every"))
    )
    if p.maybe(0.4):
        other = p.the(
            Node("one", "one", "NOUN", "NN", "Number=Sing").pre("amod", words.adjective(p.any(p.lexicon.adjectives)))
        )
    else:
        other = p.the(p.kind())
    return used(p, head.post("nmod", other.pre("case", words.adposition(p.one("except except but")))))


@construction()
def the_red_one(p: Phrases) -> Node:
    """ "Bring the red one." "Take the one on the table." """
    one = Node("one", "one", "NOUN", "NN", "Number=Sing") if p.maybe(0.7) else Node("ones", "one", "NOUN", "NNS")
    if p.maybe(0.6):
        one = one.pre("amod", words.adjective(p.any(p.lexicon.adjectives)))
        return used(p, p.the(one))
    return used(p, p.the(one).post("nmod", p.located_at()))


@construction()
def heavier_than(p: Phrases) -> Node:
    """ "The box is heavier than the bag." "Bring a mug bigger than this one." """
    lemma, form = p.any(_SUPERLATIVES[:14])
    compared = form[:-3] + "er" if form.endswith("est") else form
    than = p.thing().pre("case", Node("than", "than", "ADP", "IN"))
    comparative = Node(compared, lemma, "ADJ", "JJR", "Degree=Cmp").post("obl", than)
    if p.maybe(0.6):
        return p.predicate(comparative, p.subject("thing"), p.one("present present past"))
    return used(p, p.kind().pre("det", words.word("a")).post("amod", comparative))


@construction(weight=1.5)
def where_it_goes(p: Phrases) -> Node:
    """ "Put the pan on the left on the stove." "Bring the mug from the table to Anna in the hall." """
    draw = p.chooser.random()
    if draw < 0.4:
        verb = inflection.imperative(p.one("put put place set leave"))
        return verb.post("obj", p.thing()).post("obl", p.nouns.placing())
    if draw < 0.75:
        verb = inflection.imperative(p.one("bring take carry move"))
        source = p.nouns.marked("from", p.place())
        goal = p.nouns.marked("to", p.nouns.person() if p.maybe(0.4) else p.place())
        return verb.post("obj", p.thing()).post("obl", source).post("obl", goal)
    verb = inflection.imperative(p.one("crawl walk drive go move run roll"))
    return verb.post(
        "obl",
        p.nouns.marked(
            p.one(_WAYS),
            p.nouns.fixture(),
        ),
    )
