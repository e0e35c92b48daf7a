"""Gives one verb to two groups of phrases: "put the mug on the table and the plate in the sink".

A parser trained on text attaches the second group to the noun before it, so that the plate becomes a place, or the
robot puts the mug twice. The shape of the phrases shows the groups: phrase by phrase, the second group matches the end
of the first.
"""

from dataclasses import dataclass
from enum import Enum
from typing import FrozenSet, Iterator, List, Optional, Sequence, Set, Tuple

from utterance_passes.clauses import Clause, find_clauses
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit, mark_argument_clusters
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

_DIRECTIONAL = word_class("directional_prepositions")
_PLACE = word_class("placing_prepositions")
_BEFORE_NOUNS = frozenset(["DET", "ADJ", "NUM"])
_NOUNS = frozenset(["NOUN", "PROPN", "NUM", "SYM"])
#: Relations between the words of a noun phrase.
_INSIDE = frozenset(["compound", "flat", "nummod", "amod", "det", "fixed", "goeswith"])
_JOINING = frozenset(["and", ",", "then"])


class _Kind(Enum):
    """The form of a phrase."""

    NOUN = "noun phrase"
    PREPOSITION = "phrase with a preposition"
    ADVERB = "adverb or particle"


@dataclass(frozen=True)
class _Phrase:
    """A phrase of a clause.

    Attributes:
        kind: its form
        words: its words, in order
        preposition: the first word of its preposition; empty if it has none
    """

    kind: _Kind
    words: Tuple[Word, ...]
    preposition: str = ""

    @property
    def head(self) -> int:
        """The word that governs the others: the last noun that does not follow "of"."""
        named = self.words
        forms = [word.form.lower() for word in named]
        if "of" in forms[1:]:
            named = named[: forms.index("of", 1)]
        inside = {word.index for word in named}
        tops = [word for word in named if word.head not in inside and word.upos not in ("ADP", "DET", "CCONJ")]
        nouns = [word for word in tops if word.upos in _NOUNS or word.upos == "PRON"]
        return (nouns or tops or list(named))[-1].index

    def is_like(self, other: "_Phrase") -> bool:
        """Whether both can have one role: "on the table" and "in the sink", not "on the table" and "to the sink"."""
        if self.kind is not other.kind:
            return False
        both = {self.preposition, other.preposition}
        return len(both) == 1 or both <= _PLACE or both <= _DIRECTIONAL


_Group = Tuple[_Phrase, ...]


def expand_argument_clusters(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Attach each group of phrases that share a verb to the verb, and mark the groups: ``find_clauses`` turns each into
    a clause. If groups end alike but differ before that, their phrases get the relation ``dep``, which no unit knows.
    """
    edit = TreeEdit(tree)
    clusters: List[Tuple[int, FrozenSet[int]]] = []
    for clause in find_clauses(tree, vocabulary):
        if clause.lemma != "be" and vocabulary.speech_of(clause.lemma) is None:
            clusters += _expand(tree, clause, edit)
    return mark_argument_clusters(edit.tree(), tuple(clusters))


def _expand(tree: DependencyTree, clause: Clause, edit: TreeEdit) -> List[Tuple[int, FrozenSet[int]]]:
    for index in _particles_behind_and(tree, clause):
        # No unit takes it, so that "turn on the light and off the radio" does not turn both off.
        edit.rehang(index, clause.verb, "dep")
        return []
    pieces = _groups(tree, clause)
    if pieces is None or len(pieces) < 2:
        return []
    groups = _with_names_apart(pieces) or _with_lists_as_one(pieces)
    first, others = groups[0], groups[1:]
    length = len(others[0]) if others else 0
    if length < 2 or len(first) < length:
        return []
    model = first[-length:]
    if not all(len(group) == length and _ends_alike(model, group) for group in others):
        return []
    if not all(one.is_like(other) for group in others for one, other in zip(model, group)):
        for group in others:
            for phrase in group:
                edit.rehang(phrase.head, clause.verb, "dep")
        return []
    _hang(tree, clause, model, model, edit)
    for group in others:
        _hang(tree, clause, model, group, edit)
    return [(clause.verb, frozenset(phrase.head for phrase in group)) for group in (model, *others)]


def _particles_behind_and(tree: DependencyTree, clause: Clause) -> List[int]:
    """Return the particles that begin another group with an object of its own."""
    return [
        index
        for index in sorted(clause.positions)
        if tree.word(index).deprel == "compound:prt"
        and index > clause.verb + 1
        and tree.word(index - 1).form.lower() == "and"
        and index + 1 in clause.positions
        and tree.word(index + 1).upos in (*_BEFORE_NOUNS, *_NOUNS)
    ]


def _ends_alike(model: _Group, group: _Group) -> bool:
    """Whether all phrases are alike, or the last ones have the same preposition: "to the kitchen with the cup and the
    bathroom with the plate".
    """
    if all(one.is_like(other) for one, other in zip(model, group)):
        return True
    return bool(group[-1].preposition) and group[-1].preposition == model[-1].preposition


def _hang(tree: DependencyTree, clause: Clause, model: _Group, group: _Group, edit: TreeEdit) -> None:
    """Attach the phrases of a group in the same way as those of the first group."""
    nouns = [phrase for phrase in model if phrase.kind is _Kind.NOUN]
    for like, phrase in zip(model, group):
        head = tree.word(like.head)
        if phrase.kind is _Kind.NOUN and len(nouns) == 2:
            deprel = "iobj" if like is nouns[0] and not _is_measure(tree, nouns[1]) else "obj"
        elif phrase.kind is _Kind.NOUN:
            deprel = "obj"
        elif phrase.kind is _Kind.PREPOSITION:
            deprel = "obl"
        else:
            deprel = head.deprel if head.deprel == "compound:prt" else "advmod"
        if phrase.kind is _Kind.NOUN and _is_measure(tree, phrase):
            deprel = "obl:unmarked"
        governor = clause.verb
        # If "the mug on the table" was one phrase, it stays one.
        if phrase.kind is _Kind.PREPOSITION and like is not model[0] and head.head == model[0].head:
            governor, deprel = group[0].head, "nmod"
        inside = {word.index for word in phrase.words}
        for word in phrase.words:
            if word.index != phrase.head and word.head not in inside:
                edit.rehang(word.index, phrase.head)
        edit.rehang(phrase.head, governor, deprel)


def _is_measure(tree: DependencyTree, phrase: _Phrase) -> bool:
    return tree.word(phrase.head).deprel == "obl:unmarked"


def _with_names_apart(groups: Sequence[_Group]) -> Optional[List[_Group]]:
    """Divide groups of a name and a bare noun, as in "Anna coffee and Ben tea"; None unless all groups are so."""
    found: List[_Group] = []
    for group in groups:
        words = group[0].words
        if len(group) != 1 or [word.upos for word in words] != ["PROPN", "NOUN"]:
            return None
        found.append((_Phrase(_Kind.NOUN, words[:1]), _Phrase(_Kind.NOUN, words[1:])))
    return found


def _with_lists_as_one(groups: Sequence[_Group]) -> List[_Group]:
    """Join a lone noun to the group after it: "the mug and the fork on the table"."""
    found: List[_Group] = []
    waiting: List[Word] = []
    for group in groups:
        if waiting and group[0].kind is _Kind.NOUN:
            group = (_Phrase(_Kind.NOUN, (*waiting, *group[0].words)), *group[1:])
            waiting = []
        if len(group) == 1 and group[0].kind is _Kind.NOUN:
            waiting = list(group[0].words)
        else:
            found.append(group)
    return found if not waiting else [*found, (_Phrase(_Kind.NOUN, tuple(waiting)),)]


def _groups(tree: DependencyTree, clause: Clause) -> Optional[List[_Group]]:
    """Divide the words after a verb into phrases, and the phrases into groups at "and", "then" and commas.

    Returns:
        the groups; None if the words contain anything else, such as a clause or a choice
    """
    left_out = tree.abandoned | tree.fillers
    behind = [index for index in sorted(clause.positions - left_out) if index > clause.verb]
    while behind and tree.word(behind[-1]).upos == "PUNCT":
        behind.pop()
    if not behind or tree.quoted & set(behind) or set(range(clause.verb + 1, behind[-1])) - set(behind) - left_out:
        return None
    words = [tree.word(index) for index in behind]
    groups: List[List[_Phrase]] = [[]]
    position = 0
    while position < len(words):
        word = words[position]
        if word.form.lower() in _JOINING:
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


def _phrase(tree: DependencyTree, words: Sequence[Word]) -> Optional[_Phrase]:
    """Return the phrase at the front of some words; None if there is none."""
    prepositions = 0
    while prepositions < len(words) and words[prepositions].deprel in ("case", "fixed"):
        prepositions += 1
    taken = prepositions + _length_of_noun_phrase(tree, words[prepositions:])
    if taken > prepositions:
        while taken < len(words) and words[taken].form.lower() == "of":
            more = _length_of_noun_phrase(tree, words[taken + 1 :])
            if not more:
                return None
            taken += 1 + more
        if prepositions:
            return _Phrase(_Kind.PREPOSITION, tuple(words[:taken]), words[0].form.lower())
        return _Phrase(_Kind.NOUN, tuple(words[:taken]))
    if words[0].upos in ("ADV", "ADP", "ADJ") and words[0].form.lower() != "to":
        return _Phrase(_Kind.ADVERB, (words[0],))
    return None


def _length_of_noun_phrase(tree: DependencyTree, words: Sequence[Word]) -> int:
    """Return the length, in words, of the noun phrase at the front of some words; 0 if there is none."""
    if words and words[0].upos == "PRON" and words[0].deprel != "nmod:poss":
        return 1
    taken: List[Word] = []
    has_noun = False
    for word, following in _with_following(words):
        is_possessive = word.upos == "PART" and word.deprel == "case"
        is_before = word.upos in _BEFORE_NOUNS or word.deprel == "nmod:poss"
        if is_possessive and has_noun:
            has_noun = False
        elif has_noun and not (word.upos in _NOUNS and _is_linked(word, taken)):
            break
        elif word.upos in _NOUNS and (word.upos != "NUM" or has_noun or not _goes_on(following)):
            has_noun = True
        elif word.upos in _NOUNS or is_before:
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
