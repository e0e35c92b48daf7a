"""Which phrase a prepositional phrase belongs to, where the parser hung it on the verb and no element asks for it."""

from typing import Dict, FrozenSet, Mapping, Tuple

from semantic_framer.sentence import Sentence

#: Prepositions that say where something is, and so may tell which one is meant: "the mug on the table".
STATIC = frozenset(
    "on in at near under behind beside beneath below above over inside outside between against by next close around "
    "of".split()
)
#: Prepositions that tell which thing or person is meant only right behind its name: "the guy with the blue jacket".
_OF_A_THING = frozenset(["with", "without"])
_PLACE_ADVERBS = frozenset(["here", "there", "upstairs", "downstairs", "outside", "inside"])
#: Adverbs in front of a preposition that make it more precise: "close to the door", "over to the sofa".
_OF_A_PREPOSITION = frozenset("close over right straight directly back up down out along all just near next".split())
#: Sides of a thing where "of" follows, and directions where it does not: "to the left", "to the left of the table".
_SIDES = frozenset(["left", "right", "front", "back", "top", "bottom"])
_OF_A_NUMBER = frozenset("by about almost around roughly approximately nearly exactly precisely another".split())


def joined_phrases(
    sentence: Sentence, verb: int, phrases: Mapping[str, Tuple[int, FrozenSet[int]]], free: FrozenSet[int]
) -> Dict[str, FrozenSet[int]]:
    """Find phrases that hang on a verb and tell more of the element in front of them.

    Args:
        sentence: the sentence
        verb: position of the verb
        phrases: head and positions of each element that may be told more of, prepositions included
        free: positions that nothing accounts for
    Returns:
        positions to add to an element, by its name
    """
    ends = {max(positions): name for name, (_, positions) in phrases.items() if positions}
    found: Dict[str, FrozenSet[int]] = {}
    for child in sentence.children(verb):
        subtree = sentence.subtree(child.index)
        words = frozenset(index for index in subtree if sentence.word(index).upos != "PUNCT")
        name = ends.get(min(subtree) - 1)
        if name is None or child.index not in free or child.index not in words or not _is_whole(words):
            continue
        head = phrases[name][0]
        if sentence.word(head).upos in ("NOUN", "PROPN", "NUM") and _tells_which(sentence, child.index, head):
            found[name] = found.get(name, frozenset()) | words
            ends[max(words)] = name
    return found


def _is_whole(words: FrozenSet[int]) -> bool:
    return max(words) - min(words) == len(words) - 1


def _tells_which(sentence: Sentence, index: int, head: int) -> bool:
    word = sentence.word(index)
    if word.deprel == "advmod":
        return word.form.lower() in _PLACE_ADVERBS
    if not word.deprel.startswith(("obl", "nmod")):
        return False
    prepositions = [child.form.lower() for child in sentence.children(index) if child.deprel == "case"]
    if not prepositions:
        return False
    is_thing = word.upos != "PRON" and not any(child.deprel == "case" for child in sentence.children(head))
    return prepositions[0] in STATIC or (prepositions[0] in _OF_A_THING and is_thing)


def is_side_of_something(sentence: Sentence, index: int) -> bool:
    """Whether a word is a side of a thing, and no direction: "the left of the table"."""
    return sentence.word(index).form.lower() in _SIDES and any(
        child.deprel.startswith("nmod")
        and any(inner.deprel == "case" and inner.form.lower() == "of" for inner in sentence.children(child.index))
        for child in sentence.children(index)
    )


def words_before(sentence: Sentence, verb: int, first: int, free: FrozenSet[int]) -> FrozenSet[int]:
    """Return the adverb right in front of a preposition that makes it more precise: "close" of "close to the door"."""
    before = first - 1
    if before <= verb or before not in free or sentence.word(first).deprel != "case":
        return frozenset()
    word = sentence.word(before)
    is_precise = word.deprel == "advmod" and word.form.lower() in _OF_A_PREPOSITION
    return frozenset([before]) if is_precise else frozenset()


def words_before_amount(sentence: Sentence, first: int) -> FrozenSet[int]:
    """Return the words in front of a number that belong to it: "by almost" of "by almost 90 degrees"."""
    found = []
    position = first - 1
    while position > 0 and sentence.word(position).form.lower() in _OF_A_NUMBER:
        found.append(position)
        position -= 1
    return frozenset(found)
