"""Persons who were mentioned, and whom "her" and "him" may stand for."""

from dataclasses import replace
from typing import Dict, Iterable, List, Optional, Sequence, Tuple

from phrase_meanings.arguments import referring_to
from semantic_framer.values.sentence import Sentence
from typed_arguments import TypedArgument
from typed_arguments.positions import without_any_position
from utterance_passes.phrases.clauses import Clause
from utterance_passes.trees.persons import is_name_of_person
from utterance_passes.trees.tree import Word
from word_classes import word_class

#: FrameNet's semantic type of persons.
PERSON = "Human"
_MALE, _FEMALE = word_class("male_persons"), word_class("female_persons")
_HE, _SHE = word_class("male_pronouns"), word_class("female_pronouns")
#: Relations of a part of a name to its first or its last word: "*Dr.* Smith", "Anna *Smith*".
_OF_NAMES = frozenset(["compound", "flat", "nmod:desc"])
#: Pronouns for a person who was named before.
PERSONAL_PRONOUNS = _HE | _SHE
_THEM = "them"
_INDEFINITE = word_class("indefinite_persons") | word_class("indefinite_persons_asked")
_NO_NAMES = (
    PERSONAL_PRONOUNS
    | word_class("participants")
    | word_class("pronouns")
    | word_class("pronouns_of_persons_or_things")
)


def persons_mentioned(arguments: Iterable[TypedArgument], sentence: Sentence) -> Tuple[TypedArgument, ...]:
    """Return the persons that arguments name or describe, the last one first: "*Anna*", "the man", "*Bob*'s bag", "the
    question of *the man*"."""
    found: List[TypedArgument] = []
    for argument in arguments:
        if argument.text.lower() not in _NO_NAMES and _is_person(argument, sentence):
            found[:0] = argument.members or (argument,)
        parts = [part for part in (argument.possessor, argument.complement) if part is not None]
        found[:0] = persons_mentioned(parts, sentence)
        # "Tell Anna that *Bob* is here."
        told = (position for frame in argument.frames if frame.words for position in frame.positions)
        words = (_word_said(position, argument.words, sentence) for position in told)
        found[:0] = [_named(word) for word in words if word is not None and is_name_of_person(word)]
    return tuple(found)


def persons_told(sentence: Sentence, told: Iterable[Clause]) -> Tuple[TypedArgument, ...]:
    """Return the persons whom statements around a command name, the last one first: "I saw *Anna* in the garden, follow
    her".

    Args:
        sentence: the sentence
        told: its clauses that ask for nothing
    """
    words = (sentence.word(position) for clause in told for position in sorted(clause.positions))
    names = [word for word in words if word.deprel not in _OF_NAMES and is_name_of_person(word)]
    return tuple(replace(_named(name), text=_whole_name(name, sentence)) for name in reversed(names))


def _whole_name(name: Word, sentence: Sentence) -> str:
    parts = [child.index for child in sentence.children(name.index) if child.deprel in _OF_NAMES]
    return sentence.text(sorted([name.index, *parts]))


def _word_said(position: int, words: str, sentence: Sentence) -> Optional[Word]:
    """Return a word of a phrase; None if the phrase is of an earlier sentence, about which something was asked."""
    if not 0 < position <= len(sentence.tree.words) or sentence.word(position).form not in words:
        return None
    return sentence.word(position) if words in sentence.tree.text else None


def _is_person(argument: TypedArgument, sentence: Sentence) -> bool:
    """Whether an argument is a person; a name of which nothing is known may be one."""
    if argument.semantic_type:
        return argument.semantic_type == PERSON
    head = _word_said(argument.head_position, argument.words, sentence)
    return head is not None and is_name_of_person(head)


def _named(word: Word) -> TypedArgument:
    return TypedArgument(text=word.form, head=word.form, lemma=word.lemma, semantic_type=PERSON)


def persons_meant(
    pronoun: TypedArgument, persons: Sequence[TypedArgument], *, may_be_described: bool = False
) -> Tuple[TypedArgument, ...]:
    """Return whom "her" or "him" may stand for, each in the place of the pronoun; "them" may stand for the only
    person, if that is named.

    Args:
        pronoun: an argument; any other one stands for itself
        persons: who were mentioned
        may_be_described: whether those count who were not named, "a man in the hall"; for a server that acts, they are
            whom it has met by then
    Returns:
        several persons if it is open which one is meant; none if nobody fits, or somebody who does not count
    """
    word = pronoun.text.lower()
    by_text: Dict[str, TypedArgument] = {one.text.lower(): one for one in persons}
    is_only_one = word == _THEM and len(by_text) == 1
    if word not in PERSONAL_PRONOUNS and not is_only_one:
        return ()
    others = _FEMALE if word in _HE else _MALE if word in _SHE else frozenset()
    possible = [one for one in by_text.values() if one.lemma.lower() not in others]
    if (is_only_one or not may_be_described) and not all(map(_is_name, possible)):
        return ()
    return tuple(
        replace(referring_to(pronoun, without_any_position(one)), relation=pronoun.relation) for one in possible
    )


def whom_is_meant(pronoun: str) -> str:
    """Return the question what a pronoun stands for."""
    return f'{"Whom" if pronoun.lower() in PERSONAL_PRONOUNS else "What"} do you mean by "{pronoun}"?'


def _is_name(person: TypedArgument) -> bool:
    is_bare = not person.quantifier and person.possessor is None and person.count is None
    return is_bare and not person.is_plural and person.text.lower() not in _INDEFINITE | _MALE | _FEMALE
