"""Corrects how a parser joins verbs and phrases that stand side by side: conditions, words to be said, lists."""

from dataclasses import replace
from typing import Optional

from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.trees.tree import ASIDE, QUOTED, DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.tree_patterns import Rehang, Sought, TreePattern, rehung
from utterance_passes.trees.vocabulary import Speech, Verbs, Vocabulary
from word_classes import word_class

_CONDITIONS = word_class("conditions")
_MANNERS = word_class("manner_adverbs")
_ONES = word_class("noun_standins")
_PLACE_PREPOSITIONS = word_class("place_prepositions")
_SIDES = word_class("opposite_sides")
_UNTIL = frozenset(["until", "till"])


_MARK = Sought("mark", "clause", ">--", deprel={"mark", "advmod"}, said=_CONDITIONS)
_JOINED_CONDITION = TreePattern(
    Sought("clause", deprel={"conj", "parataxis"}),
    _MARK,
    Sought("command", "clause", "<--", upos={"VERB"}),
    # "If it is clean and if it is empty" are two conditions.
    replace(_MARK, name="other mark", beside="command", is_absent=True),
    Sought("subject", "clause", ">", deprel={"nsubj:*"}),
)


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
    return rehung(tree, _JOINED_CONDITION, Rehang("clause", "advcl"))


_DEADLINE = TreePattern(
    Sought("time", deprel={"obl", "nmod"}, said={"time"}),
    Sought("by", "time", ">", deprel={"case"}, said={"by"}, is_only=True),
    Sought("clause", "time", ">", deprel={"acl:relcl"}, is_only=True),
    Sought("verb", "time", "<<v"),
)


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
    return rehung(
        tree,
        _DEADLINE,
        Rehang("clause", "advcl", "verb"),
        Rehang("time", "mark", "clause"),
        Rehang("by", "fixed", "time"),
    )


def _mark(tree: DependencyTree, clause: Word) -> Optional[Word]:
    marks = [child for child in tree.children(clause.index) if child.deprel in ("mark", "advmod")]
    return next((mark for mark in marks if mark.said in _CONDITIONS and mark.index < clause.index), None)


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
        verb = tree.governor(manner)
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
    form = word.said
    return form in _MANNERS or form.endswith("ly")


#: "Hers", "theirs".
_OWNED = frozenset(f"{word}s" for word in word_class("determiners_and_possessives"))
_OWNED_BY_ANOTHER = TreePattern(
    Sought("owned", deprel={"conj"}, said=_OWNED),
    Sought("owner", "owned", ">", deprel={"compound"}),
    Sought("verb", "owned", "<<v"),
)


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
    return rehung(tree, _OWNED_BY_ANOTHER, Rehang("owned", "dep", "verb"))


_PLACE_OF_WHAT_THERE_IS = TreePattern(
    Sought("verb", lemma={"be"}),
    Sought("there", "verb", ">", deprel={"expl"}),
    Sought("thing", "verb", ">++", deprel={"nsubj"}, is_only=True),
    Sought("place", "thing", ">|", deprel={"nmod"}, preposition=_PLACE_PREPOSITIONS - {"of"}),
)


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
    return rehung(tree, _PLACE_OF_WHAT_THERE_IS, Rehang("place", "obl", "verb"))


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
        is_side = described.said in _SIDES
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
    return noun.upos == "NOUN" and {"cc", "det", "amod"} <= relations and noun.said not in _ONES


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
        inner = tree.governor(clause) if clause.head and clause.deprel == "advcl" else clause
        mark = _mark(tree, clause)
        is_bound = mark is not None and mark.said in _UNTIL and inner.deprel == "xcomp"
        if is_bound and vocabulary.speech_of(tree.governor(inner).lemma.lower()) is not None:
            for index in tree.subtree(clause.index):
                edit.rehang(index, inner.index, QUOTED)
    return edit.tree()
