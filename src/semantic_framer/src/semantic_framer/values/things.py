"""Finds nouns that are no things (deeds, events, ways and vehicles), phrases without a noun, names of directions."""

from typing import Sequence

from semantic_types.parts_of_speech import parts_of_speech
from utterance_passes.trees.persons import is_abstract
from utterance_passes.trees.tree import DependencyTree, Word
from word_classes import word_class

_ALL_DIRECTIONS = word_class("all_directions")
_DEEDS_WITH_LIGHT_VERBS = word_class("deed_nouns_with_light_verbs")
_INDEFINITE_ARTICLES = word_class("indefinite_articles")
_GENERAL = word_class("general_thing_nouns")
_LIGHT_VERBS = word_class("light_verbs_of_deeds")
_OBJECT_PRONOUNS = word_class("object_pronouns")
#: Relations of words before a noun that a unit may ask for: "Roger *'s* door".
_OF_NOUNS = frozenset(["det", "nmod:poss", "case"])
_ONLY_BEFORE_NOUNS = word_class("only_before_nouns")
_WAYS = word_class("ways_and_vehicles")


def is_no_thing(tree: DependencyTree, index: int, verb: str) -> bool:
    """Whether a noun does not name a thing that the verb can act on.

    Args:
        tree: the sentence
        index: index of the noun
        verb: the verb: "take a seat" is not about a thing, "bring a seat" is
    """
    lemma = tree.word(index).lemma.lower()
    first = verb.split()[0]
    if first not in _LIGHT_VERBS:
        return False
    if is_abstract(tree, index):
        return True
    # "Grab an *apple slice*", "take that *thing*".
    is_thing = lemma in _GENERAL or any(child.deprel == "compound" for child in tree.children(index))
    if not is_thing and is_abstract(tree, index, is_mostly=True):
        return True
    return lemma in _WAYS or (lemma in _DEEDS_WITH_LIGHT_VERBS and not is_definite(tree, index))


def is_indefinite(tree: DependencyTree, index: int) -> bool:
    """Whether a noun has an indefinite article."""
    return any(child.deprel == "det" and child.said in _INDEFINITE_ARTICLES for child in tree.children(index))


def is_definite(tree: DependencyTree, index: int) -> bool:
    """Whether a noun has a possessor, or a determiner other than an indefinite article: "my seat", "the seat"."""
    children = tree.children(index)
    return any(child.deprel in ("det", "nmod:poss") for child in children) and not is_indefinite(tree, index)


def is_unfinished(tree: DependencyTree, index: int) -> bool:
    """Whether a phrase has no noun ("to the" in "go to the"), or only a slip of the tongue or of the keyboard."""
    words = [word for word in map(tree.word, tree.subtree(index)) if word.index not in tree.fillers]
    named = [word for word in words if word.deprel != "case" and word.upos != "PUNCT"]
    is_of_noun = tree.word(index).deprel in _OF_NOUNS
    return not is_of_noun and (
        all(word.said in _ONLY_BEFORE_NOUNS for word in named) or _is_slip(named, tree.word(index))
    )


def _is_slip(words: Sequence[Word], head: Word) -> bool:
    """Whether words name nothing for certain: a single small letter ("n" for "and"), a pronoun with a letter too many
    ("mee"), or a noun that is begun twice ("the kit kitchen")."""
    form = head.form
    is_bare = all(word.upos in ("ADJ", "ADV") for word in words if word is not head)
    # "Until i return."
    is_bare = is_bare and not (head.upos == "PRON" and head.deprel.startswith("nsubj"))
    if is_bare and form.islower() and form.isalpha() and form not in _OBJECT_PRONOUNS:
        if len(form) == 1 or (_may_be_pronoun(form) and not parts_of_speech(form)):
            return True
    return any(
        second.index == first.index + 1
        and 1 < len(first.form) < len(second.form)
        and second.said.startswith(first.said)
        and first.upos in ("NOUN", "PROPN", "ADJ", "X")
        and second.upos == "NOUN"
        for first, second in zip(words, words[1:])
    )


def _may_be_pronoun(form: str) -> bool:
    """Whether a word is a pronoun with one letter twice, or with two letters in each other's place."""
    pairs = range(len(form) - 1)
    single = {form[:at] + form[at + 1 :] for at in pairs if form[at] == form[at + 1]}
    swapped = {form[:at] + form[at + 1] + form[at] + form[at + 2 :] for at in pairs}
    return bool(_OBJECT_PRONOUNS & (single | swapped))


def is_direction(tree: DependencyTree, index: int) -> bool:
    """Whether a word names a direction: "east", "left"."""
    return tree.word(index).said in _ALL_DIRECTIONS
