"""Makes a preposition of the words that say where not to go on the way: "go to the office *avoiding* the hall"."""

from typing import FrozenSet, Optional, Tuple

from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.trees.tree import ASIDE, NOUNS, DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.vocabulary import Vocabulary
from word_classes import word_class

#: What all these words become.
PREPOSITION = "avoiding"
_ARRIVING = word_class("verbs_of_arriving")
_AVOIDING = word_class("verbs_of_avoiding")
CROSSING = word_class("along_prepositions") - {"around"} | {"into", "over"}
_GOING = word_class("verbs_of_going")
_ENTERING = _GOING | _ARRIVING | {"use"}
_NOT = word_class("not")
_OF_DEEDS = frozenset(["advcl", "xcomp", "conj", "parataxis", "acl", "dep"])
_WAY = frozenset(["way", "route"])
_ALWAYS = frozenset(["all", "times"])
_NEVER = word_class("negations")
_ORDER = word_class("adverbs_of_order")
_STAYING = word_class("verbs_of_staying")
#: "Stay *out of* the hall", "keep *clear of* it".
_OUT = word_class("words_of_staying_away")
#: Of "on the way there".
_LONGEST_WAY = 4
_RELATIVE = "acl:relcl"
_WITHOUT = frozenset(["without"])


@tree_pass(
    Kind.MEANING,
    Example(
        "go|VERB|0|root to|ADP|3|case Bob|PROPN|1|obl avoiding|VERB|1|advcl|avoid|VBG halls|NOUN|4|obj",
        ("avoiding: advcl(go) VERB/avoid -> case(halls) ADP/avoiding", "halls: obj(avoiding) -> obl(go)"),
    ),
    requires=[*_OF_DEEDS, "obl", "nmod"],
    assigns=["obl", "case", "punct", ASIDE],
)
def avoided_places(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make a preposition of what says where not to go: "go to the office *and avoid the hall on the way*", "*without
    going through the hall*", "*but not through the hall*", "*but never enter the hall*", "*and stay out of the hall*".
    """
    tree = _with_way_on_top(tree)
    edit = TreeEdit(tree)
    for word in tree.words:
        found = _avoided(tree, word)
        if found is None:
            continue
        place, border = found
        verb = _going_before(tree, word)
        if verb is None:
            continue
        kept = frozenset(tree.subtree(place.index)) - _in_front(tree, place, border) - _behind(tree, place)
        top = tree.governor(word) if word.deprel == _RELATIVE else word
        for index in tree.subtree(top.index):
            if index not in kept and index != border:
                edit.rehang(index, verb.index, "punct" if tree.word(index).upos == "PUNCT" else ASIDE)
        edit.rehang(place.index, verb.index, "obl")
        edit.respell(border, PREPOSITION)
        edit.make_preposition(border, place.index)
    return edit.tree()


def _with_way_on_top(tree: DependencyTree) -> DependencyTree:
    """Let what is avoided depend on the way: "*keep out of the hall while* you go to the office"."""
    edit = TreeEdit(tree)
    for word in tree.words:
        lemma = word.lemma.lower()
        if word.head or lemma not in _AVOIDING | _STAYING:
            continue
        for way in tree.children(word.index):
            marks = [child for child in tree.children(way.index) if child.said == "while" and child.deprel == "mark"]
            is_going = way.deprel == "advcl" and way.lemma.lower() in _GOING | _ARRIVING
            if is_going and marks and (lemma in _AVOIDING or _stayed_out_of(tree, word, but=way) is not None):
                edit.rehang(way.index, 0, "root")
                edit.rehang(word.index, way.index, "advcl")
                edit.retag(way.index, "VERB", "VB")
                for child in tree.children(way.index):
                    if child in marks or child.deprel == "nsubj":
                        edit.rehang(child.index, way.index, ASIDE)
    return edit.tree()


def _avoided(tree: DependencyTree, word: Word) -> Optional[Tuple[Word, int]]:
    """Return the place that is to be avoided, and the word that becomes its preposition; None if there is none."""
    children = tree.children(word.index)
    lemma = word.lemma.lower()
    is_way = word.deprel == _RELATIVE and tree.governor(word).lemma.lower() in _WAY
    if lemma in _AVOIDING and (word.deprel in _OF_DEEDS or is_way):
        places = [child for child in children if child.deprel == "obj" and child.upos in NOUNS]
        is_plain = all(_is_beside(tree, child) for child in children if child not in places)
        return (places[0], word.index) if len(places) == 1 and is_plain else None
    if lemma in _STAYING and word.deprel in _OF_DEEDS:
        return _stayed_out_of(tree, word)
    is_denied = any(child.said in _NEVER for child in children)
    if lemma in _ENTERING and word.deprel in _OF_DEEDS and is_denied:
        places = [child for child in children if child.deprel in ("obl", "obj") and child.upos in NOUNS]
        others = [child for child in children if child not in places and child.said not in _NEVER]
        is_plain = all(child.deprel == "aux" or _is_beside(tree, child) for child in others)
        return (places[0], word.index) if len(places) == 1 and is_plain else None
    is_entering = lemma == "set" and any(child.lemma.lower() == "foot" for child in children)
    if (lemma in _GOING | _ARRIVING or is_entering) and word.deprel in _OF_DEEDS:
        is_without = any(child.deprel == "mark" and child.said in _WITHOUT for child in children)
        places = [child for child in children if child.deprel in (("obl",) if is_entering else ("obl", "obj"))]
        is_crossed = len(places) == 1 and (_crossing(tree, places[0]) or lemma in _ARRIVING or is_entering)
        return (places[0], word.index) if is_without and is_crossed else None
    if word.upos in NOUNS and word.deprel in ("conj", "obl", "nmod", "parataxis"):
        first = tree.phrase_start(word.index)
        said = [tree.word(index) for index in range(first, word.index)]
        is_denied = any(one.said in _NOT for one in said)
        border = _crossing(tree, word)
        return (word, border) if is_denied and border else None
    return None


def _stayed_out_of(tree: DependencyTree, word: Word, *, but: Optional[Word] = None) -> Optional[Tuple[Word, int]]:
    """Return the place that somebody is told to stay out of, and the verb; None for another place."""
    children = [child for child in tree.children(word.index) if but is None or child.index != but.index]
    out = [child for child in children if child.deprel in ("xcomp", "advmod") and child.said in _OUT]
    inner = [child for one in out for child in tree.children(one.index)]
    places = [child for child in [*children, *inner] if child.deprel == "obl" and child.upos in NOUNS]
    is_out = out or any(case.said in _OUT for place in places for case in tree.prepositions(place.index))
    others = [child for child in [*children, *inner] if child not in places + out]
    is_plain = all(_is_beside(tree, child) for child in others)
    return (places[0], word.index) if len(places) == 1 and is_out and is_plain else None


def _crossing(tree: DependencyTree, place: Word) -> int:
    """Return the place of "through" or another word for crossing before a noun; 0 for none."""
    cases = tree.prepositions(place.index)
    return next((case.index for case in cases if case.said in CROSSING), 0)


def _is_beside(tree: DependencyTree, child: Word) -> bool:
    """Whether a word beside a verb of avoiding adds nothing: "and", "while", "on the way", "ever", "at all times"."""
    is_relative = child.deprel == "nsubj" and child.xpos == "WDT"
    if child.deprel in ("punct", "cc", "discourse", ASIDE) or child.said in ("ever", "always") or is_relative:
        return True
    if child.deprel == "mark":
        return child.said == "while"
    words = {tree.word(index).said for index in tree.subtree(child.index)}
    is_way = child.lemma.lower() in _WAY and len(words) <= _LONGEST_WAY
    return child.deprel in ("obl", "nmod") and (is_way or words >= _ALWAYS)


def _behind(tree: DependencyTree, place: Word) -> FrozenSet[int]:
    """Return the words below a place that say when it is avoided: "the hall *on the way*"."""
    inner = [child for child in tree.children(place.index) if child.deprel == "nmod" and _is_beside(tree, child)]
    return frozenset(index for child in inner for index in tree.subtree(child.index))


def _in_front(tree: DependencyTree, place: Word, border: int) -> FrozenSet[int]:
    """Return the words below a place that stand before the border, and the border: ", but not *through* the hall"."""
    before = [index for index in tree.subtree(place.index) if index <= border]
    cases = [child.index for child in tree.prepositions(place.index)]
    return frozenset([*before, *cases])


def _comes_then(tree: DependencyTree, word: Word) -> bool:
    """Whether a word puts a phrase with a preposition behind another one: "*then* to the office"."""
    return word.said in _ORDER and bool(word.head) and bool(tree.prepositions(word.head))


def _finds_way(tree: DependencyTree, verb: Word) -> bool:
    """Whether a verb and its object mean to go somewhere: "find your way to the hall"."""
    return any(child.deprel == "obj" and child.lemma.lower() in _WAY for child in tree.children(verb.index))


def _going_before(tree: DependencyTree, word: Word) -> Optional[Word]:
    """Return the verb of going that a word is attached to, directly or behind the goal."""
    head = tree.governor(word) if word.head else None
    while head is not None and head.upos in NOUNS and head.head:
        head = tree.governor(head)
    # "Keep *visiting* the kitchen, avoiding the hall."
    verbs = [] if head is None else [head, *(child for child in tree.children(head.index) if child.deprel == "xcomp")]
    going = (verb for verb in verbs if verb.lemma.lower() in _GOING | _ARRIVING or _finds_way(tree, verb))
    found = next((verb for verb in going if verb.index != word.index), None)
    others = [] if found is None else [one for one in tree.children(found.index) if one.deprel in _OF_DEEDS]
    # "Go to the kitchen, then go to the office, and avoid the hall": on which way?
    end = word.index if found is None or found.index < word.index else len(tree.words) + 1
    is_open = any(one.lemma.lower() in _GOING | _ARRIVING and word.index != one.index < end for one in others)
    is_open = is_open or (
        found is not None and any(_comes_then(tree, one) for one in tree.words[found.index : end - 1])
    )
    return None if is_open else found
