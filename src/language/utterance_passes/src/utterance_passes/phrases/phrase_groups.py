"""Divides the words after a verb into phrases, and the phrases into groups: "Anna the pen" and "Ben the cup"."""

from dataclasses import dataclass
from enum import Enum
from typing import Iterator, List, Optional, Sequence, Set, Tuple

from utterance_passes.phrases.clauses import Clause
from utterance_passes.trees.persons import is_person_or_name
from utterance_passes.trees.tree import DependencyTree, Word
from utterance_passes.trees.vocabulary import Speech
from word_classes import word_class

_PERSONS_TOLD = word_class("pronouns_of_persons")
_DIRECTIONAL = word_class("directional_prepositions")
_PLACE = word_class("placing_prepositions")
_BEFORE_NOUNS = frozenset(["DET", "ADJ", "NUM"])
_HEADS = frozenset(["NOUN", "PROPN", "NUM", "SYM"])
#: Relations between the words of a noun phrase.
_INSIDE = frozenset(["compound", "flat", "nummod", "amod", "det", "fixed", "goeswith"])
#: Words between two groups.
JOINING = frozenset(["and", ",", "then"])


class PhraseKind(Enum):
    """The form of a phrase."""

    NOUN = "noun phrase"
    PREPOSITION = "phrase with a preposition"
    ADVERB = "adverb or particle"


@dataclass(frozen=True)
class Phrase:
    """A phrase of a clause.

    Attributes:
        kind: its form
        words: its words, in order
        preposition: the first word of its preposition; empty if it has none
    """

    kind: PhraseKind
    words: Tuple[Word, ...]
    preposition: str = ""

    @property
    def head(self) -> int:
        """The word that governs the others: the last noun that does not follow "of"."""
        named = self.words
        forms = [word.said for word in named]
        if "of" in forms[1:]:
            named = named[: forms.index("of", 1)]
        inside = {word.index for word in named}
        tops = [word for word in named if word.head not in inside and word.upos not in ("ADP", "DET", "CCONJ")]
        nouns = [word for word in tops if word.upos in _HEADS or word.upos == "PRON"]
        return (nouns or tops or list(named))[-1].index

    def is_like(self, other: "Phrase") -> bool:
        """Whether both can have one role: "on the table" and "in the sink", not "on the table" and "to the sink"."""
        if self.kind is not other.kind:
            return False
        both = {self.preposition, other.preposition}
        return len(both) == 1 or both <= _PLACE or both <= _DIRECTIONAL


Group = Tuple[Phrase, ...]


def tells_several(tree: DependencyTree, clause: Clause, speech: Speech) -> bool:
    """Whether several persons are told something each: "tell *Anna* the time and *Ben* the weather", "say hello *to
    Anna* and goodbye *to Ben*"."""
    groups = groups_of(tree, clause) or ()
    pairs = with_names_apart(groups) or groups
    return len(pairs) > 1 and all(len(pair) == 2 and _is_told(tree, pair, speech) for pair in pairs)


def _is_told(tree: DependencyTree, pair: Group, speech: Speech) -> bool:
    """Whether one of two phrases is somebody, and the other one what is said."""
    first, second = pair
    if first.kind is PhraseKind.NOUN and second.preposition == "to":
        return _is_somebody(tree.word(second.head))
    are_nouns = first.kind is second.kind is PhraseKind.NOUN
    return speech is Speech.TOLD and are_nouns and _is_somebody(tree.word(first.head))


def _is_somebody(word: Word) -> bool:
    return word.said in _PERSONS_TOLD or is_person_or_name(word)


def with_names_apart(groups: Sequence[Group]) -> Optional[List[Group]]:
    """Divide groups of a name and a bare noun, as in "Anna coffee and Ben tea"; None unless all groups are so.

    The parser may have divided some of the groups.
    """
    found: List[Group] = []
    for group in groups:
        words = [word for phrase in group for word in phrase.words]
        if [word.upos for word in words] != ["PROPN", "NOUN"] or any(
            phrase.kind is not PhraseKind.NOUN for phrase in group
        ):
            return None
        found.append((Phrase(PhraseKind.NOUN, tuple(words[:1])), Phrase(PhraseKind.NOUN, tuple(words[1:]))))
    return found


def groups_of(tree: DependencyTree, clause: Clause) -> Optional[List[Group]]:
    """Divide the words after a verb into phrases, and the phrases into groups at "and", "then" and commas.

    Returns:
        the groups; None if the words contain anything else, such as a clause or a choice
    """
    left_out = tree.abandoned | tree.fillers
    # A comma before another clause belongs to that one, wherever it stands.
    last = max(clause.positions)
    commas = frozenset(word.index for word in tree.words if word.form == "," and word.index < last)
    behind = [index for index in sorted((clause.positions | commas) - left_out) if index > clause.verb]
    while behind and tree.word(behind[-1]).upos == "PUNCT":
        behind.pop()
    if not behind or tree.quoted & set(behind) or set(range(clause.verb + 1, behind[-1])) - set(behind) - left_out:
        return None
    words = [tree.word(index) for index in behind]
    groups: List[List[Phrase]] = [[]]
    position = 0
    while position < len(words):
        word = words[position]
        if word.said in JOINING:
            if groups[-1]:
                groups.append([])
            position += 1
            continue
        if position == 0 and word.deprel == "compound:prt":
            position += 1
            continue
        phrase = _phrase(tree, words[position:])
        if phrase is None:
            return None
        groups[-1].append(phrase)
        position += len(phrase.words)
    return [tuple(group) for group in groups if group]


def _phrase(tree: DependencyTree, words: Sequence[Word]) -> Optional[Phrase]:
    """Return the phrase at the front of some words; None if there is none."""
    prepositions = 0
    while prepositions < len(words) and words[prepositions].deprel in ("case", "fixed"):
        prepositions += 1
    taken = prepositions + _length_of_noun_phrase(tree, words[prepositions:])
    if taken > prepositions:
        while taken < len(words) and words[taken].said == "of":
            more = _length_of_noun_phrase(tree, words[taken + 1 :])
            if not more:
                return None
            taken += 1 + more
        taken += _length_of_purpose(words[taken:])
        if prepositions:
            return Phrase(PhraseKind.PREPOSITION, tuple(words[:taken]), words[0].said)
        return Phrase(PhraseKind.NOUN, tuple(words[:taken]))
    if words[0].upos == "INTJ" and not words[0].deprel.startswith("discourse"):
        return Phrase(PhraseKind.NOUN, (words[0],))
    if words[0].upos in ("ADV", "ADP", "ADJ") and words[0].said != "to":
        return Phrase(PhraseKind.ADVERB, (words[0],))
    return None


def _length_of_purpose(words: Sequence[Word]) -> int:
    """Return the length, in words, of the purpose at the front of some words: "something *to eat*"; 0 for none."""
    is_purpose = len(words) > 1 and words[0].said == "to" and words[1].xpos == "VB"
    return 2 if is_purpose and words[0].head == words[1].index else 0


def _length_of_noun_phrase(tree: DependencyTree, words: Sequence[Word]) -> int:
    """Return the length, in words, of the noun phrase at the front of some words; 0 if there is none."""
    # "The pen and *him the cup*": whatever the parser says, "him" owns nothing.
    if words and words[0].upos == "PRON" and (words[0].deprel != "nmod:poss" or words[0].xpos == "PRP"):
        return 1
    taken: List[Word] = []
    has_noun = False
    for word, following in _with_following(words):
        is_possessive = word.upos == "PART" and word.deprel == "case"
        is_before = word.upos in _BEFORE_NOUNS or word.deprel == "nmod:poss"
        if is_possessive and has_noun:
            has_noun = False
        elif has_noun and not (word.upos in _HEADS and _is_linked(word, taken)):
            break
        elif word.upos in _HEADS and (word.upos != "NUM" or has_noun or not _goes_on(following)):
            has_noun = True
        elif word.upos in _HEADS or is_before:
            has_noun = False
        else:
            break
        taken.append(word)
    return len(taken) if has_noun else 0


def _goes_on(following: Optional[Word]) -> bool:
    return following is not None and following.upos in ("NOUN", "PROPN", "ADJ", "NUM")


def _with_following(words: Sequence[Word]) -> Iterator[Tuple[Word, Optional[Word]]]:
    return zip(words, [*words[1:], None])


def _is_linked(word: Word, before: Sequence[Word]) -> bool:
    """Whether a noun belongs to the same phrase as the words before it."""
    inside: Set[int] = {other.index for other in before}
    if word.head in inside and word.deprel.split(":")[0] in _INSIDE:
        return True
    return before[-1].head == word.index and before[-1].deprel.split(":")[0] in _INSIDE
