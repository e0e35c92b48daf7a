"""Questions: about deeds, states, places, numbers; with the element asked for in front."""

from dataclasses import replace

from command_models import words
from command_models.trees import Node

from . import inflection
from .phrases import Phrases
from .registry import STRANDED, construction


def wh(form: str, xpos: str = "WRB", upos: str = "ADV") -> Node:
    """A question word."""
    return Node(form, form, upos, xpos, "PronType=Int")


WHAT, WHO = wh("what", "WP", "PRON"), wh("who", "WP", "PRON")


def which(p: Phrases, many: bool = False) -> Node:
    """ "which mug", "what box"."""
    form = p.one("which which what")
    return p.kind(many).pre("det", Node(form, form, "DET", "WDT", "PronType=Int"))


def how_much(p: Phrases) -> Node:
    """ "how many mugs", "how much water"."""
    if p.maybe(0.2):
        head, amount = words.noun(p.any(p.lexicon.masses)), "much"
    else:
        head, amount = p.kind(True), "many"
    return head.pre("amod", words.adjective(amount).pre("advmod", wh("how")))


def timed(p: Phrases, root: Node, chance: float = 0.3) -> Node:
    """Perhaps with a time of the past: "today", "yesterday", "at eight"."""
    if not p.maybe(chance):
        return root
    if p.maybe(0.5):
        return root.post("obl:unmarked", words.noun(p.one("today yesterday today")))
    return root.post(*p.when())


@construction("?", weight=2)
def did_you(p: Phrases) -> Node:
    """ "Did you close the door?" "Did Anna come back?" """
    return timed(p, p.clause(p.phrase, p.subject(p.one("you you you person they")), "past", asked=True))


@construction("?")
def did_not(p: Phrases) -> Node:
    """ "Didn't you close the door?" """
    return p.clause(p.phrase, p.subject("you"), p.one("past past present"), asked=True, negative=True)


@construction("?")
def are_you_doing(p: Phrases) -> Node:
    """ "Are you cleaning the table?" """
    return p.clause(p.phrase, p.subject(p.one("you you person")), "progressive", asked=True)


@construction("?")
def have_you(p: Phrases) -> Node:
    """ "Have you ever closed the door?" """
    adverb = words.adverb(p.one("ever ever already")) if p.maybe(0.6) else None
    return timed(p, p.clause(p.phrase, p.subject(p.one("you you person")), "perfect", asked=True, adverb=adverb), 0.1)


@construction("?")
def can_you(p: Phrases) -> Node:
    """ "Can you close doors?" "Are you able to dance?" """
    if p.maybe(0.25):
        inner = p.phrase(inflection.infinitive).pre("mark", words.word("to"))
        return p.predicate(words.adjective("able").post("xcomp", inner), p.subject("you"), asked=True)
    return p.clause(p.phrase, p.subject("you"), p.one("can can could will would may should must"), asked=True)


@construction("?", weight=1.5)
def what_did_you(p: Phrases) -> Node:
    """ "What did you bring?" "What are you carrying?" """
    tense = p.one("past past perfect progressive will can should present")
    root = p.clause(p.transitive, p.subject(p.one("you you person")), tense, asked=True)
    return timed(p, root.pre("obj", WHAT if p.maybe(0.8) else WHO))


@construction("?")
def what_doing(p: Phrases) -> Node:
    """ "What are you doing?" "What will you do next?" """
    tense = p.one("progressive progressive past will was_progressive perfect can")
    root = p.clause(lambda form: form("do"), p.subject(p.one("you you you person")), tense, asked=True)
    if p.maybe(0.4):
        root = root.post("advmod", words.adverb(p.one("now next then here")))
    return root.pre("obj", WHAT)


@construction("?")
def who_did(p: Phrases) -> Node:
    """ "Who closed the door?" "What fell down?" """
    tense = p.one("past past past perfect present progressive")
    root = p.clause(p.doing, None, tense)
    return root.pre("nsubj", WHO if p.maybe(0.8) else WHAT)


@construction("?", weight=1.5)
def when_did_you(p: Phrases) -> Node:
    """ "When did you close the door?" "Why are you waiting?" """
    tense = p.one("past past past perfect progressive will")
    root = p.clause(p.phrase, p.subject(p.one("you you person thing")), tense, asked=True)
    return root.pre("advmod", wh(p.one("when when why how where")))


@construction("?")
def where_did_you(p: Phrases) -> Node:
    """ "Where did you put the mug?" "Where do you keep the keys?" """
    tense = p.one("past past present perfect")
    root = p.clause(
        lambda form: form(p.one("put leave find take see lose keep store hide bring")).post("obj", p.thing()),
        p.subject(p.one("you you person")),
        tense,
        asked=True,
    )
    return root.pre("advmod", wh("where"))


@construction("?")
def where_is(p: Phrases) -> Node:
    """ "Where is the mug?" "Where are my keys?" "Where's Anna?" """
    who = p.subject(p.one("thing thing person"))
    be = words.word("is" if who[1] == "3" else "are")
    if p.maybe(0.15) and who[1] == "3":
        be = Node("'s", "be", "AUX", "VBZ", "VerbForm=Fin", glued=True)
    return wh("where").post("cop", be).post("nsubj", who[0])


@construction("?", weight=1.5)
def is_it(p: Phrases) -> Node:
    """ "Is the door open?" "Are the keys on the table?" "Isn't Anna here?" """
    tense = p.one("present present present past")
    return p.predicate(p.state(), p.subject(p.one("thing thing person")), tense, asked=True, negative=p.maybe(0.1))


@construction("?")
def is_there(p: Phrases) -> Node:
    """ "Is there a mug on the table?" "Are there any plates?" """
    many = p.maybe(0.4)
    head = p.kind(many)
    head = (
        head.pre("det", words.word(p.one("any any some") if many else "a"))
        if many or p.maybe(0.6)
        else head.pre("det", words.article(head.parts()[0].form, False) or words.word("a"))
    )
    root = words.word("are/VERB" if many else "is/VERB").post("expl", words.word("there/EX")).post("nsubj", head)
    return root.post("obl", p.located_at()) if p.maybe(0.7) else root


@construction("?")
def how_many(p: Phrases) -> Node:
    """ "How many mugs did you bring?" "How many chairs are there?" "How many cups are on the table?" """
    draw = p.chooser.random()
    what = how_much(p)
    if draw < 0.35:
        root = p.clause(p.transitive, p.subject(p.one("you you I person")), "past", asked=True)
        return root.pre("obj", what)
    if draw < 0.65:
        be = words.word("are/VERB" if what.xpos == "NNS" else "is/VERB")
        root = be.pre("nsubj", what).post("expl", words.word("there/EX"))
        return root.post("obl", p.located_at()) if p.maybe(0.7) else root
    return p.located_at().pre("cop", words.word("are" if what.xpos == "NNS" else "is")).pre("nsubj", what)


@construction("?")
def how_heavy(p: Phrases) -> Node:
    """ "How heavy is the box?" "How old are you?" """
    root = words.adjective(p.one("heavy old big tall warm cold far long hot large wide high full")).pre(
        "advmod", wh("how")
    )
    subject, person = p.subject(p.one("thing thing thing you person"))
    return root.post("cop", words.word("is" if person == "3" else "are")).post("nsubj", subject)


@construction("?")
def how_long(p: Phrases) -> Node:
    """ "How long will you wait?" "How long does it take to clean the table?" "How far did you go?" """
    asked = words.adverb(p.one("long long far fast quickly")).pre("advmod", wh("how"))
    if p.maybe(0.4):
        to = p.phrase(inflection.infinitive).pre("mark", words.word("to"))
        it = words.word("it/NOM")
        root = p.clause(
            lambda form: form("take").post("csubj", to), (it, "3"), p.one("present will will past"), asked=True
        )
        # A clause behind "it" is the subject, and "it" holds its place.
        left = tuple(replace(node, rel="expl") if node.rel == "nsubj" else node for node in root.left)
        root = replace(root, left=left)
        return root.pre("advmod", Node("long", "long", "ADV", "RB").pre("advmod", wh("how")))
    return p.clause(p.phrase, p.subject("you"), p.one("will past can perfect"), asked=True).pre("advmod", asked)


@construction("?")
def what_superlative(p: Phrases) -> Node:
    """ "What is the heaviest thing on the shelf?" "Which is the nearest chair?" """
    from .phrasal import superlative

    head = superlative(p, words.noun(p.one("thing thing object")) if p.maybe(0.4) else p.kind())
    head = head.pre("det", words.word("the"))
    if p.maybe(0.6):
        head = head.post("nmod", p.located_at())
    asked = WHAT if p.maybe(0.6) else Node("which", "which", "PRON", "WDT", "PronType=Int")
    return asked.post("cop", words.word("is")).post("nsubj", head)


@construction("?")
def what_colour(p: Phrases) -> Node:
    """ "What colour is the mug?" "What time is it?" "What kind of box is this?" """
    draw = p.chooser.random()
    what = Node("what", "what", "DET", "WDT", "PronType=Int")
    if draw < 0.2:
        subject = words.word("it/NOM")
        root = words.noun("time").pre("det", what)
    elif draw < 0.7:
        subject = p.subject("thing")[0]
        while subject.xpos == "NNS":
            subject = p.subject("thing")[0]
        root = words.noun(p.one("colour color size shape material brand")).pre("det", what)
    else:
        subject = words.word(p.one("this/PRON that/PRON"))
        root = (
            words.noun(p.one("kind sort")).pre("det", what).post("nmod", p.kind().pre("case", words.adposition("of")))
        )
    return root.post("cop", words.word("is")).post("nsubj", subject)


@construction("?")
def whose(p: Phrases) -> Node:
    """ "Whose mug is this?" "Whose keys are on the table?" """
    owner = Node("whose", "whose", "PRON", "WP$", "Poss=Yes|PronType=Int")
    head = p.kind(p.maybe(0.3)).pre("nmod:poss", owner)
    be = words.word("are" if head.xpos == "NNS" else "is")
    if p.maybe(0.5):
        this = words.word(p.one("these/PRON those/PRON") if head.xpos == "NNS" else p.one("this/PRON that/PRON it/NOM"))
        return head.post("cop", be).post("nsubj", this)
    return p.located_at().pre("cop", be).pre("nsubj", head)


@construction("?", projective=False)
def stranded(p: Phrases) -> Node:
    """ "Which room did you go to?" "Who did you give it to?" "What are you looking for?" """
    verb, preposition = p.any(
        (
            ("go", "to"),
            ("look", "for"),
            ("look", "at"),
            ("wait", "for"),
            ("talk", "to"),
            ("drive", "to"),
            ("come", "from"),
        )
    )
    case = words.adposition(preposition)
    asked = which(p) if p.maybe(0.6) else (WHO if p.maybe(0.5) else WHAT)
    tense = p.one("past past progressive perfect")
    root = p.clause(lambda form: form(verb), p.subject(p.one("you you person")), tense, asked=True)
    return root.pre("obl", asked).post(STRANDED, case)


@construction("?")
def or_question(p: Phrases) -> Node:
    """ "Is the mug on the table or in the sink?" "Do you want tea or coffee?" """
    if p.maybe(0.6):
        other = p.located_at().pre("cc", words.word("or"))
        return p.predicate(p.located_at().post("conj", other), p.subject("thing"), asked=True)
    other = p.thing().pre("cc", words.word("or"))
    return p.clause(
        lambda form: form(p.one("want take need prefer see bring")).post("obj", p.thing().post("conj", other)),
        p.subject("you"),
        p.one("present past"),
        asked=True,
    )


@construction("?")
def who_is(p: Phrases) -> Node:
    """ "Who is this?" "Who are you?" "What is your name?" "What's that?" """
    draw = p.chooser.random()
    be = words.word("is")
    if p.maybe(0.3):
        be = Node("'s", "be", "AUX", "VBZ", "VerbForm=Fin", glued=True)
    if draw < 0.2:
        return WHO.post("cop", words.word("are/2")).post("nsubj", words.word("you"))
    if draw < 0.45:
        name = words.noun(p.one("name job owner task")).pre("nmod:poss", words.word(p.one("your my his her/POSS")))
        return WHAT.post("cop", be).post("nsubj", name)
    if draw < 0.7:
        return (WHO if p.maybe(0.4) else WHAT).post("cop", be).post("nsubj", words.word(p.one("this/PRON that/PRON")))
    return (WHO if p.maybe(0.5) else WHAT).post("cop", be).post("nsubj", p.thing() if p.maybe(0.5) else p.person_name())
