"""Finds extra-thematic phrases among the words that a reading does not account for: "quickly", "for the party"."""

from typing import Dict, FrozenSet, List, Optional, Tuple

from phrase_meanings.arguments import with_words
from semantic_framer.values.sentence import Sentence
from semantic_frames.extra_thematic import ExtraThematicElement, extra_thematic_elements
from typed_arguments import TypedArgument
from utterance_passes.phrases.clauses import Clause
from utterance_passes.phrases.measures import amounts_of
from utterance_passes.trees.tree import Word
from word_classes import word_class

_CONDITIONS = word_class("conditions")
_NEGATIONS = word_class("negations")
#: FrameNet's element of what is true or not while something is done.
_OF_PROHIBITIONS = "Manner"
#: Relations of phrases that say something about a whole action.
_OF_ACTIONS = frozenset(["advmod", "obl", "nmod", "advcl", "xcomp", "compound"])


def extra_arguments(
    sentence: Sentence, clause: Clause, left_over: Tuple[int, ...]
) -> Optional[Tuple[TypedArgument, ...]]:
    """Return the extra-thematic phrases that hold all left-over words.

    Args:
        sentence: the sentence
        clause: the clause of the reading
        left_over: positions of the words that the reading does not account for
    Returns:
        an argument for each phrase, in the order of the sentence, with FrameNet's name of its element; None if a word
        is in no such phrase, and so may change what is to be done
    """
    groups = left_over_groups(sentence, clause, left_over)
    found = []
    for root, words in sorted(groups.items()):
        element = _element_of(sentence, clause, root, words)
        if element is None:
            return None
        own = sentence.subtree(root) & clause.positions
        argument = sentence.phrases.argument(element.name, root, left_out=sentence.subtree(root) - own)
        # All words are quoted to the person, also the "to" of "to clean the table".
        said = [index for index in sorted(own) if index in argument.positions or sentence.word(index).deprel == "mark"]
        found.append(with_words(sentence.tree, argument, said))
    return tuple(found)


def prohibition_beside(sentence: Sentence, clause: Clause) -> TypedArgument:
    """Return what is not to be done meanwhile as an argument that no server heeds: "but *don't drop it*"."""
    own = sorted(clause.positions)
    joining = [index for index in own if sentence.word(index).deprel in ("cc", "punct")]
    said = [index for index in own if index not in joining]
    argument = sentence.phrases.argument(_OF_PROHIBITIONS, clause.verb, left_out=frozenset(joining))
    return with_words(sentence.tree, argument, said)


def left_over_groups(sentence: Sentence, clause: Clause, left_over: Tuple[int, ...]) -> Dict[int, FrozenSet[int]]:
    """Return the left-over words of each phrase, by the head of the phrase."""
    left = frozenset(left_over)
    groups: Dict[int, List[int]] = {}
    for index in left_over:
        root = index
        while sentence.word(root).head and sentence.word(root).head in left and sentence.word(root).head != clause.verb:
            root = sentence.word(root).head
        groups.setdefault(root, []).append(index)
    return {root: frozenset(words) for root, words in groups.items()}


def _element_of(sentence: Sentence, clause: Clause, root: int, words: FrozenSet[int]) -> Optional[ExtraThematicElement]:
    word = sentence.word(root)
    inside = sorted(sentence.subtree(root) & clause.positions)
    forms = [sentence.word(index).said for index in inside if sentence.word(index).upos != "PUNCT"]
    is_of_action = word.deprel.split(":")[0] in _OF_ACTIONS and not word.deprel.startswith("nsubj")
    if not is_of_action or frozenset(forms) & (_CONDITIONS | _NEGATIONS):
        return None
    amounts = [
        amount for amount in amounts_of(sentence.tree, clause.positions, clause.verb) if words & {*amount.positions}
    ]
    if any(amount.is_doubtful for amount in amounts):
        return None
    kinds = frozenset(amount.quantity for amount in amounts if amount.unit)
    prepositions = " ".join(child.said for child in sentence.tree.prepositions(root) if child.index < root)
    marks = frozenset(child.said for child in sentence.children(root) if child.deprel == "mark")
    for element in extra_thematic_elements():
        if _fits(element, word, " ".join(forms), prepositions, marks, kinds):
            return element
    return None


def _fits(
    element: ExtraThematicElement,
    word: Word,
    text: str,
    prepositions: str,
    marks: FrozenSet[str],
    kinds: FrozenSet[str],
) -> bool:
    if element.heads and word.said not in element.heads:
        return False
    if element.measure:
        return kinds == {element.measure} and (not prepositions or prepositions in element.prepositions)
    if kinds:
        # Another measure says how much of something; nobody may leave it out.
        return False
    if word.deprel.split(":")[0] in ("advcl", "xcomp") and not prepositions:
        return bool(element.clauses & marks)
    if prepositions:
        return prepositions in element.prepositions
    is_adverb = word.upos in ("ADV", "ADJ") and " " not in text
    return text in element.adverbs or (is_adverb and bool(element.endings) and text.endswith(element.endings))
