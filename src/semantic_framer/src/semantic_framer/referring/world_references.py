"""Finds what the arguments of a reading refer to, and asks which of several things is meant."""

from dataclasses import dataclass, replace
from typing import List, Optional, Tuple

from referring_expressions import Referents, Situation, question_of, resolve, with_referents
from referring_expressions.describing import noun_of, question_of_speaker
from referring_expressions.fitting import is_speaker_asked_for
from referring_expressions.resolving import ALL, MOST_REFERENTS
from semantic_framer.referring.references import part_of_text
from semantic_framer.units.frame_roles import MESSAGE, NAME, NO_THINGS, PLACES
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.dialogue import PRONOUNS, Context, Mention
from semantic_framer.values.reading import Reading
from semantic_frames.frame import FrameElement
from typed_arguments import Source, TypedArgument
from word_classes import word_class

#: Things that are remembered as spoken of.
MOST_SPOKEN_OF = 8
#: Elements that hold no thing, although persons may be in some of them.
_NO_REFERENTS = (NO_THINGS | {MESSAGE, NAME, "Time", "State", "Topic", "Category"}) - {
    "Recipient",
    "Beneficiary",
    "Addressee",
    "Agent",
}
_PRONOUNS = word_class("pronouns") | word_class("here_and_there")
_PERSONS = word_class("pronouns_of_persons")
_STANDINS = word_class("noun_standins")
#: Quantifiers of one thing of a kind, which is the one that was spoken of from then on.
_ONE_OF_A_KIND = frozenset(["a", "another"])
#: Quantifiers that do not say which things are meant.
_SOME = word_class("quantifiers_of_some")


@dataclass(frozen=True)
class Unclear:
    """An argument that may refer to several things.

    Attributes:
        element: its frame element
        ids: of the things
        question: which of them is meant
    """

    element: str
    ids: Tuple[str, ...]
    question: str


def refer(reading: Reading, known: FramedLexicon, context: Context) -> Tuple[Reading, Optional[Unclear]]:
    """Return a reading whose arguments have referents, and what a person must be asked first; None for nothing."""
    if not known.world.objects:
        return reading, None
    frame = known.frames[reading.unit.frame_name]
    situation = known.situation(context.ids_spoken_of)
    arguments: List[TypedArgument] = []
    unclear: Optional[Unclear] = None
    for argument in reading.arguments:
        if argument.referents or not _may_refer(frame.element(argument.name), argument):
            arguments.append(argument)
            continue
        meant = _antecedent(argument, context)
        if meant is not None:
            arguments.append(_like(argument, meant, situation))
            continue
        found = resolve(argument, situation)
        is_open = found is not None and (found.is_ambiguous or is_speaker_asked_for(argument, situation, found.objects))
        if found is not None and found.objects and is_open and not frame.is_question:
            unclear = unclear or _unclear(argument, found, situation)
        arguments.append(argument if is_open else with_referents(argument, situation))
    return replace(reading, arguments=tuple(arguments)), unclear


def _antecedent(argument: TypedArgument, context: Context) -> Optional[TypedArgument]:
    """Return the phrase that a resolved pronoun stands for: "the fridge" for "it"; None if there is no such phrase."""
    if argument.source is not Source.INFERRED or argument.members:
        return None
    for thing in [*context.things, *([context.place] if context.place is not None else [])]:
        if len(thing.phrases) != 1:
            continue
        (phrase,) = thing.phrases
        if thing.text == argument.text:
            is_one = phrase.quantifier in _ONE_OF_A_KIND and not phrase.is_plural
            return replace(phrase, quantifier="the") if is_one else phrase
        if argument.count and argument.text.endswith(part_of_text("", thing.text)):
            return replace(phrase, quantifier="any", count=argument.count)
    return None


def _like(argument: TypedArgument, meant: TypedArgument, situation: Situation) -> TypedArgument:
    """Return a pronoun with the referents of what it stands for; with none where those are not certain."""
    argument = replace(argument, world_version=situation.world.version)
    found = _as_it_is_now(meant, situation)
    # "Three apples" are some of those that are known; a part of them may be any.
    is_open = meant.quantifier in _SOME if meant.count is None else not meant.quantifier
    is_certain = found is not None and not found.is_ambiguous and not is_open
    if found is None or not is_certain or is_speaker_asked_for(meant, situation, found.objects):
        return argument
    return replace(argument, referents=found.ids[:MOST_REFERENTS], referent_count=found.count)


def _as_it_is_now(phrase: TypedArgument, situation: Situation) -> Optional[Referents]:
    """Return what was meant by a phrase that was said before: the same things, wherever they are by now.

    "The apple on the table", of which the robot knew nothing then, is still that apple when it has taken it away.
    """
    known = situation.objects(phrase.referents)
    if known and len(known) == len(phrase.referents) and phrase.referent_count in (ALL, len(known)):
        return Referents(known, phrase.referent_count)
    found = resolve(phrase, situation)
    if found is None or found.objects or not phrase.frames:
        return found
    moved = resolve(replace(phrase, frames=()), situation)
    if moved is None or not moved.is_ambiguous:
        return moved
    handled = tuple(one for one in moved.objects if one.related("held_by"))
    return Referents(handled, 1) if len(handled) == 1 else Referents()


def unknown_arguments(reading: Reading, known: FramedLexicon) -> Tuple[TypedArgument, ...]:
    """Return the arguments whose words refer to nothing that the robot knows, after :func:`refer`."""
    frame = known.frames[reading.unit.frame_name]
    return tuple(
        argument
        for argument in reading.arguments
        if argument.world_version and not argument.referents and argument.text.lower() not in _PRONOUNS
        if _may_refer(frame.element(argument.name), argument)
    )


def _may_refer(element: Optional[FrameElement], argument: TypedArgument) -> bool:
    if element is None or element.quantity is not None or element.values or not argument.positions:
        return False
    return element.framenet not in _NO_REFERENTS and not any(frame.role == "says" for frame in argument.frames)


def _unclear(argument: TypedArgument, found: Referents, situation: Situation) -> Unclear:
    if is_speaker_asked_for(argument, situation, found.objects):
        return Unclear(argument.name, found.ids, question_of_speaker(found.objects, situation.world))
    noun = noun_of(found.objects[0]) if argument.lemma in _STANDINS else argument.head
    return Unclear(argument.name, found.ids, question_of(noun, found.objects, situation.world))


def spoken_of(reading: Reading, known: FramedLexicon, context: Context) -> Context:
    """Return a context that remembers what a reading refers to, things before places.

    What is not known is remembered, too: "it" does not refer to what was spoken of before it.
    """
    if not known.world.objects:
        return context
    frame = known.frames[reading.unit.frame_name]
    things: List[Mention] = []
    places: List[Mention] = []
    for argument in reading.arguments:
        element = frame.element(argument.name)
        if not _may_refer(element, argument) or element is None or argument.head.lower() in _PERSONS:
            continue
        mention = Mention(phrase=argument)
        if len(argument.referents) == 1 and argument.referent_count == 1:
            mention = Mention(argument.referents[0])
        elif argument.head.lower() in PRONOUNS and context.spoken_of:
            # It is still what it was, whatever that is.
            mention = context.spoken_of[0]
        (places if element.framenet in PLACES else things).append(mention)
    mentions = [*things, *(mention for mention in places if mention.id)]
    rest = [mention for mention in context.spoken_of if mention not in mentions]
    return replace(context, spoken_of=tuple([*mentions, *rest][:MOST_SPOKEN_OF]))


def looked_up_again(context: Context, known: FramedLexicon) -> Context:
    """Return a context in which the things have ids that were spoken of before the robot knew which they are.

    "Take the red mug", said of a mug that it has never seen, is about the red mug that it knows by now. Of several
    that fit, it is the one that it has taken.
    """
    if not context.spoken_of:
        return context
    mentions: List[Mention] = []
    # The oldest first: each may refer to those before it.
    for mention in reversed(context.spoken_of):
        if mention.phrase is not None and mention.phrase.world_version != known.world.version:
            before = tuple(one.id for one in mentions)
            mention = _looked_up(mention.phrase, known.situation(before))
        mentions.insert(0, mention)
    return replace(context, spoken_of=tuple(mentions))


def _looked_up(phrase: TypedArgument, situation: Situation) -> Mention:
    found = _as_it_is_now(phrase, situation)
    if found is None or found.count != 1:
        return Mention(phrase=phrase)
    held = situation.world.held
    fitting = found.objects if len(found.objects) == 1 else [one for one in found.objects if one in held]
    if len(fitting) == 1:
        return Mention(fitting[0].id)
    return Mention(phrase=replace(phrase, world_version=situation.world.version))
