"""Makes the arguments of a reading: which words belong to the phrase of each element, and which are left over."""

from dataclasses import replace
from typing import FrozenSet, List, Set, Tuple

from phrase_meanings.arguments import amount_argument, default_argument, unit_argument
from semantic_framer.filling.attachment import (
    has_postmodifiers,
    is_of_one_direction,
    is_of_something,
    is_part_of_used_name,
    is_postmodifier_of,
    is_right_behind,
    listed_particle,
    lost_directions,
    words_before,
    words_before_amount,
)
from semantic_framer.filling.default_values import is_said_otherwise, value_of_verb
from semantic_framer.filling.tried_unit import TriedUnit
from semantic_framer.units.frame_roles import DESCRIBED, MESSAGE
from semantic_framer.units.word_patterns import argument_of
from semantic_frames.frame import FrameElement
from typed_arguments import TypedArgument


class ElementArguments:
    """Makes the arguments of the elements of a unit, from what was found for them."""

    def __init__(self, tried: TriedUnit) -> None:
        self._tried = tried
        self._sentence = tried.sentence
        self._tree = tried.sentence.tree
        self._clause = tried.clause
        self._frame = tried.frame
        self._match = tried.match

    def arguments(self) -> Tuple[TypedArgument, ...]:
        """Return the arguments, in the order of the elements of the frame."""
        verb_words = frozenset(self._match.positions)
        amount_words = frozenset(position for amount in self._tried.amount_of.values() for position in amount.positions)
        amount_words |= frozenset(
            position
            for amount in self._tried.numeral_of.values()
            for position in amount.positions
            if position != amount.unit_position
        )
        found: List[TypedArgument] = []
        for element in self._frame.frame_elements:
            if element.name in self._tried.amount_of:
                amount = self._tried.amount_of[element.name]
                is_unit = any(other.unit_element == element.name for other in self._frame.frame_elements)
                found.append(
                    unit_argument(self._tree, element.name, amount)
                    if is_unit
                    else amount_argument(self._tree, element.name, amount, is_whole=not element.unit_element)
                )
                hedges = words_before_amount(self._tree, min(amount.positions))
                if not is_unit:
                    found[-1] = replace(found[-1], positions=tuple(sorted(hedges)) + found[-1].positions)
            elif element.name in self._tried.numeral_of:
                numeral = self._tried.numeral_of[element.name]
                found.append(amount_argument(self._tree, element.name, numeral, is_whole=False))
            elif element.name in self._tried.heads:
                head = self._tried.heads[element.name]
                others = [
                    subtree
                    for name, other in self._tried.heads.items()
                    if name != element.name and other != head
                    for subtree in [self._sentence.subtree(other)]
                    if head not in subtree
                ]
                left_out = verb_words | amount_words | frozenset().union(*others) | self._outside(head)
                relation = next(relation for relation in self._tried.unit.relations if relation.name == element.name)
                behind = self._places_behind(head, element, left_out)
                before = self._words_before(head, left_out)
                for rule, positions in (("places_behind", behind), ("words_before", before)):
                    if positions:
                        self._tried.note(
                            rule, positions, f'part of the {element.name} "{self._sentence.word(head).form}"'
                        )
                attached = (self._tried.listed[element.name] - {head}) | behind | before
                found.append(self._sentence.phrases.argument(element.name, head, relation.argument, left_out, attached))
            elif (particle := listed_particle(self._tree, self._tried.unit, element.name, self._match.positions)) > 0:
                found.append(argument_of(self._sentence, element.name, [particle]))
            elif element.name in self._tried.unit.values:
                found.append(value_of_verb(element.name, self._tried.unit.values[element.name]))
            elif element.default and not self._is_said_otherwise(element):
                found.append(default_argument(element.name, element.default))
            elif element.default:
                self._tried.note("no_default", (), f"something else is said for {element.name} than {element.default}")
        return tuple(found)

    def _is_said_otherwise(self, element: FrameElement) -> bool:
        understood = frozenset(self._match.positions).union(*map(self._sentence.subtree, self._tried.heads.values()))
        return is_said_otherwise(
            self._sentence,
            self._clause,
            self._frame,
            element,
            unread=self._tried.unread,
            understood=understood,
        )

    def _places_behind(self, head: int, element: FrameElement, left_out: FrozenSet[int]) -> FrozenSet[int]:
        """Return the place phrases directly after a noun that fill no element: "the mug on the table"."""
        noun = self._sentence.subtree(head) - left_out
        if not noun or "places_behind" in self._tried.without or not has_postmodifiers(self._tree, head):
            return frozenset()
        # "Say hello in the kitchen" says where to say it; "the name of the man in the kitchen" says which man is meant.
        if element.framenet == MESSAGE and not is_of_something(self._tree, head):
            return frozenset()
        taken = frozenset(self._tried.heads.values())
        found: FrozenSet[int] = frozenset()
        # "Turn *to face* the cup on the floor" has a verb of several words.
        for phrase in (child for index in self._match.positions for child in self._sentence.children(index)):
            inner = [other for other in taken if other in self._sentence.subtree(phrase.index) - {phrase.index}]
            positions = self._sentence.subtree(phrase.index).difference(*map(self._sentence.subtree, inner))
            # "The door *directly* in front of you": the parser attaches the adverb to the verb.
            positions |= words_before(self._tree, head, min(positions), self._clause.positions - left_out - taken)
            if (
                is_right_behind(self._tree, positions, noun | found)
                and phrase.index not in self._sentence.goals
                and is_postmodifier_of(self._tree, phrase.index, head, element.framenet in DESCRIBED)
                and not positions & (taken | left_out)
                and positions <= self._clause.positions | self._tree.abandoned
                and not self._tried.is_in_a_measure(phrase.index)
            ):
                found |= positions & self._clause.positions
        return found

    def _words_before(self, head: int, left_out: FrozenSet[int]) -> FrozenSet[int]:
        """Return the adverb before the preposition of a phrase: "close" in "close to the door"."""
        phrase = self._sentence.subtree(head) - left_out if "words_before" not in self._tried.without else frozenset()
        free = self._clause.positions - left_out - frozenset(self._tried.heads.values())
        return words_before(self._tree, self._clause.verb, min(phrase), free) if phrase else frozenset()

    def _outside(self, head: int) -> FrozenSet[int]:
        """Return the words below a head that belong to other clauses or to a condition."""
        return frozenset(self._sentence.subtree(head) - self._clause.positions - {self._tried.subject}) | (
            self._clause.condition_positions if head not in self._clause.condition_positions else frozenset()
        )

    def coverage(self, arguments: Tuple[TypedArgument, ...]) -> Tuple[Tuple[int, ...], float]:
        """Return the words that the arguments leave over, and the share of the words that they do not."""
        used: Set[int] = set(self._match.positions) | self._tried.unfinished
        for argument in arguments:
            used.update(argument.positions)
        # Neither the verb nor that of a wrapped request around it ("I want you to ...") is left over.
        content = [
            index
            for index in sorted(self._clause.positions)
            if self._sentence.is_content(index) and self._clause.verb not in self._sentence.subtree(index)
        ]
        lost = lost_directions(self._tree, self._frame, arguments) - frozenset(self._tried.heads.values())
        left_over = tuple(
            index
            for index in content
            if index in lost
            or (
                index not in used
                and index != self._tried.subject
                and not is_part_of_used_name(self._tree, index, used)
                and not is_of_one_direction(self._tree, index, used)
            )
        )
        unread = [amount for amounts in self._tried.unread.values() for amount in amounts]
        unread += [amount for amount in self._tried.amounts if amount.is_doubtful]
        said = {index for amount in unread for index in amount.positions if self._sentence.word(index).upos != "PUNCT"}
        left_over = tuple(sorted((said - used).union(left_over)))
        return left_over, 1.0 - len(left_over) / (len(content) + 1)
