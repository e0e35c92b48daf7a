"""Finds the elements of the last command that the phrases of a fragment fill.

A noun phrase without a preposition replaces what was said for an element of its type: "the office" after "go to the
kitchen". Other phrases are read behind the verb of the command ("ten feet" as "move ten feet"), by the lexical units
of its frame.
"""

from dataclasses import replace
from functools import cached_property
from typing import FrozenSet, List, Optional, Tuple

from phrase_meanings.arguments import of_same_kind, resolved
from phrase_meanings.head_words import ONES, property_alone
from semantic_framer.clauses.fragments import Fragment
from semantic_framer.filling.matching import match_units
from semantic_framer.referring.kinds_spoken_of import so_many
from semantic_framer.referring.references import noun_phrase
from semantic_framer.units.frame_roles import THINGS
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.type_fits import with_types
from semantic_framer.values.dialogue import DEMONSTRATIVES, PRONOUNS
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from semantic_frames.frame import FrameElement, SemanticFrame
from semantic_frames.roles import filler_of
from semantic_frames.semantic_type import with_parents
from semantic_types import Fit
from spoken_quantities.numbers import find_whole_number
from typed_arguments import Source, TypedArgument
from typed_arguments.positions import with_moved_positions
from utterance_passes.phrases.clauses import find_clauses
from utterance_passes.phrases.measures import find_amounts
from utterance_passes.phrases.verb_matching import match_verbs
from utterance_passes.trees.persons import is_person, is_person_or_name
from utterance_passes.trees.tree_edits import behind_verb as put_behind_verb
from word_classes import word_class

#: Types with much in common.
_ALIKE = (("Sentient",), ("Location",), ("Physical_object", "Substance"), ("Information",))
_HEARERS = word_class("hearers")
_NOMINAL = ("NOUN", "PROPN", "PRON", "NUM", "X")
_PERSONS = word_class("pronouns_of_persons")
_PLACE_PREPOSITIONS = word_class("place_prepositions")


class FragmentPhrases:
    """The phrases of a fragment, beside one reading of the last command."""

    def __init__(self, fragment: Fragment, sentence: Sentence, reading: Reading, known: FramedLexicon) -> None:
        self._fragment = fragment
        self._sentence = sentence
        self._tree = sentence.tree
        self._reading = reading
        self._known = known
        self._frame: SemanticFrame = known.frames[reading.unit.frame_name]

    def replaced(self) -> Tuple[TypedArgument, ...]:
        """Return the noun phrase of the fragment, in the place of what was said for an element; nothing if the fragment
        is none, or fits no element or several.
        """
        head = self._head()
        if not head or self._person_and_thing is not None:
            return ()
        named = property_alone(self._tree.word(head))
        is_one = named is not None or self._tree.word(head).said in ONES
        slots = [
            (argument, element)
            for argument in self._reading.arguments
            for element in [self._frame.element(argument.name)]
            if element is not None and self._is_noun_phrase(argument, element)
        ]
        if is_one:
            # "The red one" is what had a colour, or another property, before.
            slots = [slot for slot in slots if slot[0].text.lower() not in _PERSONS and slot[0].head]
            fitting = [slot for slot in slots if slot[0].modifiers] if len(slots) > 1 else slots
        else:
            near = [(self._nearness(head, *slot), slot) for slot in slots]
            best = max((nearness for nearness, _ in near), default=0)
            fitting = [slot for nearness, slot in near if nearness == best and nearness > 0]
            # "And now the plate" has no preposition, as the cup had none in "put the cup on the table".
            fitting = [slot for slot in fitting if not slot[0].relation] or fitting
        if len(fitting) != 1:
            return ()
        argument, _ = fitting[0]
        made = self._sentence.phrases.argument(argument.name, head, left_out=self._left_out())
        if is_one:
            made = of_same_kind(made, argument, named)
        elif len(made.positions) != len(self._fragment.positions):
            return ()
        made = replace(made, relation=argument.relation)
        typed = with_types([made], self._frame, self._sentence.types)
        return typed.arguments if is_one or not typed.wrong else ()

    def counted(self) -> Tuple[TypedArgument, ...]:
        """Return the only thing of the command, so many of it as the fragment says: "bring me a cup" - "*two*, please";
        nothing if it is no number alone, or the command has an amount or several things."""
        count = find_whole_number(self._tree.text_of(self._fragment.positions))
        things = [
            argument
            for argument in self._reading.arguments
            for element in [self._frame.element(argument.name)]
            if element is not None and element.framenet in THINGS and self._is_noun_phrase(argument, element)
        ]
        if not count or count < 0 or measured(self._reading, self._frame) or len(things) != 1:
            return ()
        made = self._sentence.phrases.argument(things[0].name, self._fragment.positions[-1], left_out=self._left_out())
        return (replace(so_many(made, count, things[0]), relation=things[0].relation),)

    def behind_same_preposition(self) -> Tuple[TypedArgument, ...]:
        """Return the phrase of the fragment in the place of that of a question with the same preposition: "who is
        *in the kitchen*?" - "and *in the office*?"; or of the one that says where, too. Nothing if there is none.
        """
        kept = frozenset(self._fragment.positions)
        tops = [index for index in kept if self._tree.word(index).head not in kept]
        cases = [said for index in tops for said in self._tree.said_prepositions(index)]
        phrases = [one for one in self._reading.arguments if one.relation]
        places = [one for one in phrases if frozenset([one.relation, *cases]) <= _PLACE_PREPOSITIONS]
        before = [one for one in phrases if [one.relation] == cases] or places
        if not self._frame.is_question or len(tops) != 1 or len(cases) != 1 or len(before) != 1:
            return ()
        made = self._sentence.phrases.argument(before[0].name, tops[0], left_out=self._left_out())
        return (replace(made, relation="".join(cases)),)

    def _head(self) -> int:
        """Return the head of a fragment that is one noun phrase without prepositions; 0 for others."""
        kept = frozenset(self._fragment.positions)
        tops = [index for index in self._fragment.positions if self._tree.word(index).head not in kept]
        if len(tops) != 1 or not (self._tree.word(tops[0]).upos in _NOMINAL or self._is_property(tops[0])):
            return 0
        # "The plate to the office" and "Ben the cup" are two phrases each.
        inside = [self._tree.word(index) for index in self._fragment.positions if index > tops[0]]
        is_in_phrase = any(
            word.deprel in ("case", "mark", "compound:prt")
            or (word.deprel == "det" and self._tree.governor(word).deprel != "conj")
            for word in inside
        )
        is_in_phrase |= any(child.index in kept for child in self._tree.prepositions(tops[0]))
        spoken = [index for index in self._fragment.positions if self._tree.word(index).upos != "PUNCT"]
        is_amount = any(
            amount.unit or len(spoken) == len(amount.positions) for amount in find_amounts(self._tree, spoken)
        )
        return 0 if is_in_phrase or (is_amount and self._tree.word(tops[0]).said not in ONES) else tops[0]

    def _is_property(self, head: int) -> bool:
        """Whether a fragment names a thing only by a property: "no, *the smallest*"."""
        said = [self._tree.word(index).said for index in self._fragment.positions]
        return property_alone(self._tree.word(head)) is not None and said[0] == "the" and len(said) == 2

    @cached_property
    def _person_and_thing(self) -> Optional[Tuple[int, int]]:
        """Return the heads of two phrases in a row, a person and what the person gets: "and *Bob* a *tea*"; None if
        there are not both.
        """
        for before, first in zip(self._fragment.positions, self._fragment.positions[1:]):
            person, article = self._tree.word(before), self._tree.word(first)
            is_anybody = is_person_or_name(person) or person.said in _PERSONS
            if not is_anybody or not (article.upos == "DET" or article.deprel == "nmod:poss"):
                continue
            behind = [index for index in self._fragment.positions if index >= first]
            heads = [self._tree.word(index) for index in behind if self._tree.word(index).head not in behind]
            if len(heads) == 1 and heads[0].upos == "NOUN" and not is_person(heads[0]):
                return person.index, heads[0].index
        return None

    def _left_out(self) -> FrozenSet[int]:
        return frozenset(word.index for word in self._tree.words) - frozenset(self._fragment.positions)

    def _is_noun_phrase(self, argument: TypedArgument, element: FrameElement) -> bool:
        is_word_of_unit = any(
            relation.name == argument.name and argument.text.lower() in relation.words
            for relation in self._reading.unit.relations
        )
        is_unit = any(other.unit_element == element.name for other in self._frame.frame_elements)
        return not (
            argument.measure is not None
            or argument.source is Source.DEFAULT
            or argument.direction
            or element.quantity
            or element.values
            or is_word_of_unit
            or is_unit
            or argument.text.lower() in _HEARERS
        )

    def _nearness(self, head: int, argument: TypedArgument, element: FrameElement) -> int:
        """Return how near a noun phrase is to what was said for an element: 3 for the same type, 2 for types that have
        much in common, 1 if it fits the element, 0 if it cannot replace it.
        """
        types = self._sentence.types
        fit = types.fit(head, element.semantic_types) if element.semantic_types else Fit.UNKNOWN
        if fit is Fit.WRONG:
            return 0
        if not types.of(head).types:
            return 2
        # "It" has the type of what it stands for.
        said = argument.semantic_type or self._known.types.of_noun(noun_phrase(argument.text)[-1:]).likeliest()
        before = with_parents(said) if said else frozenset()
        if said and types.likeliest(head) == said:
            return 3
        if any(types.fit(head, kinds) is Fit.LIKELY for kinds in _ALIKE if before & frozenset(kinds)):
            return 2
        # Nearly everything fits what the role of an element takes.
        return 1 if fit is Fit.LIKELY and element.semantic_types != filler_of(element.framenet) else 0

    def behind_verb(self) -> Tuple[TypedArgument, ...]:
        """Return what the units of the frame make of the fragment behind their verb; nothing if words are left over."""
        amounts = find_amounts(self._tree, list(self._fragment.positions))
        unit = ""
        if amounts and not any(amount.unit for amount in amounts):
            unit = self._unit() if self._fragment.is_more or self._fragment.is_instead else ""
            if not unit:
                return ()
        verb = self._reading.verb.split()
        kept = frozenset(self._fragment.positions)
        tree = put_behind_verb(self._tree, verb, kept, unit, objects=self._person_and_thing)
        if not tree.is_connected:
            return ()
        sentence = Sentence(tree, self._known.types)
        shift, count = len(verb), len(self._tree.words)

        def moved(position: int) -> int:
            return position - shift if shift < position <= shift + count else 0

        for clause in find_clauses(tree, self._known)[:1]:
            for reading in match_units(sentence, clause, match_verbs(tree, clause, self._known), self._known):
                if reading.unit.frame_name != self._frame.name or reading.left_over or reading.wrong_types:
                    continue
                said = [one for one in reading.arguments if any(position > shift for position in one.positions)]
                if said and not reading.unread and not self._has_unlisted(sentence, reading):
                    return tuple(self._resolved(with_moved_positions(one, moved)) for one in said)
        return ()

    def _resolved(self, argument: TypedArgument) -> TypedArgument:
        """Return an argument with what "one" or "it" in it stands for: what was said for its element before."""
        before = self._reading.argument(argument.name)
        if before is None:
            return argument
        if argument.head.lower() in ONES:
            return of_same_kind(argument, before)
        # "Put the box on the table." "No, under it.": the table, because nothing is under itself.
        is_place = argument.relation and argument.text.lower() in PRONOUNS - DEMONSTRATIVES
        return resolved(argument, before.text) if is_place else argument

    def _has_unlisted(self, sentence: Sentence, reading: Reading) -> bool:
        """Whether an argument has more words than the unit lists for its element: "slowly and the cat"."""
        limited = {relation.name for relation in reading.unit.relations if relation.words}
        said = {
            index
            for one in reading.arguments
            if one.name in limited and one.head_position in reading.listed
            for index in one.positions
        }
        return any(sentence.is_content(index) for index in said - reading.listed)

    def _unit(self) -> str:
        """Return the unit of the amount in the last command; empty if it has none, or several."""
        found = measured(self._reading, self._frame)
        value = self._reading.argument(found[0].unit_element) if len(found) == 1 else None
        return value.text if value is not None else ""


def measured(reading: Reading, frame: SemanticFrame) -> List[FrameElement]:
    """Return the elements of a frame that have an amount in a reading."""
    filled = {argument.name for argument in reading.arguments}
    return [element for element in frame.frame_elements if element.quantity and element.name in filled]
