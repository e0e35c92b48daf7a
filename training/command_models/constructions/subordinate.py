"""Subordinate clauses, gerunds, passives, relative clauses, and what is said of somebody else."""

from typing import Tuple

from command_models import words
from command_models.trees import Node

from . import inflection
from .phrases import Phrases, before_all
from .questions import timed, wh
from .registry import construction


def marked(clause: Node, marker: str) -> Node:
    """A clause behind the word that makes it subordinate."""
    if marker in ("when", "whenever", "where", "wherever"):
        return clause.pre("advmod", wh(marker))
    if marker == "as_soon_as":
        raise ValueError("its adverb governs the clause: see scored_only")
    return clause.pre("mark", Node(marker, marker, "SCONJ", "IN"))


def main(p: Phrases) -> Node:
    """The main clause: mostly a command."""
    draw = p.chooser.random()
    if draw < 0.8:
        root = p.phrase(inflection.imperative)
        if p.maybe(0.12):
            root = root.pre("discourse", words.interjection("please"))
        return root
    if draw < 0.9:
        return p.clause(p.phrase, p.subject("you"), p.one("should must can could will"))
    return p.clause(p.phrase, p.subject("you"), p.one("can could will would"), asked=True)


def joined(p: Phrases, root: Node, clause: Node, front: float = 0.5) -> Node:
    """A main clause with a clause before or behind it."""
    if p.maybe(front):
        return before_all(root, "advcl", clause, p.maybe(0.6))
    if p.maybe(0.12):
        clause = clause.pre("punct", words.comma())
    return root.post("advcl", clause)


@construction(weight=2)
def when_clause(p: Phrases) -> Node:
    """ "When Anna closes the door, say hello." """
    return joined(p, main(p), marked(p.event(), "when"))


@construction(weight=2)
def if_clause(p: Phrases) -> Node:
    """ "If the mug is not on the table, bring the plate." """
    root = main(p)
    if p.maybe(0.15):
        root = root.pre("advmod", words.word("then"))
    return joined(p, root, marked(p.event(), "if"), 0.65)


@construction(weight=1.5)
def until_clause(p: Phrases) -> Node:
    """ "Wait until the door is closed." """
    if p.maybe(0.5):
        root = inflection.imperative(p.one("wait wait wait stay stop stand sleep continue"))
        if p.maybe(0.3):
            root = root.post("advmod", words.adverb(p.one("here there outside")))
    else:
        root = main(p)
    return joined(p, root, marked(p.event(), p.one("until until till")), 0.08)


@construction()
def unless_clause(p: Phrases) -> Node:
    """ "Unless the door is closed, go to the kitchen." """
    return joined(p, main(p), marked(p.event(), "unless"), 0.35)


@construction()
def before_clause(p: Phrases) -> Node:
    """ "Before you leave, close the door." """
    return joined(p, main(p), marked(p.event(), "before"))


@construction()
def once_clause(p: Phrases) -> Node:
    """ "Once you have been to the kitchen, say hello." """
    return joined(p, main(p), marked(p.event(), "once"))


@construction()
def while_clause(p: Phrases) -> Node:
    """ "Wait here while I clean the table." """
    return joined(p, main(p), marked(p.event(), p.one("while while because although since")), 0.35)


@construction(weight=1.5)
def after_gerund(p: Phrases) -> Node:
    """ "After closing the door, say hello." """
    marker = p.one("after after while by")
    return joined(p, main(p), marked(p.phrase(inflection.gerund), marker), 0.6)


@construction()
def without_gerund(p: Phrases) -> Node:
    """ "Go to the hall without entering the kitchen." """
    return joined(p, main(p), marked(p.phrase(inflection.gerund), "without"), 0.12)


@construction()
def purpose(p: Phrases) -> Node:
    """ "Use the sponge to clean the table." """
    inner = p.phrase(inflection.infinitive).pre("mark", words.word("to"))
    if p.maybe(0.5):
        root = inflection.imperative(p.one("use use take go come get bring")).post("obj", p.thing())
        if root.lemma in ("go", "come"):
            root = p.verbs.going(inflection.imperative)
        return root.post("advcl", inner)
    return main(p).post("advcl", inner)


@construction(weight=1.5)
def passive_told(p: Phrases) -> Node:
    """ "The door was closed by Anna." """
    tense = p.one("present past past progressive")
    root = p.predicate(p.passive(agent=0.35), p.subject("thing"), tense, passive=True, negative=p.maybe(0.12))
    return timed(p, root, 0.2)


@construction()
def passive_modal(p: Phrases) -> Node:
    """ "The door should be closed." """
    tense = p.one("should must can will may")
    return p.predicate(p.passive(agent=0.12), p.subject("thing"), tense, passive=True, negative=p.maybe(0.15))


def _gap(p: Phrases) -> Tuple[Node, Node]:
    """A noun and a clause in which it is the object: "the door", "you closed"."""
    head = p.kind(p.maybe(0.2)).pre("det", words.word("the"))
    clause = p.clause(
        lambda form: p.transitive(form, None),
        p.subject(p.one("you you I person we he")),
        p.one("past past past perfect present progressive"),
    )
    return head, timed(p, clause, 0.12)


def with_phrase(p: Phrases, head: Node) -> Node:
    """A command about a noun phrase: its object, its goal or its place."""
    draw = p.chooser.random()
    if draw < 0.5:
        return p.transitive(inflection.imperative, head, (0, 0, 0, 1))
    if draw < 0.75:
        verb = inflection.imperative(p.one("go go drive walk come return move run"))
        return verb.post("obl", p.nouns.marked(p.one("to to to into near behind next_to"), head))
    verb = inflection.imperative(p.one("put place leave bring take drop carry"))
    what = p.nouns.pronoun() if p.maybe(0.4) else p.thing()
    return verb.post("obj", what).post("obl", p.nouns.marked(p.one("on in near to next_to under"), head))


@construction(weight=2)
def relative_object(p: Phrases) -> Node:
    """ "Go to the door that you closed." """
    head, clause = _gap(p)
    pronoun = words.word(p.one("that/REL that/REL which"))
    return with_phrase(p, head.post("acl:relcl", clause.pre("obj", pronoun)))


@construction(weight=1.5)
def relative_bare(p: Phrases) -> Node:
    """ "Bring the mug you found." """
    head, clause = _gap(p)
    return with_phrase(p, head.post("acl:relcl", clause))


@construction(weight=1.5)
def relative_subject(p: Phrases) -> Node:
    """ "Bring the mug that is on the table." "Follow the man who came in." """
    if p.maybe(0.5):
        head = p.kind(p.maybe(0.2)).pre("det", words.word("the"))
        state = p.predicate(p.state(), None, p.one("present present past"))
        if head.xpos == "NNS":
            state = p.predicate(p.state(), (head, "p"), "present")
            state = _without_subject(state)
        return with_phrase(p, head.post("acl:relcl", state.pre("nsubj", words.word(p.one("that/REL that/REL which")))))
    head = words.noun(p.any(p.lexicon.people)).pre("det", words.word("the"))
    who = Node("who", "who", "PRON", "WP", "PronType=Rel")
    clause = p.clause(p.doing, None, p.one("past present progressive perfect")).pre("nsubj", who)
    verb = inflection.imperative(p.one("follow find greet guide help meet call"))
    return verb.post("obj", head.post("acl:relcl", clause))


def _without_subject(root: Node) -> Node:
    from dataclasses import replace

    return replace(root, left=tuple(node for node in root.left if not node.rel.startswith("nsubj")))


@construction()
def participle_phrase(p: Phrases) -> Node:
    """ "Take the mug placed on the table." "Greet the man standing next to the door." """
    if p.maybe(0.5):
        head = p.kind().pre("det", words.word("the"))
        return with_phrase(p, head.post("acl", p.passive(agent=0.3)))
    head = words.noun(p.any(p.lexicon.people)).pre("det", words.word("the"))
    verb = inflection.progressive(p.one("sit stand wait lie read sleep work sing talk"))
    if p.maybe(0.7):
        verb = verb.post("obl", p.located_at())
    return inflection.imperative(p.one("follow find greet guide help meet call")).post("obj", head.post("acl", verb))


@construction(weight=2)
def told_deed(p: Phrases) -> Node:
    """ "Anna has closed the door." "You docked at the wrong charger." """
    tense = p.one("past past perfect perfect present progressive will was_progressive")
    return timed(p, p.clause(p.doing, p.subject(), tense), 0.15)


@construction(weight=1.5)
def told_state(p: Phrases) -> Node:
    """ "The mug is on the table." "The door was not locked." "There are two plates in the sink." """
    draw = p.chooser.random()
    if draw < 0.25:
        return p.existing(p.maybe(0.2))
    if draw < 0.35:
        return p.below()
    return p.stated(tense=p.one("present present past"), negative=p.maybe(0.2))


@construction()
def having(p: Phrases) -> Node:
    """ "I have a dog." "The table has four legs." "Anna doesn't need the box." """
    return p.clause(
        lambda form: form(p.one("have have need like own want")).post("obj", p.thing(p.maybe(0.3))),
        p.subject(),
        p.one("present present past"),
        negative=p.maybe(0.2),
    )


@construction()
def naming(p: Phrases) -> Node:
    """ "This is Anna." "My name is Anna." "This is the kitchen." "Your task is to clean." """
    draw = p.chooser.random()
    if draw < 0.4:
        what = p.person_name() if p.maybe(0.5) else p.nouns.place()
        return p.predicate(what, (words.word(p.one("this/PRON that/PRON")), "3"))
    owner = words.word(p.one("my your his our"))
    if draw < 0.75:
        subject = words.noun(p.one("name sister friend owner colleague boss")).pre("nmod:poss", owner)
        return p.predicate(p.person_name(), (subject, "3"))
    subject = words.noun(p.one("task job goal plan")).pre("nmod:poss", owner)
    return p.predicate(p.phrase(inflection.infinitive).pre("mark", words.word("to")), (subject, "3"))


@construction()
def modal_told(p: Phrases) -> Node:
    """ "You must not close the door." "You should wait." "Nobody may enter the kitchen." """
    return p.clause(
        p.phrase, p.subject(p.one("you you person")), p.one("must should may can will"), negative=p.maybe(0.4)
    )
