"""Reads the questions that a message asks, "tell me how many cups are on the table", as frames."""

from dataclasses import replace
from typing import List, Mapping, Optional, Sequence, Tuple

from phrase_meanings.meaning_file import shipped_meanings
from semantic_framer.kinds.question_orders import orders_of
from semantic_framer.kinds.question_words import PREPOSITIONS, compiled
from semantic_framer.units.frame_roles import MESSAGE, TELLING
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.reading import Reading
from typed_arguments import EmbeddedFrame, Modifier, TypedArgument
from utterance_passes.trees.tree import DependencyTree, Word
from word_classes import without_determiner, word_class

_QUESTION = "question"
#: By the tag of a word before a noun.
_KINDS_OF_MODIFIERS = {"JJ": "adjective", "JJR": "comparative", "JJS": "superlative"}
_WHETHER = tuple([word] for word in word_class("whether_words"))


def with_indirect_questions(reading: Reading, tree: DependencyTree, known: FramedLexicon) -> Reading:
    """Return a reading whose messages have the frames of the questions in them; others stay as they are.

    The words of a message are quoted: they have no structure, and the patterns of questions need none.
    """
    frame = known.frames[reading.unit.frame_name]
    messages = {one.name for one in frame.frame_elements if one.framenet == MESSAGE and frame.framenet == TELLING}
    arguments = tuple(
        (_with_what_is_told if argument.name in messages and not argument.frames else _with_question)(
            argument, tree, known
        )
        for argument in reading.arguments
    )
    return reading if arguments == reading.arguments else replace(reading, arguments=arguments)


def _with_what_is_told(argument: TypedArgument, tree: DependencyTree, known: FramedLexicon) -> TypedArgument:
    """Return a message with the question that it names without a verb: "tell me *the colour of the mug*"."""
    if argument.quantifier != "the":
        return argument
    read = _read(EmbeddedFrame(role="says", mood=_QUESTION, words=argument.text), tree, known)
    return argument if read is None else replace(argument, frames=(read,))


def _with_question(argument: TypedArgument, tree: DependencyTree, known: FramedLexicon) -> TypedArgument:
    frames = tuple(
        (_read(frame, tree, known) or frame)
        if frame.role == "says" and (frame.mood == _QUESTION or _forms(frame)[:1] in _WHETHER) and not frame.frame_name
        else frame
        for frame in argument.frames
    )
    return argument if frames == argument.frames else replace(argument, frames=frames)


def _read(said: EmbeddedFrame, tree: DependencyTree, known: FramedLexicon) -> Optional[EmbeddedFrame]:
    """Return the frame of the first pattern that has all words; None if no pattern has."""
    forms = _forms(said)
    lemmas = {word.form.lower(): word for word in tree.words}
    orders = [" ".join(forms[place] for place in order) for order in orders_of([form.lower() for form in forms])]
    return next((found for words in orders for found in [_fitted(said, words, lemmas, known)] if found), None)


def _fitted(
    said: EmbeddedFrame, words: str, lemmas: Mapping[str, Word], known: FramedLexicon
) -> Optional[EmbeddedFrame]:
    found: List[Tuple[int, int, EmbeddedFrame]] = []
    for unit in known.lexicon.question_units(words.lower().split()):
        for pattern in unit.questions:
            match = compiled(pattern.text).fullmatch(words.lower())
            if match is None:
                continue
            elements = tuple(
                _argument(name, words[match.start(name) : match.end(name)], lemmas)
                for name, _ in pattern.slots
                if match.group(name) is not None
            )
            inside = sum(len(element.words.split()) for element in elements)
            loose = sum(not kind for name, kind in pattern.slots if match.group(name) is not None)
            found.append((inside, loose, replace(said, frame_name=unit.frame_name, frame_elements=elements)))
    # "Who is in the kitchen" names a place, though a pattern for any words fits too.
    return min(found, key=lambda one: one[:2])[2] if found else None


def _forms(said: EmbeddedFrame) -> List[str]:
    return said.words.rstrip(" .?!").split()


def _argument(name: str, words: str, lemmas: Mapping[str, Word]) -> TypedArgument:
    """Return the argument of an element: the preposition in front is its relation, the last word before another
    preposition its head, and what follows is where it is.
    """
    spoken, bare = _divided(words.split())
    text = " ".join(bare)
    ends = next((place for place, word in enumerate(bare) if place and word.lower() in PREPOSITIONS), len(bare))
    where = " ".join(bare[ends:])
    noun = without_determiner(" ".join(bare[:ends]))
    head = noun.split()[-1] if noun else text
    lemma = lemmas[head.lower()].lemma.lower() if head.lower() in lemmas else head.lower()
    told = [lemmas[word.lower()] for word in noun.split()[:-1] if word.lower() in lemmas]
    return TypedArgument(
        name=name,
        text=text,
        words=words,
        head=head,
        lemma=lemma,
        is_plural=lemma != head.lower(),
        relation=shipped_meanings().relation(spoken) if spoken else "",
        modifiers=tuple(
            Modifier(_KINDS_OF_MODIFIERS[word.xpos], word.form, word.lemma)
            for word in told
            if word.xpos in _KINDS_OF_MODIFIERS
        ),
        frames=(EmbeddedFrame(role="describes", words=where, frame_elements=(_argument("location", where, lemmas),)),)
        if where
        else (),
    )


def _divided(words: Sequence[str]) -> Tuple[str, List[str]]:
    for count in range(min(4, len(words) - 1), 0, -1):
        spoken = " ".join(words[:count]).lower()
        if spoken in PREPOSITIONS:
            return spoken, list(words[count:])
    return "", list(words)
