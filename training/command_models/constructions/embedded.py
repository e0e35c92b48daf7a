"""What is embedded: assurance, embedded questions, thoughts, reminders; and who is spoken to; and false starts."""

from command_models import words
from command_models.trees import Node

from . import inflection
from .phrases import NAMES_THAT_ARE_WORDS, Phrases
from .questions import WHAT, WHO, how_much, timed, wh, which
from .registry import construction


def person_object(p: Phrases) -> Node:
    """ "me", "Anna", "the man"."""
    return words.word(p.one("me me me us him her")) if p.maybe(0.65) else p.nouns.person()


def that(p: Phrases, clause: Node, chance: float = 0.55) -> Node:
    """A clause with or without "that"."""
    return clause.pre("mark", words.word("that/SCONJ")) if p.maybe(chance) else clause


def embedded_question(p: Phrases) -> Node:
    """ "where the mug is", "what you did", "who closed the door", "how many mugs there are"."""
    draw = p.chooser.random()
    tense = p.one("past past perfect present progressive")
    if draw < 0.22:
        subject, person = p.subject(p.one("thing thing person"))
        return wh("where").post("nsubj", subject).post("cop", words.word("is" if person == "3" else "are"))
    if draw < 0.42:
        asked = WHAT if p.maybe(0.6) else which(p)
        return p.clause(p.transitive, p.subject(p.one("you I person we")), tense).pre("obj", asked)
    if draw < 0.55:
        return p.clause(p.doing, None, tense).pre("nsubj", WHO if p.maybe(0.7) else WHAT)
    if draw < 0.72:
        adverb = wh(p.one("when why how where"))
        return p.clause(p.phrase, p.subject(p.one("you I person thing")), tense).pre("advmod", adverb)
    if draw < 0.8:
        return p.predicate(p.located_at(), None).pre("nsubj", WHO if p.maybe(0.4) else WHAT)
    if draw < 0.88:
        what = how_much(p)
        be = words.word("are/VERB" if what.xpos == "NNS" else "is/VERB")
        root = be.pre("expl", words.word("there/EX")).pre("nsubj", what)
        return root.post("obl", p.located_at()) if p.maybe(0.6) else root
    if draw < 0.94:
        root = words.adjective(p.one("heavy old big tall warm cold far long hot")).pre("advmod", wh("how"))
        subject, person = p.subject("thing")
        return root.post("nsubj", subject).post("cop", words.word("is" if person == "3" else "are"))
    return p.phrase(inflection.infinitive).pre("mark", words.word("to")).pre("advmod", wh("how"))


@construction(weight=2)
def make_sure(p: Phrases) -> Node:
    """ "Make sure that you close the door." "Make sure the door is closed." """
    sure = words.adjective("sure").post("ccomp", that(p, p.event()))
    root = inflection.imperative("make").post("xcomp", sure)
    return root.pre("discourse", words.interjection("please")) if p.maybe(0.12) else root


@construction()
def make_sure_of_both(p: Phrases) -> Node:
    """ "Make sure that the door is closed and the light is off." """
    other = p.event().pre("cc", words.word(p.one("and and or")))
    sure = words.adjective("sure").post("ccomp", that(p, p.event().post("conj", other), 0.8))
    return inflection.imperative("make").post("xcomp", sure)


@construction()
def check_whether(p: Phrases) -> Node:
    """ "Check if the door is open." "Find out whether Anna is here." """
    verb = inflection.imperative(p.one("check check see find verify"))
    if verb.lemma == "find":
        verb = verb.post("compound:prt", words.particle("out"))
    if verb.lemma in ("verify", "check") and p.maybe(0.3):
        return verb.post("ccomp", that(p, p.event(), 0.9))
    return verb.post("ccomp", p.event().pre("mark", words.word(p.one("if whether"))))


@construction(weight=2)
def tell_whether(p: Phrases) -> Node:
    """ "Tell me whether you closed the door." """
    root = inflection.imperative("tell").post("iobj", person_object(p))
    if p.maybe(0.2):
        root = inflection.infinitive("tell").post("iobj", person_object(p))
        root = root.pre("nsubj", words.word("you")).pre("aux", words.modal(p.one("can could")))
    return root.post("ccomp", p.event().pre("mark", words.word(p.one("if whether whether"))))


@construction(weight=2)
def tell_what(p: Phrases) -> Node:
    """ "Tell me where the mug is." "Show Anna what you did." """
    root = inflection.imperative(p.one("tell tell tell show explain")).post("iobj", person_object(p))
    if root.lemma == "explain":
        root = inflection.imperative("explain")
    return root.post("ccomp", embedded_question(p))


@construction()
def tell_when(p: Phrases) -> Node:
    """ "Tell me when the door opens." "Warn Anna if it rains." """
    root = inflection.imperative(p.one("tell warn call inform alert remind"))
    whom = person_object(p)
    root = root.post("iobj" if root.lemma == "tell" else "obj", whom)
    marker = p.one("when if") if root.lemma == "tell" else p.one("when if once")
    clause = p.event()
    clause = (
        clause.pre("advmod", wh("when"))
        if marker == "when"
        else clause.pre("mark", Node(marker, marker, "SCONJ", "IN"))
    )
    if root.lemma == "tell":
        return root.post("ccomp", clause)
    return root.post("advcl", clause)


@construction()
def thought(p: Phrases) -> Node:
    """ "I think that the door is open." "I hope you closed it." """
    verb = p.one("think think believe know hope guess see")
    subject = (words.word("I"), "I") if p.maybe(0.8) else p.subject("person")
    return p.clause(lambda form: form(verb).post("ccomp", that(p, p.event(), 0.4)), subject, "present")


@construction()
def remember_that(p: Phrases) -> Node:
    """ "Remember that the keys are on the table." "Note that Anna is my sister." """
    verb = inflection.imperative(p.one("remember remember note know assume imagine"))
    return verb.post("ccomp", that(p, p.event(), 0.75))


@construction()
def remind_to(p: Phrases) -> Node:
    """ "Remind me to close the door at eight." "Tell Anna to come here." "Ask the man to wait." """
    verb = inflection.imperative(p.one("remind remind ask tell help allow"))
    inner = p.phrase(inflection.infinitive).pre("mark", words.word("to"))
    if p.maybe(0.25):
        inner = inner.post(*p.when())
    relation = "iobj" if verb.lemma in ("tell", "ask") else "obj"
    return verb.post(relation, person_object(p)).post("xcomp", inner)


@construction()
def say_that(p: Phrases) -> Node:
    """ "Tell Anna that dinner is ready." "Say that you are tired." """
    clause = that(p, p.event(), 0.85)
    if p.maybe(0.6):
        return inflection.imperative("tell").post("iobj", person_object(p)).post("ccomp", clause)
    verb = inflection.imperative(p.one("say say announce report confirm"))
    if p.maybe(0.25):
        verb = verb.post("obl", p.nouns.marked("to", p.nouns.person()))
    return verb.post("ccomp", clause)


@construction()
def said_that(p: Phrases) -> Node:
    """ "Anna said that the door is open." "You told me you had closed it." """
    clause = that(p, p.event(), 0.6)
    if p.maybe(0.4):
        whom = words.word(p.one("me us him her"))
        return p.clause(lambda form: form("tell").post("iobj", whom).post("ccomp", clause), p.subject("you"), "past")
    return p.clause(lambda form: form(p.one("say say think know")).post("ccomp", clause), p.subject("person"), "past")


@construction()
def try_to(p: Phrases) -> Node:
    """ "Try to open the door." "Stop cleaning." "Start moving." "You don't need to wait." "Don't forget to dock." """
    draw = p.chooser.random()
    if draw < 0.35:
        inner = p.phrase(inflection.infinitive).pre("mark", words.word("to"))
        return inflection.imperative(p.one("try try start begin continue learn")).post("xcomp", inner)
    if draw < 0.7:
        verb = p.one("stop start keep continue begin finish avoid")
        return inflection.imperative(verb).post("xcomp", p.phrase(inflection.gerund))
    inner = p.phrase(inflection.infinitive).pre("mark", words.word("to"))
    if draw < 0.85:
        root = inflection.imperative("forget").post("xcomp", inner)
        root = root.pre("advmod", Node("n't", "not", "PART", "RB", "Polarity=Neg", glued=True))
        return root.pre("aux", words.word("do"))
    return p.clause(
        lambda form: form(p.one("need have want")).post("xcomp", inner),
        p.subject(p.one("you you I")),
        "present",
        negative=p.maybe(0.5),
    )


@construction()
def lets(p: Phrases) -> Node:
    """ "Let's go to the kitchen." "Let me see the mug." """
    us = Node("'s", "we", "PRON", "PRP", glued=True) if p.maybe(0.6) else words.word(p.one("us me him"))
    return inflection.imperative("let").post("obj", us).post("xcomp", p.phrase(inflection.infinitive))


def addressee(p: Phrases) -> Node:
    """A name, also one that is a verb: "Max", "Mark", "robot"."""
    draw = p.chooser.random()
    if draw < 0.3:
        return words.noun("robot")
    if draw < 0.55:
        return words.name(p.any(NAMES_THAT_ARE_WORDS))
    called = p.any(p.lexicon.robots)
    return words.name(called) if called[0].isupper() else words.noun(called)


@construction(weight=2)
def called_in_front(p: Phrases) -> Node:
    """ "Mark, close the door." "Robot, did you close the door?" """
    root = p.phrase(inflection.imperative)
    who = addressee(p)
    if p.maybe(0.6):
        who = who.post("punct", words.comma())
    root = root.pre("vocative", who)
    return root.pre("discourse", words.interjection(p.one("hey ok hello hi"))) if p.maybe(0.2) else root


@construction(weight=1.5)
def called_at_the_end(p: Phrases) -> Node:
    """ "Close the door, Mark." """
    who = addressee(p)
    if p.maybe(0.7):
        who = who.pre("punct", words.comma())
    root = p.phrase(inflection.imperative)
    if p.maybe(0.2):
        root = root.post("discourse", words.interjection("please"))
    return root.post("vocative", who)


@construction("?")
def called_question(p: Phrases) -> Node:
    """ "Max, where is the mug?" "Robot, are you cleaning?" """
    who = addressee(p)
    if p.maybe(0.6):
        who = who.post("punct", words.comma())
    if p.maybe(0.5):
        subject, person = p.subject("thing")
        root = wh("where").post("cop", words.word("is" if person == "3" else "are")).post("nsubj", subject)
    else:
        root = p.clause(p.phrase, p.subject("you"), p.one("past progressive perfect can"), asked=True)
    return root.pre("vocative", who)


@construction()
def names_as_objects(p: Phrases) -> Node:
    """ "Follow Mark." "Give Rose the mug." "Ask Will about Grace." """
    name = words.name(p.any(NAMES_THAT_ARE_WORDS))
    draw = p.chooser.random()
    if draw < 0.35:
        return inflection.imperative(p.one("follow find greet meet call guide help see")).post("obj", name)
    if draw < 0.65:
        return inflection.imperative(p.one("give bring show hand")).post("iobj", name).post("obj", p.thing())
    if draw < 0.85:
        return inflection.imperative(p.one("go talk wave speak")).post("obl", p.nouns.marked("to", name))
    root = inflection.imperative(p.one("take bring carry give")).post("obj", p.thing())
    return root.post("obl", p.nouns.marked("to", name))


@construction(weight=2.5)
def repeated_word(p: Phrases) -> Node:
    """ "Bring bring me the mug." "Go to the to the kitchen." "The uh the mug" """
    root = p.phrase(inflection.imperative)
    if p.maybe(0.4) and not root.left:
        return root.near("reparandum", Node(root.form, root.lemma, root.upos, root.xpos))
    head = p.kind().pre("det", words.word("the"))
    preposition = p.one("to to on in near")
    broken = words.word("the").pre("case", words.adposition(preposition))
    if p.maybe(0.5):
        broken = broken.post("discourse", words.interjection(p.one("uh um er")))
    goal = head.pre("case", words.adposition(preposition)).pre("reparandum", broken)
    if preposition == "to":
        return inflection.imperative(p.one("go drive walk come move")).post("obl", goal)
    return inflection.imperative(p.one("put place leave drop")).post("obj", p.thing()).post("obl", goal)


@construction()
def hesitating(p: Phrases) -> Node:
    """ "Uh bring me the um red mug." """
    head = p.kind().pre("discourse", words.interjection(p.one("uh um er hmm"))).pre("det", words.word("the"))
    root = p.transitive(inflection.imperative, head, (0, 0, 1))
    return root.pre("discourse", words.interjection(p.one("uh um well ok er"))) if p.maybe(0.5) else root


@construction(weight=3)
def corrected(p: Phrases) -> Node:
    """ "Bring the mug, no, the plate." "Go to the kitchen, I mean the hall." """
    wrong, right = p.thing(), p.thing()
    if p.maybe(0.35):
        comment = words.present("mean").pre("nsubj", words.word("I"))
        relation = "parataxis"
    else:
        comment = words.interjection(p.one("no no sorry oops"))
        relation = "discourse"
    if p.maybe(0.5):
        comment = comment.post("punct", words.comma())
    right = right.pre(relation, comment)
    if p.maybe(0.5):
        wrong = wrong.post("punct", words.comma())
    right = right.pre("reparandum", wrong)
    return inflection.imperative(p.one("bring take get find open clean give fetch")).post("obj", right)


@construction()
def thanks(p: Phrases) -> Node:
    """ "Close the door, thank you." "Please wait here, thanks." """
    root = p.phrase(inflection.imperative)
    if p.maybe(0.5):
        thank = words.word("thanks")
        return root.post("discourse", thank.pre("punct", words.comma()) if p.maybe(0.6) else thank)
    thank = words.present("thank").post("obj", words.word("you/ACC"))
    return root.post("parataxis", thank.pre("punct", words.comma()) if p.maybe(0.6) else thank)


@construction("?")
def did_you_know(p: Phrases) -> Node:
    """ "Do you know where the mug is?" "Do you remember what you did yesterday?" """
    verb = p.one("know know remember see understand")
    return timed(
        p,
        p.clause(
            lambda form: form(verb).post("ccomp", embedded_question(p)),
            p.subject("you"),
            p.one("present present past"),
            asked=True,
        ),
        0.05,
    )
