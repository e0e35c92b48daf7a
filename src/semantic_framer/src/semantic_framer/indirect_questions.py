"""Reads the questions that a message asks, "tell me how many cups are on the table", as frames."""

from dataclasses import replace
from typing import List, Mapping, Optional, Sequence, Tuple

from phrase_meanings.meaning_file import shipped_meanings
from semantic_framer.framed_lexicon import FramedLexicon
from semantic_framer.question_words import PREPOSITIONS, compiled
from semantic_framer.reading import Reading
from typed_arguments import EmbeddedFrame, TypedArgument
from utterance_passes.tree import DependencyTree
from word_classes import without_determiner

_QUESTION = "question"


def with_indirect_questions(reading: Reading, tree: DependencyTree, known: FramedLexicon) -> Reading:
    """Return a reading whose messages have the frames of the questions in them; others stay as they are.

    The words of a message are quoted: they have no structure, and the patterns of questions need none.
    """
    arguments = tuple(_with_question(argument, tree, known) for argument in reading.arguments)
    return reading if arguments == reading.arguments else replace(reading, arguments=arguments)


def _with_question(argument: TypedArgument, tree: DependencyTree, known: FramedLexicon) -> TypedArgument:
    frames = tuple(
        (_read(frame, tree, known) or frame)
        if frame.role == "says" and frame.mood == _QUESTION and not frame.frame_name
        else frame
        for frame in argument.frames
    )
    return argument if frames == argument.frames else replace(argument, frames=frames)


def _read(said: EmbeddedFrame, tree: DependencyTree, known: FramedLexicon) -> Optional[EmbeddedFrame]:
    """Return the frame of the first pattern that has all words; None if no pattern has."""
    words = said.words.rstrip(" .?!")
    lemmas = {word.form.lower(): word.lemma.lower() for word in tree.words}
    for unit in known.lexicon.question_units:
        for pattern in unit.questions:
            match = compiled(pattern.text).fullmatch(words.lower())
            if match is None:
                continue
            elements = [
                _argument(name, words[match.start(name) : match.end(name)], lemmas)
                for name, _ in pattern.slots
                if match.group(name) is not None
            ]
            return replace(said, frame_name=unit.frame_name, frame_elements=tuple(elements))
    return None


def _argument(name: str, words: str, lemmas: Mapping[str, str]) -> TypedArgument:
    """Return the argument of an element: the preposition in front is its relation, the last word its head."""
    spoken, bare = _divided(words.split())
    text = " ".join(bare)
    noun = without_determiner(text)
    head = noun.split()[-1] if noun else text
    lemma = lemmas.get(head.lower(), head.lower())
    return TypedArgument(
        name=name,
        text=text,
        words=words,
        head=head,
        lemma=lemma,
        is_plural=lemma != head.lower(),
        relation=shipped_meanings().relation(spoken) if spoken else "",
    )


def _divided(words: Sequence[str]) -> Tuple[str, List[str]]:
    for count in range(min(4, len(words) - 1), 0, -1):
        spoken = " ".join(words[:count]).lower()
        if spoken in PREPOSITIONS:
            return spoken, list(words[count:])
    return "", list(words)
