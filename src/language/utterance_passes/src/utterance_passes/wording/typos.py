"""Corrects words with one wrong letter: "trun left", "go to the kichen".

A word is corrected only if it is no English word and no name, and if exactly one word of the lexicon is one letter
away: one letter more, one less, one other, or two changed places. The person is told what was assumed, because the
words of a clause show what was written: ``as_written``.
"""

import re
from functools import lru_cache
from typing import AbstractSet, FrozenSet, Iterable, Iterator, List, Optional, Sequence

from semantic_frames.lexical_unit import LexicalUnit
from semantic_types.parts_of_speech import ADJECTIVE, NOUN, VERB, base_forms, parts_of_speech
from spoken_quantities import find_unit, number_words, unit_words
from utterance_passes.engine.utterance_pass import Example, Kind, word_pass
from utterance_passes.trees.spelling import Spelling
from utterance_passes.trees.tree import DependencyTree, Word
from utterance_passes.trees.vocabulary import Verbs
from word_classes import word_class
from word_classes.shipped import word_classes

#: Shorter words have too many neighbours.
_SHORTEST = 4
_WORD = re.compile(r"(?<![\w'-])[A-Za-z]{3,}(?![\w'-])")
_NEXT_WORD = re.compile(r"\s+([A-Za-z]+)")
_LETTERS = "abcdefghijklmnopqrstuvwxyz"
#: Row and column of each letter on a keyboard; each row stands to the right of the one above it.
_KEYS = {
    letter: (row, column + shift)
    for row, (letters, shift) in enumerate((("qwertyuiop", 0.0), ("asdfghjkl", 0.25), ("zxcvbnm", 0.75)))
    for column, letter in enumerate(letters)
}
_DRAWN_OUT = re.compile(r"([a-z])\1{2,}")
_FINAL = " .!?"
_GERUND = "ing"
_SAYING = word_class("saying_verbs")
_BEFORE_NOUNS = word_class("only_before_nouns")
_TO = "to"
#: Behind these prepositions stands no verb: "look at marco" has no "march".
_BEFORE_NAMES = (word_class("directional_prepositions") | word_class("place_prepositions")) - {_TO}
#: What stands behind a whole phrase; nothing, too.
_ENDS_OF_PHRASES = frozenset(["", *word_class("words_between_commands")])
#: "Nevr turn left": what may forbid the deed is no name of the robot.
_NEGATIONS = {**{word: word for word in word_class("negations") if len(word) >= _SHORTEST}, "dont": "don't"}
_BEFORE_VERBS = word_class("leading_verbs") | word_class("aspectual_verbs") | word_class("verbs_with_verbs")
#: Words of three letters in which two often change places: "teh".
_SHORT = frozenset(
    word
    for name in ("articles", "linking_conjunctions", "subject_pronouns", "only_before_nouns")
    for word in word_class(name)
    if len(word) == _SHORTEST - 1
)


def spellings_of(units: Iterable[LexicalUnit]) -> FrozenSet[str]:
    """Return the words that some units know: their verbs, the words that they list, and those of their examples."""
    texts = (
        text
        for unit in units
        for text in (
            *unit.verbs,
            *(word for relation in unit.relations for word in relation.words),
            *(example.text for example in unit.examples),
        )
    )
    words = (word for text in texts for word in re.findall(r"[A-Za-z]+", text))
    # "Alice" is a name, and no "lice".
    return frozenset(word for word in words if word.islower() and len(word) >= _SHORTEST)


@word_pass(
    Kind.SPELLING,
    Example("trun left", ("turn left",), Verbs(frozenset(["turn"]), spellings=frozenset(["turn", "left"]))),
)
def typos(spelling: Spelling, vocabulary: Verbs) -> Spelling:
    """Correct a word with one wrong letter if one word of the lexicon is meant. Words to be said stay as they are."""
    text, position = "", 0
    origins: List[int] = []
    end = len(spelling.text.rstrip(_FINAL))
    for match in _WORD.finditer(spelling.text) if vocabulary.spellings else ():
        before = spelling.text[: match.start()]
        if match.group().lower() in _SAYING or before.count('"') % 2:
            break
        behind = _NEXT_WORD.match(spelling.text, match.end())
        meant = _meant(
            match.group(),
            re.findall(r"\w+", before.lower()),
            behind.group(1).lower() if behind else "",
            vocabulary,
        )
        if meant is None and match.end() == end:
            meant = _cut_off(match.group(), vocabulary)
        if meant is None:
            continue
        text += spelling.text[position : match.start()] + meant
        origins += [*spelling.origins[position : match.start()], *[spelling.origins[match.start()]] * len(meant)]
        position = match.end()
    if not position:
        return spelling
    return Spelling(text + spelling.text[position:], (*origins, *spelling.origins[position:]))


def _meant(word: str, before: Sequence[str], behind: str, vocabulary: Verbs) -> Optional[str]:
    """Return the word that was meant; None if the word stands for itself, or if it is not certain what was meant.

    Args:
        word: the word
        before: the words before it, in lower case
        behind: the word behind it, in lower case; empty if a mark or nothing follows
        vocabulary: what the robot knows
    """
    said = word.lower()
    known = vocabulary.spellings | _known_words()
    # "Unmuted" is a form of a verb that WordNet does not have.
    is_verb = not vocabulary.words.isdisjoint(base_forms(said, VERB))
    if said in known or is_verb or said in vocabulary.names or parts_of_speech(said):
        return None
    nears = frozenset(_near(said))
    negation = next(iter(sorted(nears & _NEGATIONS.keys())), None)
    if negation is not None and behind in vocabulary.words:
        return _NEGATIONS[negation]
    drawn_out = _without_drawn_out_letters(said, known | vocabulary.names)
    if drawn_out:
        return drawn_out
    # A rare word of a closed class, such as a month, may be one letter from a name: "marco".
    meant_words = vocabulary.spellings | vocabulary.names | frozenset(unit_words())
    if len(said) < _SHORTEST:
        return _with_changed_places(said) if word.islower() else None
    found = sorted(nears & meant_words)
    if before[-1:] and before[-1] in _BEFORE_NOUNS:
        nouns = [near for near in found if near not in vocabulary.words]
        found = [near for near in nouns if parts_of_speech(near) & {NOUN, ADJECTIVE}]
    elif before[-1:] and (before[-1].isdigit() or before[-1] in number_words()):
        found = [near for near in found if find_unit(near) is not None] or found
    elif before[-1:] and (
        before[-1] in _BEFORE_NAMES
        or before[-1] in vocabulary.words - _BEFORE_VERBS
        or before[-1].endswith(_GERUND)  # "following alice" has no "slice"
    ):
        found = [near for near in found if near not in vocabulary.words]
    elif before[-1:] == [_TO] and behind in _ENDS_OF_PHRASES:
        # "Bring it to marco" has no "march"; but "I want you to trun" has "turn".
        found = [near for near in found if near not in vocabulary.words or sorted(near) == sorted(said)]
    if not before:
        # The first letter of a word is seldom wrong: "Alice" is a name, and no "slice".
        found = [near for near in found if near[0] == said[0] or sorted(near) == sorted(said)]
    found = [near for near in found if sorted(near) == sorted(said)] or found
    if len({_unit_name(near) for near in found}) != 1 or (
        set(found) <= vocabulary.words and _may_be_another_verb(said, found[0], nears, is_first=not before)
    ):
        return None
    meant = max(found, key=lambda near: (near[-1] == said[-1], _beginning(near, said)))
    if word.islower():
        return meant
    # A capital may be that of a name: "Rosie, turn left".
    return meant.capitalize() if not before and meant in vocabulary.words else None


def _may_be_another_verb(said: str, meant: str, nears: AbstractSet[str], *, is_first: bool) -> bool:
    """Whether a short word with another letter is as near to a verb that the robot does not know.

    "Tfil" is neither "tail" nor "toil" for certain; but "taje" is "take", whose key stands beside the one that was hit.

    Args:
        said: the word
        meant: the verb of the lexicon
        nears: what is one letter away
        is_first: whether it begins the sentence, and so has its first letter right
    """
    if len(said) != _SHORTEST or len(meant) != len(said) or sorted(meant) == sorted(said):
        return False
    if any(one != other and _are_beside(one, other) for one, other in zip(said, meant)):
        return False
    return any(
        VERB in parts_of_speech(near)
        for near in nears
        if len(near) == len(said) and near != meant and (near[0] == said[0] or not is_first)
    )


def _are_beside(one: str, other: str) -> bool:
    """Whether the keys of two letters touch."""
    (row, column), (other_row, other_column) = _KEYS[one], _KEYS[other]
    return abs(row - other_row) <= 1 and abs(column - other_column) <= 1.0


def _cut_off(word: str, vocabulary: Verbs) -> Optional[str]:
    """Return the word of the lexicon of which a recording has only the beginning: "take another *pictu*"."""
    if len(word) <= _SHORTEST or not word.islower() or word in _known_words() or parts_of_speech(word):
        return None
    found = sorted(whole for whole in vocabulary.spellings - vocabulary.words if whole.startswith(word))
    # "Pictu" may be "picture" or "pictures", and then it is the shorter one.
    return found[0] if found and all(whole.startswith(found[0]) for whole in found) and word != found[0] else None


def _without_drawn_out_letters(said: str, known: AbstractSet[str]) -> str:
    """Return the word that somebody draws out: "pleeease", "baaall"; empty if there is none."""
    if not _DRAWN_OUT.search(said):
        return ""
    made = [_DRAWN_OUT.sub(letters, said) for letters in (r"\1", r"\1\1")]
    return next((word for word in made if word in known or parts_of_speech(word)), "")


def _with_changed_places(said: str) -> Optional[str]:
    """Return the function word of three letters that a word is if two of its letters change places: "teh"."""
    swapped = {said[:place] + said[place + 1] + said[place] + said[place + 2 :] for place in range(len(said) - 1)}
    found = sorted(swapped & _SHORT)
    return found[0] if len(found) == 1 else None


def _beginning(one: str, other: str) -> int:
    """Return the length of the beginning that two words share."""
    return next((place for place, letters in enumerate(zip(one, other)) if len(set(letters)) > 1), len(one))


def _unit_name(word: str) -> str:
    """Return the name of a unit, whatever its spelling; another word stands for itself."""
    unit = find_unit(word)
    return unit.name if unit is not None else word


@lru_cache(maxsize=None)
def _known_words() -> FrozenSet[str]:
    """Return the words of closed classes and of numbers, which WordNet does not have."""
    words = (word for known in word_classes().values() for phrase in known.words for word in phrase.split())
    return frozenset(word for word in (*words, *number_words(), *unit_words()) if len(word) >= _SHORTEST)


def _near(word: str) -> Iterator[str]:
    """Return the spellings that are one letter away and not too short."""
    parts = [(word[:place], word[place:]) for place in range(len(word) + 1)]
    made = [front + back[1] + back[0] + back[2:] for front, back in parts if len(back) > 1]
    made += [front + back[1:] for front, back in parts if back]
    made += [front + letter + back[1:] for front, back in parts if back for letter in _LETTERS]
    made += [front + letter + back for front, back in parts for letter in _LETTERS]
    return (near for near in made if len(near) >= _SHORTEST and near != word)


def as_written(tree: DependencyTree, word: Word) -> str:
    """Return a word as the person wrote it if it had a wrong letter; empty for other words."""
    written = tree.text[word.start_character : word.end_character]
    form = word.said
    if len(written) < _SHORTEST or not written.isalpha() or written.lower() == form or not form.isalpha():
        return ""
    is_cut_off = len(written) > _SHORTEST and form.startswith(written.lower())
    is_near = is_cut_off or form in _near(written.lower())
    return written if is_near and not parts_of_speech(written) else ""
