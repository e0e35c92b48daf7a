"""Makes one count of a bound and the number behind it: "at most three apples"."""

from typing import Optional, Sequence

from spoken_quantities import find_unit
from utterance_passes.pass_needs import only_with
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

_ARTICLES = word_class("indefinite_articles")
_BOUNDS = word_class("bounds_of_counts")
_ROUGHLY = word_class("hedges_of_times")
_GOING = word_class("verbs_of_going")
_LONGEST = max(len(bound.split()) for bound in _BOUNDS)
_OBJECTS = frozenset(["obj", "iobj"])
_PRONOUNS = frozenset(["PRON", "PROPN"])


@only_with("nummod", "iobj")
def with_bounded_counts(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Attach a bound to its number: in "bring me *up to* three apples", "to" is no preposition of the apples.

    What can be measured has no count, and whoever goes "up to two people" goes to them. In "bring me *about* a litre of
    milk", "about" is no preposition either.
    """
    tree = _with_rough_amounts(tree, vocabulary)
    for noun in tree.words:
        numerals = [child for child in tree.children(noun.index) if child.deprel == "nummod"]
        first = numerals[0].index if numerals else 0
        bound = _bound_before(tree, first)
        if 0 < first < noun.index and bound and find_unit(noun.form) is None:
            tree = _attached(tree, bound, tree.word(first), noun) or tree
    return tree


def _with_rough_amounts(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    edit = TreeEdit(tree)
    for rough in tree.words[:-1]:
        if rough.form.lower() not in _ROUGHLY or not rough.head:
            continue
        noun = tree.word(rough.head)
        if rough.deprel == "advmod" and tree.word(rough.index + 1).deprel == "nummod":
            noun = tree.word(tree.word(rough.index + 1).head)
        verb = tree.word(noun.head) if noun.head else noun
        relations = [child.deprel for child in tree.children(verb.index) if child.index != noun.index]
        # "Tell me about three dogs" is about them.
        is_given = "iobj" in relations and "obj" not in relations and not vocabulary.speech_of(verb.lemma.lower())
        if is_given and noun.deprel in ("obl", "obj") and _is_amount(tree, noun):
            edit.relabel(noun.index, "obj")
            edit.rehang(rough.index, noun.index, "advmod")
            edit.retag(rough.index, "ADV")
    return edit.tree()


def _is_amount(tree: DependencyTree, noun: Word) -> bool:
    """Whether a noun is counted, or measures what is behind it: "three apples", "a litre of milk"."""
    inside = tree.children(noun.index)
    behind = [child for child in inside if child.deprel == "nmod"]
    is_of = any(case.form.lower() == "of" for child in behind for case in tree.children(child.index))
    is_indefinite = any(child.form.lower() in _ARTICLES for child in inside)
    return any(child.deprel == "nummod" for child in inside) or (is_of and is_indefinite)


def _bound_before(tree: DependencyTree, numeral: int) -> Sequence[Word]:
    """Return the words of the bound before a number; none if there is no bound."""
    for length in range(min(_LONGEST, numeral - 1), 0, -1):
        words = tree.words[numeral - 1 - length : numeral - 1]
        if " ".join(word.form.lower() for word in words) in _BOUNDS:
            return words
    return ()


def _attached(tree: DependencyTree, bound: Sequence[Word], numeral: Word, noun: Word) -> Optional[DependencyTree]:
    inside = {word.index for word in (*bound, noun)}
    top = noun
    while top.head in inside:
        top = tree.word(top.head)
    verb = tree.word(top.head) if top.head else top
    if verb is top or verb.lemma.lower() in _GOING:
        return None
    edit = TreeEdit(tree)
    objects = [child for child in tree.children(verb.index) if child.deprel in _OBJECTS and child.index not in inside]
    is_of_verb = verb.upos == "VERB" and top.deprel.split(":")[0] in ("obl", "obj", "advmod", "compound")
    edit.rehang(noun.index, verb.index, "obj" if is_of_verb else top.deprel)
    if is_of_verb and len(objects) == 1 and objects[0].deprel == "obj" and objects[0].upos in _PRONOUNS:
        edit.relabel(objects[0].index, "iobj")
    for word in bound:
        for child in tree.children(word.index):
            if child.index not in inside and child.index != numeral.index:
                edit.rehang(child.index, noun.index)
    edit.rehang(numeral.index, noun.index, "nummod")
    edit.rehang(bound[0].index, numeral.index, "advmod")
    edit.retag(bound[0].index, "ADV")
    for word in bound[1:]:
        edit.rehang(word.index, bound[0].index, "fixed")
    return edit.tree()
