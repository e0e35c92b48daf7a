"""What the lexicon knows better than a tagger that learned from text in which commands are rare.

A word at the front of a command that the lexicon knows as a verb is a verb, not a name: "Scrub the pot", "Ping". The
rule looks at one place only: the first word behind an addressee, politeness and fillers.

A word between "to" and a last number that the lexicon does not know as a verb is what the number counts: "compute the
sequence to order seven", "turn the volume to level three". No command tells the robot to "order seven".
"""

from dataclasses import replace
from typing import FrozenSet, Optional, Sequence, Tuple

from stanford_parser_ros.tree import DependencyTree, Word

#: Words that may stand before the verb of a command, with a comma or without.
LEAD_IN = frozenset(
    "please now ok okay so well uh um hey hi hello then and robot just kindly also next first finally".split()
)
_NOUNS = {"NOUN", "PROPN", "PRON", "NUM", "ADJ", "DET"}


def command_verb_position(forms: Sequence[str], verbs: FrozenSet[str]) -> Optional[int]:
    """Find the word that has to be the verb of a command.

    Args:
        forms: words of the sentence
        verbs: known verbs in their base form, lower case
    Returns:
        its index from 1; None when the front of the sentence holds no known verb
    """
    position = 0
    while position < len(forms) and (forms[position].lower() in LEAD_IN or forms[position] == ","):
        position += 1
    if position < len(forms) and forms[position].lower() in verbs:
        # "Name is Bob", "Face it": a noun that is followed by a finite verb is no command.
        following = forms[position + 1].lower() if position + 1 < len(forms) else ""
        return None if following in ("is", "are", "was", "were", "'s") else position + 1
    return None


def numbered_noun_position(forms: Sequence[str], tags: Sequence[str], verbs: FrozenSet[str]) -> Optional[int]:
    """Find a noun that was taken for a verb because "to" stands before it, and a number behind it.

    Args:
        forms: words of the sentence
        tags: their universal parts of speech
        verbs: known verbs in their base form, lower case; without any, nothing is known better
    Returns:
        its index from 1; None when there is none
    """
    for position in range(2, len(forms) - 1):
        is_last = position + 2 == len(forms) or tags[position + 2] in ("PUNCT", "CCONJ")
        if (
            verbs
            and forms[position - 1].lower() == "to"
            and tags[position] == "VERB"
            and forms[position].lower() not in verbs
            and tags[position + 1] == "NUM"
            and is_last
        ):
            return position + 1
    return None


def rerooted(tree: DependencyTree, index: int) -> DependencyTree:
    """Make a word the root: what was the root hangs on it, and so does what was between them.

    Args:
        tree: a sentence
        index: of the word that has to be the root
    Returns:
        a tree with the same words
    """
    verb = tree.word(index)
    if verb.head == 0:
        return tree
    old_root = next(word for word in tree.words if word.head == 0)
    words: Tuple[Word, ...] = tuple(_reattached(word, verb, old_root) for word in tree.words)
    return DependencyTree(text=tree.text, words=words)


def _reattached(word: Word, verb: Word, old_root: Word) -> Word:
    if word.index == verb.index:
        return replace(word, head=0, deprel="root")
    if word.index == old_root.index:
        return replace(word, head=verb.index, deprel="obj" if word.upos in _NOUNS else "xcomp")
    if word.head == old_root.index and word.deprel.split(":")[0] in (
        "punct",
        "obl",
        "advmod",
        "discourse",
        "vocative",
        "conj",
        "parataxis",
    ):
        return replace(word, head=verb.index)
    return word
