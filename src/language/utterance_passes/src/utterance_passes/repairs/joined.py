"""Corrects how a parser joins verbs and phrases that stand side by side: conditions, words to be said, lists."""

from typing import Optional

from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.phrases.clauses import verb_above
from utterance_passes.trees.tree import ASIDE, QUOTED, DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.vocabulary import Speech, Verbs, Vocabulary
from word_classes import word_class

_CONDITIONS = word_class("conditions")
_MANNERS = word_class("manner_adverbs")
_ONES = word_class("noun_standins")
_OWNED = word_class("pronouns_of_owned_things")
_PLACE_PREPOSITIONS = word_class("place_prepositions")
_SIDES = word_class("opposite_sides")
_UNTIL = frozenset(["until", "till"])


@tree_pass(
    Kind.MEANING,
    Example(
        "bring|VERB|0|root cups|NOUN|1|obj but|CCONJ|6|cc if|SCONJ|6|mark it|PRON|6|nsubj rains|VERB|1|conj",
        ("rains: conj(bring) -> advcl(bring)",),
    ),
    requires=["conj", "parataxis"],
    assigns=["advcl"],
)
def conditions_joined(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make a condition of a clause that is joined to the command: "bring me the cup, *but only if it is clean*"."""
    edit = TreeEdit(tree)
    for clause in tree.words:
        governor = tree.word(clause.head) if clause.head else clause
        # "If it is clean and if it is empty" are two conditions.
        if clause.deprel in ("conj", "parataxis") and _mark(tree, clause) and not _mark(tree, governor):
            is_command = governor.upos == "VERB" and governor.index < clause.index
            if is_command and any(child.deprel.startswith("nsubj") for child in tree.children(clause.index)):
                edit.relabel(clause.index, "advcl")
    return edit.tree()


@tree_pass(
    Kind.MEANING,
    Example(
        "go|VERB|0|root by|ADP|4|case the|DET|4|det time|NOUN|1|obl Bob|PROPN|6|nsubj comes|VERB|4|acl:relcl",
        ("by: case(time) -> fixed(time)", "time: obl(go) -> mark(comes)", "comes: acl:relcl(time) -> advcl(go)"),
    ),
    requires=["acl:relcl"],
    assigns=["advcl", "mark", "fixed"],
)
def deadlines_joined(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make a clause of the command of what describes "the time": "be there *by the time Bob comes*" names no place."""
    edit = TreeEdit(tree)
    for time in tree.words:
        clauses = [child for child in tree.children(time.index) if child.deprel == "acl:relcl"]
        cases = [child for child in tree.children(time.index) if child.deprel == "case"]
        is_deadline = time.form.lower() == "time" and [case.form.lower() for case in cases] == ["by"]
        if is_deadline and len(clauses) == 1 and time.deprel in ("obl", "nmod"):
            verb = verb_above(tree, tree.word(time.head))
            edit.rehang(clauses[0].index, verb.index, "advcl")
            edit.rehang(time.index, clauses[0].index, "mark")
            edit.rehang(cases[0].index, time.index, "fixed")
    return edit.tree()


def _mark(tree: DependencyTree, clause: Word) -> Optional[Word]:
    marks = [child for child in tree.children(clause.index) if child.deprel in ("mark", "advmod")]
    return next((mark for mark in marks if mark.form.lower() in _CONDITIONS and mark.index < clause.index), None)


@tree_pass(
    Kind.MEANING,
    Example(
        "follow|VERB|0|root me|PRON|1|obj ,|PUNCT|5|punct but|CCONJ|5|cc slowly|ADV|1|conj",
        ("but: cc(slowly) -> discourse:aside(follow)", "slowly: conj(follow) -> advmod(follow)"),
    ),
    requires=["cc"],
    assigns=[ASIDE, "conj", "advmod"],
)
def manners_joined(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a manner that is joined like a deed: "follow me, *but slowly*", "go to the door and *slowly* open it"."""
    edit = TreeEdit(tree)
    for manner in tree.words:
        verb = tree.word(manner.head) if manner.head else manner
        if (
            manner.deprel not in ("conj", "advmod")
            or manner.upos != "ADV"
            or verb.upos != "VERB"
            or not _is_manner(manner)
        ):
            continue
        children = tree.children(manner.index)
        joining = [child for child in children if child.deprel == "cc"]
        if not joining or any(child.deprel not in ("cc", "punct") for child in children):
            continue
        behind = tree.word(manner.index + 1) if manner.index < len(tree.words) else manner
        if behind.upos == "VERB" and behind.head == verb.index and behind.deprel in ("parataxis", "conj"):
            edit.relabel(behind.index, "conj")
            edit.rehang(manner.index, behind.index, "advmod")
            for child in children:
                edit.rehang(child.index, behind.index)
        else:
            edit.relabel(manner.index, "advmod")
            for child in joining:
                edit.rehang(child.index, verb.index, ASIDE)
    return edit.tree()


def _is_manner(word: Word) -> bool:
    form = word.form.lower()
    return form in _MANNERS or form.endswith("ly")


def _preposition(tree: DependencyTree, word: Word) -> str:
    return " ".join(child.form.lower() for child in tree.children(word.index) if child.deprel == "case")


@tree_pass(
    Kind.POLICY,
    Example(
        "give|VERB|0|root Bob|PROPN|1|iobj cups|NOUN|1|obj|cup and|CCONJ|6|cc Anna|PROPN|6|compound hers|NOUN|3|conj",
        ("hers: conj(cups) -> dep(give)",),
    ),
    requires=["compound"],
    assigns=["dep"],
)
def owned_things_apart(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Part what somebody owns from who gets it: "give Bob his cup and *Anna hers*" gives Bob no second thing. No unit
    knows the relation ``dep``."""
    edit = TreeEdit(tree)
    for owned in tree.words:
        names = [child for child in tree.children(owned.index) if child.deprel == "compound"]
        if owned.form.lower() in _OWNED and owned.deprel == "conj" and names:
            edit.rehang(owned.index, verb_above(tree, owned).index, "dep")
    return edit.tree()


@tree_pass(
    Kind.MEANING,
    Example(
        "there|PRON|2|expl is|VERB|0|root|be tea|NOUN|2|nsubj on|ADP|5|case tables|NOUN|3|nmod",
        ("tables: nmod(tea) -> obl(is)",),
    ),
    requires=["expl"],
    assigns=["obl"],
)
def places_of_what_there_is(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a place behind what there is to the verb: "there is a radio *next to the bed*" says where it is."""
    edit = TreeEdit(tree)
    for verb in tree.words:
        children = tree.children(verb.index)
        things = [child for child in children if child.deprel == "nsubj" and child.index > verb.index]
        is_existence = verb.lemma == "be" and any(child.deprel == "expl" for child in children)
        for place in tree.children(things[0].index) if is_existence and len(things) == 1 else ():
            first = _preposition(tree, place).split(" ")[0]
            is_last = max(tree.subtree(place.index)) == max(tree.subtree(things[0].index))
            if place.deprel == "nmod" and is_last and first in _PLACE_PREPOSITIONS and first != "of":
                edit.rehang(place.index, verb.index, "obl")
    return edit.tree()


@tree_pass(
    Kind.MEANING,
    Example(
        "take|VERB|0|root the|DET|3|det red|ADJ|1|obj|red|JJ and|CCONJ|7|cc the|DET|7|det blue|ADJ|7|amod "
        "cup|NOUN|3|conj",
        ("red: obj(take) -> conj(cup)", "and: cc(cup) -> cc(red)", "cup: conj(red) -> obj(take)"),
    ),
    requires=["conj"],
    assigns=["conj"],
)
def shared_nouns(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make the noun of two described things the head of both: "bring me the red and the blue *cup*"."""
    edit = TreeEdit(tree)
    for described in tree.words:
        joined = [child for child in tree.children(described.index) if child.deprel == "conj"]
        is_side = described.form.lower() in _SIDES
        if (described.upos != "ADJ" and not is_side) or len(joined) != 1 or not _is_described(tree, joined[0]):
            continue
        before = [child for child in tree.children(described.index) if child.index < described.index]
        if not any(child.deprel == "det" for child in before):
            continue
        noun = joined[0]
        edit.rehang(noun.index, described.head, described.deprel)
        edit.rehang(described.index, noun.index, "conj")
        edit.retag(described.index, "ADJ", "JJ")
        for child in before:
            if child.deprel == "case":
                edit.rehang(child.index, noun.index)
        for child in tree.children(noun.index):
            if child.deprel == "cc":
                edit.rehang(child.index, described.index)
    return edit.tree()


def _is_described(tree: DependencyTree, noun: Word) -> bool:
    relations = {child.deprel for child in tree.children(noun.index) if child.index < noun.index}
    return noun.upos == "NOUN" and {"cc", "det", "amod"} <= relations and noun.form.lower() not in _ONES


@tree_pass(
    Kind.MEANING,
    Example(
        "tell|VERB|0|root Bob|PROPN|1|iobj to|PART|4|mark wait|VERB|1|xcomp until|SCONJ|6|mark noon|NOUN|4|advcl",
        ("until: mark(noon) -> flat:quoted(wait)", "noon: advcl(wait) -> flat:quoted(wait)"),
        Verbs(frozenset(["tell"]), speech={"tell": Speech.TOLD}),
    ),
    requires=["xcomp"],
    assigns=[QUOTED],
)
def bounds_of_messages(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Leave how long somebody else is to do something in what that person is told: "tell Bob to wait *until I come
    back*". To tell him takes no time."""
    edit = TreeEdit(tree)
    for clause in tree.words:
        inner = tree.word(clause.head) if clause.head and clause.deprel == "advcl" else clause
        mark = _mark(tree, clause)
        is_bound = mark is not None and mark.form.lower() in _UNTIL and inner.deprel == "xcomp"
        if is_bound and vocabulary.speech_of(tree.word(inner.head).lemma.lower()) is not None:
            for index in tree.subtree(clause.index):
                edit.rehang(index, inner.index, QUOTED)
    return edit.tree()
