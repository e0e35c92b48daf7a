"""Constructions for scoring alone: no training sentence has them. They were fixed before the first training."""

from dataclasses import replace

from command_models import words
from command_models.trees import Node

from . import inflection
from .embedded import addressee, embedded_question, person_object, that
from .phrasal import listed, places, superlative, used
from .phrases import Phrases
from .questions import WHAT, WHO, timed, wh, which
from .registry import construction
from .subordinate import joined, main, marked, with_phrase


@construction("?", scored=True)
def which_did_you(p: Phrases) -> Node:
    """ "Which mug did you bring?" """
    root = p.clause(p.transitive, p.subject(p.one("you you person")), "past", asked=True)
    return timed(p, root.pre("obj", which(p, p.maybe(0.2))))


@construction("?", scored=True)
def why_did_you_not(p: Phrases) -> Node:
    """ "Why did you not close the door?" "Why haven't you docked?" """
    root = p.clause(p.phrase, p.subject("you"), p.one("past past perfect"), asked=True, negative=True)
    return root.pre("advmod", wh("why"))


@construction("?", scored=True)
def how_often(p: Phrases) -> Node:
    """ "How often have you closed the door today?" """
    root = p.clause(p.phrase, p.subject(p.one("you you person")), p.one("perfect past present"), asked=True)
    return root.pre("advmod", words.adverb("often").pre("advmod", wh("how")))


@construction("?", scored=True)
def what_is_where(p: Phrases) -> Node:
    """ "What is on the table?" "Who is in the kitchen?" """
    return p.predicate(p.located_at(), None).pre("nsubj", WHAT if p.maybe(0.6) else WHO)


@construction("?", scored=True)
def which_is_heavier(p: Phrases) -> Node:
    """ "Which box is heavier than the bag?" """
    form, lemma = p.any(
        (("heavier", "heavy"), ("bigger", "big"), ("older", "old"), ("warmer", "warm"), ("taller", "tall"))
    )
    than = p.thing().pre("case", Node("than", "than", "ADP", "IN"))
    root = Node(form, lemma, "ADJ", "JJR", "Degree=Cmp").post("obl", than)
    return p.predicate(root, None).pre("nsubj", which(p))


@construction("?", scored=True)
def passive_question(p: Phrases) -> Node:
    """ "Was the door closed?" "Has the table been cleaned by Anna?" """
    tense = p.one("present past past perfect")
    return p.predicate(p.passive(agent=0.3), p.subject("thing"), tense, asked=True, passive=True)


@construction("?", scored=True)
def would_you_like(p: Phrases) -> Node:
    """ "Why don't you close the door?" "Would you like to dance?" """
    if p.maybe(0.5):
        root = p.clause(p.phrase, p.subject("you"), "present", asked=True, negative=True)
        return root.pre("advmod", wh("why"))
    inner = p.phrase(inflection.infinitive).pre("mark", words.word("to"))
    return p.clause(lambda form: form("like").post("xcomp", inner), p.subject("you"), "would", asked=True)


@construction(scored=True)
def after_clause(p: Phrases) -> Node:
    """ "After you have closed the door, say hello." """
    return joined(p, main(p), marked(p.event(), "after"), 0.6)


@construction(scored=True)
def whenever_clause(p: Phrases) -> Node:
    """ "Whenever Anna comes in, greet her." """
    return joined(p, main(p), marked(p.event(), "whenever"), 0.6)


@construction(scored=True)
def as_soon_as(p: Phrases) -> Node:
    """ "As soon as the door is open, go to the hall." """
    clause = p.event().pre("mark", Node("as", "as", "SCONJ", "IN"))
    soon = words.adverb("soon").pre("advmod", words.adverb("as")).post("advcl", clause)
    if p.maybe(0.5):
        return main(p).pre("advmod", soon.post("punct", words.comma()) if p.maybe(0.6) else soon)
    return main(p).post("advmod", soon)


@construction(scored=True)
def before_gerund(p: Phrases) -> Node:
    """ "Before leaving the room, close the door." """
    return joined(p, main(p), marked(p.phrase(inflection.gerund), "before"), 0.6)


@construction(scored=True)
def not_until(p: Phrases) -> Node:
    """ "Do not say hello until you have closed the door." """
    root = p.phrase(inflection.imperative)
    root = root.pre("advmod", words.word("not")).pre("aux", words.word("do"))
    return root.post("advcl", marked(p.event(), "until"))


@construction(scored=True)
def passive_perfect(p: Phrases) -> Node:
    """ "The door has been closed." """
    return p.predicate(p.passive(agent=0.3), p.subject("thing"), "perfect", passive=True, negative=p.maybe(0.2))


@construction(scored=True)
def needs_closing(p: Phrases) -> Node:
    """ "The door needs closing." "The door needs to be closed." """
    if p.maybe(0.5):
        inner = inflection.gerund(p.unit(True).verb)
    else:
        inner = p.passive(agent=0.1)
        inner = inner.pre("aux:pass", Node("be", "be", "AUX", "VB", "VerbForm=Inf")).pre("mark", words.word("to"))
    return p.clause(lambda form: form("need").post("xcomp", inner), p.subject("thing"), "present")


@construction(scored=True)
def relative_with_preposition(p: Phrases) -> Node:
    """ "Go to the charger at which you docked." """
    head = p.kind().pre("det", words.word("the"))
    pronoun = words.word("which").pre("case", words.adposition(p.one("at in on to from")))
    clause = p.clause(p.happening, p.subject(p.one("you I person")), p.one("past present perfect"))
    return with_phrase(p, head.post("acl:relcl", clause.pre("obl", pronoun)))


@construction(scored=True)
def relative_where(p: Phrases) -> Node:
    """ "Go to the room where you left the mug." """
    head = p.the(words.noun(p.any([one for one in p.lexicon.places if "_" not in one])))
    clause = p.clause(p.phrase, p.subject(p.one("you I person")), p.one("past past present perfect"))
    return inflection.imperative(p.one("go go drive return come")).post(
        "obl", p.nouns.marked("to", head.post("acl:relcl", clause.pre("advmod", wh("where"))))
    )


@construction(scored=True)
def relative_stranded(p: Phrases) -> Node:
    """ "Clean the room you went to." """
    head = p.kind().pre("det", words.word("the"))
    verb, preposition = p.any((("go", "to"), ("look", "for"), ("talk", "about"), ("come", "from"), ("sit", "on")))
    clause = p.clause(lambda form: form(verb), p.subject(p.one("you I we")), p.one("past progressive perfect"))
    return with_phrase(p, head.post("acl:relcl", clause.post("obl", words.adposition(preposition))))


@construction(scored=True)
def things_without_and(p: Phrases) -> Node:
    """ "Bring the mug the plate the fork." """
    what = listed(p, lambda: p.the(p.kind()), 3, False, "")
    return p.transitive(inflection.imperative, what, (0,))


@construction(scored=True)
def either_or(p: Phrases) -> Node:
    """ "Bring either the mug or the plate." "Clean both the kitchen and the hall." """
    first, joint = p.any((("either", "or"), ("both", "and")))
    conj = p.the(p.kind()).pre("cc", words.word(joint))
    preconj = Node(first, first, "CCONJ", "CC")
    return used(p, p.the(p.kind()).pre("cc:preconj", preconj).post("conj", conj))


@construction(scored=True)
def everything_except(p: Phrases) -> Node:
    """ "Bring everything except the mug." "Greet everybody but Anna." """
    if p.maybe(0.6):
        head, other = words.word("everything"), p.the(p.kind())
    else:
        form = p.one("everybody everyone")
        head, other = Node(form, form, "PRON", "NN", "Number=Sing"), p.person_name()
    other = other.pre("case", words.adposition(p.one("except except but")))
    verb = inflection.imperative(
        p.one("bring clean take move open") if head.form == "everything" else p.one("greet follow call find")
    )
    return verb.post("obj", head.post("nmod", other))


@construction(scored=True)
def by_a_time(p: Phrases) -> Node:
    """ "Clean the table by noon." "Be back before 8 pm" """
    return p.phrase(inflection.imperative).post(
        "obl", p.clock().pre("case", words.adposition(p.one("by before around")))
    )


@construction(scored=True)
def time_in_front(p: Phrases) -> Node:
    """ "At 20:15, close the window." """
    clock = p.clock().pre("case", words.adposition("at"))
    return p.phrase(inflection.imperative).pre("obl", clock.post("punct", words.comma()) if p.maybe(0.5) else clock)


@construction(scored=True)
def minutes_later(p: Phrases) -> Node:
    """ "Five minutes later, go to the hall." "Come back two hours later." """
    span = words.noun(p.one("minute hour second day"), True).pre("nummod", p.nouns.numeral(True))
    later = Node("later", "late", "ADV", "RBR").pre("obl:unmarked", span)
    if p.maybe(0.5):
        return p.phrase(inflection.imperative).pre("advmod", later.post("punct", words.comma()))
    return p.phrase(inflection.imperative).post("advmod", later)


@construction(scored=True)
def at_most(p: Phrases) -> Node:
    """ "Bring at most two mugs." """
    most = Node("most", "most", "ADJ", "JJS", "Degree=Sup").pre("case", words.adposition("at"))
    return used(p, p.kind(True).pre("nummod", p.nouns.numeral(True).pre("nmod", most)))


@construction(scored=True)
def the_two_most_expensive(p: Phrases) -> Node:
    """ "Bring the two most expensive mugs." "Bring the second heaviest box" """
    long = words.adjective(p.one("expensive beautiful fragile valuable useful")).pre(
        "advmod", Node("most", "most", "ADV", "RBS")
    )
    head = p.kind(True).pre("amod", long).pre("nummod", p.nouns.numeral(True))
    return used(p, p.the(head))


@construction(scored=True)
def the_oldest_of(p: Phrases) -> Node:
    """ "Bring the oldest of the three boxes." "Take the second from the left." """
    if p.maybe(0.5):
        mugs = p.the(p.kind(True).pre("nummod", p.nouns.numeral(True)))
        form, lemma = p.any((("oldest", "old"), ("biggest", "big"), ("heaviest", "heavy"), ("nearest", "near")))
        head = p.the(Node(form, lemma, "ADJ", "JJS", "Degree=Sup")).post("nmod", p.nouns.marked("of", mugs))
    else:
        side = p.the(words.noun(p.one("left right top"))).pre("case", words.adposition("from"))
        head = p.the(words.adjective(p.one("first second third fourth last"))).post("nmod", side)
    return used(p, head)


@construction(scored=True)
def make_certain(p: Phrases) -> Node:
    """ "Make certain that the door is closed." "Be sure to close the door." """
    if p.maybe(0.5):
        certain = words.adjective("certain").post("ccomp", that(p, p.event()))
        return inflection.imperative("make").post("xcomp", certain)
    inner = p.phrase(inflection.infinitive).pre("mark", words.word("to"))
    return words.adjective("sure").post("xcomp", inner).pre("cop", Node("be", "be", "AUX", "VB", "Mood=Imp"))


@construction(scored=True)
def ask_whether(p: Phrases) -> Node:
    """ "Ask Anna whether she is tired." "I want to know if the door is open." """
    clause = p.event().pre("mark", words.word(p.one("if whether")))
    if p.maybe(0.5):
        whom = p.person_name() if p.maybe(0.6) else words.word(p.one("him her them"))
        return inflection.imperative("ask").post("iobj", whom).post("ccomp", clause)
    know = inflection.infinitive("know").post("ccomp", clause).pre("mark", words.word("to"))
    return p.clause(lambda form: form("want").post("xcomp", know), (words.word("I"), "I"), "present")


@construction(scored=True)
def let_me_know(p: Phrases) -> Node:
    """ "Let me know when the door is open." "Let Anna know what you did." """
    know = inflection.infinitive("know")
    if p.maybe(0.5):
        know = know.post("ccomp", embedded_question(p))
    else:
        know = know.post("ccomp", p.event().pre("mark", words.word(p.one("if whether"))))
    return inflection.imperative("let").post("obj", person_object(p)).post("xcomp", know)


@construction(scored=True)
def not_allowed(p: Phrases) -> Node:
    """ "You are not allowed to enter the kitchen." "You don't have to wait." """
    inner = p.phrase(inflection.infinitive).pre("mark", words.word("to"))
    if p.maybe(0.5):
        allowed = inflection.passive("allow").post("xcomp", inner)
        return p.predicate(allowed, p.subject("you"), passive=True, negative=p.maybe(0.7))
    return p.clause(lambda form: form("have").post("xcomp", inner), p.subject("you"), "present", negative=True)


@construction("?", scored=True)
def called_in_the_middle(p: Phrases) -> Node:
    """ "Could you, Max, close the door?" "Did you close the door, Max?" """
    root = p.clause(p.phrase, p.subject("you"), p.one("could can past would"), asked=True)
    who = addressee(p)
    return root.post("vocative", who.pre("punct", words.comma()) if p.maybe(0.7) else who)


@construction(scored=True)
def denied_deed(p: Phrases) -> Node:
    """ "Anna did not close the door." "You haven't cleaned the table." """
    return timed(
        p,
        p.clause(p.doing, p.subject(p.one("person you I they")), p.one("past past perfect present"), negative=True),
        0.1,
    )


@construction(scored=True)
def superlative_place(p: Phrases) -> Node:
    """ "Go to the room that is nearest to the stairs and wait there." two commands, one with a description"""
    head = p.the(superlative(p, words.noun(p.any([one for one in p.lexicon.places if "_" not in one]))))
    root = inflection.imperative(p.one("go drive walk")).post("obl", p.nouns.marked("to", head))
    other = p.phrase(inflection.imperative).pre("cc", words.word("and"))
    return root.post("conj", other)


@construction(scored=True)
def when_and_when(p: Phrases) -> Node:
    """ "When the door is open and Anna is here, say hello." """
    other = p.event().pre("cc", words.word(p.one("and and or")))
    return joined(p, main(p), marked(p.event().post("conj", other), p.one("when if")), 0.7)


@construction(scored=True)
def first_then(p: Phrases) -> Node:
    """ "First go to the kitchen, then to the hall." """
    other = p.nouns.marked("to", places(p)).pre("advmod", words.word("then")).pre("punct", words.comma())
    goal = p.nouns.marked("to", places(p)).post("conj", other)
    root = inflection.imperative(p.one("go drive walk")).post("obl", goal)
    return root.pre("advmod", words.adverb("first")) if p.maybe(0.6) else replace(root)
