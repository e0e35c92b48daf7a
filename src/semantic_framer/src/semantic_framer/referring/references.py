"""Resolves pronouns, and remembers what later pronouns may refer to."""

from dataclasses import replace
from itertools import takewhile
from typing import AbstractSet, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

from phrase_meanings.arguments import of_same_kind, resolved
from phrase_meanings.head_words import ONES
from roboframenet_ros.spoken_text import join_with_and
from semantic_framer.referring.kinds_spoken_of import (
    is_one_in_order,
    is_one_more,
    is_some,
    number_alone,
    of_the_same_kind,
    so_many,
)
from semantic_framer.referring.persons_spoken_of import PERSON, persons_meant, persons_mentioned
from semantic_framer.units.frame_roles import CONTAINER, CONTENTS, COTHEME, NO_THINGS, PLACES, SAID, THINGS, part_of
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.type_fits import accepted_types
from semantic_framer.values.dialogue import DEMONSTRATIVES, PLACE_PRONOUNS, PRONOUNS, Context, Thing
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from semantic_frames.frame import SemanticFrame
from semantic_frames.semantic_type import with_parents
from semantic_types import Fit, WordTypes
from typed_arguments import TypedArgument
from utterance_passes.phrases.clauses import Clause
from utterance_passes.trees.persons import is_person
from utterance_passes.trees.tree import VERBS, Word
from utterance_passes.trees.tree_edits import TreeEdit
from word_classes import word_class

_PARTICIPANTS = word_class("participants")
#: By the part of an element: the types of things into which others are put.
_TYPES_OF_WHAT_HOLDS = {"Device": ["Device"], CONTAINER: ["Container", "Portal", "Device"]}
_PERSONS = frozenset(["Sentient"])
_PERSONS_TYPES = with_parents(PERSON)
_HERE_AND_THERE = word_class("here_and_there")
_PLACE_PREPOSITIONS = word_class("place_prepositions")
_PREPOSITIONS = _PLACE_PREPOSITIONS | word_class("from_prepositions") | frozenset(["of", "with"])
_THEM = word_class("pronouns_of_persons_or_things")
_ROBOTS = word_class("robot_names")
_OF = "of"
#: Words before a noun that are left out when a part of it is meant: "one of the cups" for "some cups".
_BEFORE_PARTS = word_class("determiners_of_all") | word_class("indefinite_articles") | frozenset(["of"])
_DETERMINERS = word_class("determiners_and_possessives")
_DEFINITE = _DETERMINERS - word_class("indefinite_articles")
_QUESTION_WORDS = word_class("question_words")
_ASKING = _QUESTION_WORDS | {"many", "much"}
_BEFORE_NOUNS = ("ADJ", "ADV", "DET", "NOUN", "NUM", "PRON")
_PARTS_OF_NOUNS = ("compound", "nmod:poss", "flat")
_SAME = frozenset(["the same", "the same thing"])
_SIDES = word_class("left_and_right")
_PARTS = word_class("sides") - _SIDES
#: "Where *he* wants to sit" names a place; "where my keys are" is about the keys.
_WHERE = "where "
_WHEREABOUTS = word_class("verbs_of_whereabouts")
_WHOLE = word_class("determiners_of_all")
_PLURAL = word_class("plural_pronouns")
#: FrameNet's names of elements for how something is.
_STATES = frozenset(["State", "Operational_state"])
_SOUND_SOURCE = "Sound_source"
#: Relations of a place to what is put into it.
_INSIDE = word_class("prepositions_of_containers")


def resolve(reading: Reading, context: Context, known: FramedLexicon) -> Union[Reading, TypedArgument]:
    """Resolve the pronouns of a reading; return the value of the first pronoun that cannot be resolved."""
    values = []
    frame = known.frames[reading.unit.frame_name]
    context = without_named_beside(reading, context)
    things = context.things
    place = context.place
    container = _container_meant(reading, things, known.types)
    if container is not None and len(things) > 1:
        # "Take the spoon, open the box and put it in there."
        place, things = container, tuple(thing for thing in things if thing != container)
    kind = things[0].phrases[0] if things and things[0].phrases else None
    for value in reading.arguments:
        element = frame.element(value.name)
        amount, word = _pronoun_in(value.text.lower())
        relation = next((relation for relation in reading.unit.relations if relation.name == value.name), None)
        # "This place" is meant literally. If a unit lists only pronouns, it asks for their referents. "Them" who get
        # something are persons, and only things and places are remembered.
        is_listed = relation is not None and word in relation.words and not PRONOUNS.issuperset(relation.words)
        is_fixed = is_listed or (relation is not None and relation.is_for_persons)
        is_fixed = is_fixed or (element is not None and word in _THEM and frozenset(element.semantic_types) == _PERSONS)
        if word in PRONOUNS - DEMONSTRATIVES and value.positions and not is_fixed:
            # "Go near the radio and switch it on": a place may also be a thing.
            accepted = accepted_types(reading, value.name, frame)
            part = part_of(element.framenet) if element else ""
            # "What is on the table?" "Put it all on the shelf.": not the table.
            # "The front of it" is a part of a place, too.
            is_of_several = value.text.lower() != word and amount not in _PARTS
            is_thing = place is not None and not place.is_asked_about and not is_of_several
            possible = things if _PERSONS_TYPES.intersection(accepted) or not accepted else _without_persons(things)
            # "Them", of whom only persons were named, are no place either.
            is_place = is_thing and (word not in _THEM or bool(possible) or not things)
            meant = _meant_by(word, possible, place if is_place else None, accepted, part, known.types)
            is_followed = element is not None and element.framenet == COTHEME and word in _THEM
            if is_followed and context.persons and (meant is None or _is_lifeless(meant, known.types)):
                # "Give Bob the cup and Anna the plate, then follow *them*": neither cup nor plate.
                value = next(iter(persons_meant(value, context.persons)), value)
            elif meant is not None:
                text = part_of_text(amount, meant.text) if amount else meant.text
                value = resolved(value, text, () if amount else meant.phrases)
            elif value.text.lower() not in _WHOLE:
                return value
        elif word in PLACE_PRONOUNS and not is_fixed and place is not None:
            value = resolved(value, place.text, place.phrases)
        elif persons := persons_meant(value, context.persons):
            if len(persons) > 1:
                return value
            value = persons[0]
        elif (like := _contrasted(value, reading)) is not None:
            value = of_same_kind(value, like)
        elif things and element is not None and element.framenet not in CONTENTS and is_one_more(value):
            if is_one_in_order(value) and len({thing.noun for thing in things}) > 1:
                return value
            value = of_the_same_kind(value, kind) if kind is not None else value
        elif kind is not None and element is not None and element.framenet in THINGS:
            count = number_alone(value)
            value = so_many(value, count or None, kind) if count or is_some(value) else value
        values.append(value)
    return reading if tuple(values) == reading.arguments else replace(reading, arguments=tuple(values))


def without_named_beside(reading: Reading, context: Context) -> Context:
    """Return the context without what a reading names itself: in "bring *them* to Anna", they are not Anna."""
    named = {value.text.lower() for value in reading.arguments if value.positions}
    return replace(
        context,
        things=tuple(thing for thing in context.things if thing.text.lower() not in named),
        persons=tuple(person for person in context.persons if person.text.lower() not in named),
    )


def _without_persons(things: Iterable[Thing]) -> Tuple[Thing, ...]:
    """Return what can be carried, washed or opened: of "Bob" and "the cup" the cup."""
    return tuple(
        thing
        for thing in things
        if not thing.phrases or any(phrase.semantic_type != PERSON for phrase in thing.phrases)
    )


def _contrasted(value: TypedArgument, reading: Reading) -> Optional[TypedArgument]:
    """Return the described thing before "one" in the same deed, of whose kind it is: "compare *the red cup* with the
    blue one". None if there is none, or "one" is not described."""
    before = [
        other
        for other in reading.arguments
        if value.positions and other.positions and max(other.positions) < min(value.positions)
        if other.modifiers and other.head.lower() not in ONES and other.semantic_type != "Human"
    ]
    is_described = is_one_more(value) and any(modifier.kind == "adjective" for modifier in value.modifiers)
    return max(before, key=lambda other: max(other.positions)) if before and is_described else None


def _pronoun_in(text: str) -> Tuple[str, str]:
    """Return how many of them a phrase names, and its pronoun: "one", "them" for "one of them".

    Nothing stands before the pronoun when all are meant: "all of them", "them both", "both". "The same" is what was
    spoken of. A phrase without a pronoun is returned whole.
    """
    words = text.split()
    if words[:-1] and set(words[1:]) <= _WHOLE and words[0] in PRONOUNS:
        return "", words[0]
    # "The left of it" is beside it, and no part of it.
    if len(words) > 2 and words[-2] == _OF and words[-1] in PRONOUNS and not _SIDES & set(words):
        amount = " ".join(words[:-2])
        return "" if amount in _WHOLE else amount, words[-1]
    if text in _WHOLE:
        return "", "them"
    return "", "it" if text in _SAME else text


def part_of_text(amount: str, whole: str) -> str:
    """Return the words for a part of what was mentioned: "one of the cups" for "one" and "all cups"."""
    words = whole.split()
    while words[1:] and words[0].lower() in _BEFORE_PARTS:
        words = words[1:]
    is_definite = words[0].lower() in _DEFINITE or words[0][:1].isupper()
    return " ".join([amount, _OF, *([] if is_definite else ["the"]), *words])


def _container_meant(reading: Reading, things: Sequence[Thing], types: WordTypes) -> Optional[Thing]:
    """Return the last container mentioned, if something is put into one: "put it in there"; None otherwise."""
    spoken = {value.text.lower(): value for value in reading.arguments if value.positions}
    places = [spoken[word] for word in PLACE_PRONOUNS & set(spoken)]
    if not (PRONOUNS - DEMONSTRATIVES) & set(spoken) or all(place.relation not in _INSIDE for place in places):
        return None
    return next((one for one in things if types.of_noun([one.noun]).fit(["Container"]) is Fit.LIKELY), None)


def _meant_by(
    pronoun: str,
    things: Sequence[Thing],
    place: Optional[Thing],
    accepted: Sequence[str],
    part: str,
    types: WordTypes,
) -> Optional[Thing]:
    """Return what "it" or "them" stands for, a thing of that number if there is one.

    None if nothing was mentioned, or a thing was told of behind one with which something was done: "take the cup, tell
    Bob that the plate is dirty and wash *it*".
    """
    is_plural = pronoun in _PLURAL
    of_number = [one for one in things if one.is_plural is is_plural]
    thing = _thing_meant(of_number or things, accepted, part, types)
    if thing is not None and thing.is_only_told_of:
        done = [one for one in of_number if not one.is_only_told_of]
        if any(not accepted or types.of_noun([one.noun]).fit(accepted) is not Fit.WRONG for one in done):
            return None
    wanted = _TYPES_OF_WHAT_HOLDS.get(part, ())
    if not is_plural and _is_rather_there(place, thing if of_number else None, wanted, types):
        return place
    if is_plural and not of_number and thing is not None:
        both = _together(things, thing)
        # "Stack the tin on the crate and put *them* in the tray": the crate may be one of them.
        return None if both is thing and place is not None else both
    return thing or place


def _is_lifeless(thing: Thing, types: WordTypes) -> bool:
    """Whether a thing is no living being; "Bob" is none of the nouns of that spelling."""
    named = (phrase.semantic_type for phrase in thing.phrases if phrase.semantic_type)
    is_alive = any(with_parents(semantic_type) >= _PERSONS for semantic_type in named)
    return not is_alive and types.of_noun([thing.noun]).fit(["Sentient"]) is Fit.WRONG


def _together(things: Sequence[Thing], last: Thing) -> Thing:
    """Return all things that were mentioned one after the other, up to the last one: "take the cup, take the plate and
    bring *them* here". What was only opened or switched on is none of them."""
    until = things[things.index(last) :]
    alike = [*takewhile(lambda one: one.role == last.role or one.role not in _TYPES_OF_WHAT_HOLDS, until)][::-1]
    if len(alike) < 2 or not all(one.phrases for one in alike):
        return last
    return Thing(
        join_with_and(one.text for one in alike),
        last.noun,
        last.role,
        is_plural=True,
        phrases=tuple(phrase for one in alike for phrase in one.phrases),
    )


def _is_rather_there(place: Optional[Thing], thing: Optional[Thing], wanted: Sequence[str], types: WordTypes) -> bool:
    """Whether a place has one of some types and a thing has none: "put the sample into the centrifuge and start it",
    "put the milk in the fridge and close it"."""
    # "Part number 7" is a part: any of its words may say what it is.
    of_thing = [types.of_noun([word]).fit(wanted) for word in noun_phrase(thing.text if thing else "")]
    is_no_such_thing = all(fit in (Fit.WRONG, Fit.UNKNOWN) for fit in of_thing)
    if place is None or not wanted or not is_no_such_thing:
        return False
    return types.of_noun(noun_phrase(place.text)[-1:]).fit(wanted) is Fit.LIKELY


def noun_phrase(text: str) -> List[str]:
    """Return the words of a noun phrase, in lower case, without the phrases behind it: "the", "biscuits" of "the
    biscuits on the shelf"."""
    words = text.lower().split()
    end = next((place for place, word in enumerate(words) if place and word in _PREPOSITIONS), len(words))
    return words[:end]


def _thing_meant(things: Sequence[Thing], accepted: Sequence[str], part: str, types: WordTypes) -> Optional[Thing]:
    """Return the thing that a pronoun stands for: the last one mentioned that may have one of some types.

    A thing of another kind gives way to one that had the same part before: "open the fridge, take the milk out and
    close *it*". So does what was opened or closed to what was moved: "... close it and bring *it* to me". If none may
    have the types, the last one is meant; None if nothing was mentioned.
    """
    likelihoods = {one.noun: types.of_noun([one.noun]) for one in things}
    fitting = [one for one in things if not accepted or likelihoods[one.noun].fit(accepted) is not Fit.WRONG] or things
    last = next(iter(fitting), None)
    is_like = part or (last is not None and last.role == CONTAINER)
    before = next((one for one in fitting if is_like and one.role == part), last)
    if last is None or before is None or likelihoods[last.noun].likeliest() == likelihoods[before.noun].likeliest():
        return last
    return before


def thing_told(sentence: Sentence, told: Iterable[Clause]) -> Optional[Thing]:
    """Return the only thing that statements around a command are about, which a pronoun of the command stands for: "I
    can't reach *the biscuits*, get them for me". None if there is none, or more than one.

    Args:
        sentence: the sentence
        told: its clauses that ask for nothing
    """
    things = [
        word
        for clause in told
        for word in map(sentence.word, sorted(clause.positions))
        if word.deprel.split(":")[0] in ("nsubj", "obj") and word.upos == "NOUN" and not is_person(word)
    ]
    if len(things) != 1:
        return None
    phrase = _with_place_told(sentence, things[0]).phrases.argument("", things[0].index)
    return Thing(
        _inside_a_sentence(phrase.text), things[0].lemma.lower(), is_plural=phrase.is_plural, phrases=(phrase,)
    )


def _with_place_told(sentence: Sentence, thing: Word) -> Sentence:
    """Return the sentence with the place that a statement tells attached to its thing: "I left my keys *in the
    kitchen*, bring them"."""
    verb = sentence.tree.governor(thing)
    edit = TreeEdit(sentence.tree)
    behind = sentence.tree.phrase_end(thing.index) + 1
    for place in sentence.children(verb.index) if verb.lemma.lower() in _WHEREABOUTS else ():
        positions = sentence.subtree(place.index)
        says_where = bool(_PLACE_PREPOSITIONS.intersection(sentence.tree.said_prepositions(place.index)))
        is_time = any(place.index in time for time in sentence.tree.times)
        if place.deprel == "obl" and min(positions) == behind and says_where and not is_time:
            edit.rehang(place.index, thing.index, "nmod")
    tree = edit.tree()
    return sentence if tree is sentence.tree else sentence.attached(tree)


def thing_said(said: TypedArgument, sentence: Sentence) -> Optional[Thing]:
    """Return the thing that a clause to be said or found out is about, its subject or what it asks for; None if it is
    no thing, or there is no clause.

    Args:
        said: the words of the clause: "where *my keys* are", "how many *cups* he needs", "*what he wants*"
        sentence: the sentence; what is quoted has lost its relations there, so only the order of words counts
    """
    if said.words not in sentence.tree.text:
        return None  # It is of an earlier sentence, about which something was asked.
    words = [sentence.word(position) for position in said.positions if 0 < position <= len(sentence.tree.words)]
    before = [*takewhile(lambda word: word.upos not in VERBS, words)]
    if words and words[0].said == "what" and len(before) < len(words) and all(map(_is_pronoun, before)):
        return Thing(said.text, "what", is_only_told_of=True)
    nouns = [word for word in before if word.upos == "NOUN" and word.deprel not in _PARTS_OF_NOUNS]
    if len(before) == len(words) or not nouns or is_person(nouns[-1]) or not _ends_phrase(nouns[-1], before):
        return None
    noun = nouns[-1]
    named = [*takewhile(lambda word: word.upos in _BEFORE_NOUNS, reversed(before[: before.index(noun)]))][::-1]
    asked = [place for place, word in enumerate(named) if word.said in _ASKING]
    named = named[max(asked, default=-1) + 1 :]
    text = sentence.text([word.index for word in [*named, noun]])
    if asked and not (named and named[0].upos in ("DET", "PRON")):
        text = f"the {text}"
    is_plural = noun.xpos in ("NNS", "NNPS")
    phrase = TypedArgument(text=text, head=noun.form, lemma=noun.lemma.lower(), is_plural=is_plural)
    return Thing(text, noun.lemma.lower(), is_plural=is_plural, phrases=(phrase,), is_only_told_of=True)


def _is_pronoun(word: Word) -> bool:
    return word.upos in ("PRON", "PROPN")


def _ends_phrase(noun: Word, before: Iterable[Word]) -> bool:
    behind = [word for word in before if word.index > noun.index]
    return all(word.upos in ("PRON", "ADV", "PROPN") for word in behind)


def _inside_a_sentence(text: str) -> str:
    """Return a phrase as it is written inside a sentence: "the cup" for "*The* cup is on the table"."""
    first, space, rest = text.partition(" ")
    return f"{first.lower()}{space}{rest}" if first.lower() in _DETERMINERS else text


def remember(reading: Reading, sentence: Sentence, frames: Mapping[str, SemanticFrame], context: Context) -> Context:
    """Remember the things, the place and the persons that a reading mentions."""
    frame = frames[reading.unit.frame_name]
    context = _remember(frame, reading.arguments, frames, context)
    for value in reading.arguments:
        element = frame.element(value.name)
        if element is None or element.framenet not in SAID:
            continue
        said = thing_said(value, sentence)
        if said is not None:
            context = context.with_thing(said)
        elif value.text.lower().startswith(_WHERE):
            context = replace(context, place=Thing(value.text, "where"))
    return context.with_persons(persons_mentioned(reading.arguments, sentence))


def _asks_what_is_there(frame: SemanticFrame, filled: AbstractSet[str]) -> bool:
    """Whether a question names a place, and asks for the thing there."""
    open_roles = {element.framenet for element in frame.frame_elements if element.name not in filled}
    named_roles = {element.framenet for element in frame.frame_elements if element.name in filled}
    return PLACES.issuperset(named_roles) and not THINGS.isdisjoint(open_roles)


def _remember(
    frame: SemanticFrame, arguments: Sequence[TypedArgument], frames: Mapping[str, SemanticFrame], context: Context
) -> Context:
    # "What is on the table?" "Bring it to me.": what is there, not the table.
    filled = {one.name for one in arguments if one.positions}
    is_asked_about = frame.is_question and _asks_what_is_there(frame, filled)
    # The object is spoken of further, and not what a preposition adds to it: "fill the glass with water and bring it".
    for value in sorted(arguments, key=lambda one: not one.relation):
        element = frame.element(value.name)
        if element is None or not value.positions or element.quantity is not None:
            continue
        if element.framenet in CONTENTS:
            # "See if the mail has arrived and bring it": what is said is no thing, but it is about one.
            for said in value.frames:
                if said.frame_name in frames:
                    context = _remember(frames[said.frame_name], said.frame_elements, frames, context)
            continue
        if value.text.lower().partition(" ")[0] in _QUESTION_WORDS:
            continue  # "How many": it asks for a thing, and is none.
        if value.text.lower() in _HERE_AND_THERE:
            continue  # "Put the cup here and the plate there": "there" is another place than "here".
        if (element.framenet == "Category" and not value.quantifier) or element.framenet in _STATES:
            continue  # "The floor is dirty, clean it": dirty is no thing.
        if frame.is_condition and (value.semantic_type == "Human" or value.lemma in _ROBOTS):
            continue  # "If Bob is at the door, open it": Bob is no thing.
        # "Wash the cup": what is washed is the source of the dirt, and a thing.
        is_thing = value.semantic_type and not value.relation and "Location" not in with_parents(value.semantic_type)
        # "When the bell rings, go to the door and open it": what is gone to counts for more.
        if (element.framenet in PLACES and not is_thing) or (frame.is_condition and element.framenet == _SOUND_SOURCE):
            text = _inside_a_sentence(value.text)
            place = Thing(text, value.lemma, phrases=(value,), is_asked_about=is_asked_about)
            context = replace(context, place=place)
        elif element.framenet not in NO_THINGS and value.text.lower() not in _PARTICIPANTS:
            is_plural = value.is_plural or bool(value.members) or (value.count or 1) > 1
            text = _inside_a_sentence(value.text)
            thing = Thing(text, value.lemma, part_of(element.framenet), is_plural, value.members or (value,))
            context = context.with_thing(thing)
    return context
