"""Verbs that stand for another one: "can I have the mug" wishes for it, and who does a u-turn makes one."""

from dataclasses import replace
from typing import FrozenSet

from stanford_parser_ros.tree import DependencyTree, Word

from semantic_framer.lexicon import Lexicon
from semantic_framer.mending import mended

_WISH = "want"
#: "Can I have ...", "could we get ...".
_ASKED_FOR = frozenset(["have", "get"])
_MAY = frozenset(["can", "could", "may", "might"])
#: "I would love ...": without "would" it tells what somebody is fond of.
_WISHED = frozenset(["like", "love", "prefer", "appreciate"])
_WOULD = frozenset(["would", "'d", "’d"])
_SPEAKERS = frozenset(["i", "we"])


def with_plain_verbs(tree: DependencyTree, lexicon: Lexicon) -> DependencyTree:
    """Give verbs that stand for another one the dictionary form of that one.

    "Do" itself is no verb of a lexicon, since the parser would take that of "don't" for the command.

    Args:
        tree: the sentence
        lexicon: where it has no such verb the word stays as it is
    """
    tree = mended(tree)
    words = []
    for word in tree.words:
        lemma = word.lemma.lower()
        plain = lemma
        if lemma == "do" and word.upos == "VERB" and _is_made(tree, word, lexicon):
            plain = "make"
        elif lemma in _ASKED_FOR | _WISHED and lexicon.units_of(_WISH) and _is_wish(tree, word):
            plain = _WISH
        words.append(word if plain == lemma else replace(word, lemma=plain, form=plain))
    return replace(tree, words=tuple(words)) if tuple(words) != tree.words else tree


def _is_made(tree: DependencyTree, word: Word, lexicon: Lexicon) -> bool:
    made: FrozenSet[str] = frozenset(
        verb.partition(" ")[2] for verb in lexicon.verbs_beginning_with("make")
    ) | frozenset(
        listed for unit in lexicon.units_of("make") for relation in unit.relations for listed in relation.words
    )
    return any(child.deprel == "obj" and child.form.lower() in made for child in tree.children(word.index))


def _is_wish(tree: DependencyTree, word: Word) -> bool:
    children = tree.children(word.index)
    modals = _WOULD if word.lemma.lower() in _WISHED else _MAY
    is_for_another = any(child.form.lower() == "you" for child in children)
    return (
        any(child.deprel == "aux" and child.form.lower() in modals for child in children)
        and any(child.deprel == "nsubj" and child.form.lower() in _SPEAKERS for child in children)
        and any(child.deprel == "obj" for child in children)
        and not is_for_another
    )
