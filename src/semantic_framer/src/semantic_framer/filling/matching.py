"""Matches lexical units against a clause: finds the words that fill each frame element."""

from dataclasses import replace
from typing import Dict, FrozenSet, Iterable, List, Optional, Sequence, Set, Tuple

from phrase_meanings.arguments import amount_argument, default_argument, unit_argument
from semantic_framer.filling.attachment import (
    are_contents,
    behind_description,
    has_postmodifiers,
    is_all_at_first_of_two_places,
    is_later_item,
    is_of_one_direction,
    is_of_something,
    is_part_of_used_name,
    is_postmodifier_of,
    is_right_behind,
    listed_particle,
    lost_directions,
    objects_elsewhere,
    persons_behind,
    places_before,
    places_said,
    tells_which,
    words_before,
    words_before_amount,
)
from semantic_framer.filling.default_values import is_no_place, is_said_otherwise, value_of_verb
from semantic_framer.filling.measured_elements import (
    asks_for_a_measure,
    is_in_a_measure,
    is_setting,
    measured_elements,
    measures_as_in_2012,
    numeral_at,
)
from semantic_framer.filling.unit_trace import write_unit
from semantic_framer.units.frame_roles import DESCRIBED, MESSAGE, THINGS
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.required_relations import TOWARDS, lacks_all_required, may_have
from semantic_framer.units.type_fits import fit_of_relation, with_types
from semantic_framer.units.word_patterns import argument_of, listed_words
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from semantic_framer.values.things import is_unfinished
from semantic_frames.frame import FrameElement, SemanticFrame
from semantic_frames.lexical_unit import ArgumentForm, ElementRelation, LexicalUnit, RelationPath
from semantic_frames.relation_names import MEASURE
from semantic_types import Fit
from typed_arguments import TypedArgument
from utterance_passes.engine.trace import Trace, TraceLine
from utterance_passes.phrases.clauses import Clause, shared_subject
from utterance_passes.phrases.measures import Amount, amounts_of
from utterance_passes.phrases.verb_matching import VerbMatch
from word_classes import word_class

#: A phrase with one of these belongs to the verb if the unit asks for it, even if the parser attached it to the object:
#: "bring the mug to the table". A phrase with another preposition ("on", "in", "near") belongs to the verb only for a
#: core or required element: "put the mug on the table".
DIRECTIONAL = frozenset(phrase.replace(" ", "_") for phrase in word_class("directional_prepositions"))
_DESTINATION_ADVERBS = word_class("destination_adverbs")
_PLACE_PREPOSITIONS = word_class("place_prepositions")


def match_units(
    sentence: Sentence,
    clause: Clause,
    matches: Sequence[VerbMatch],
    known: FramedLexicon,
    trace: Optional[Trace] = None,
) -> Tuple[Reading, ...]:
    """Try every lexical unit of the verb of a clause.

    Args:
        sentence: the sentence
        clause: one of its clauses
        matches: verbs of the lexicon that the clause uses
        known: lexical units and frames; a unit whose frame is unknown is left out
        trace: receives a line for each unit, with the relations that it did not find; None for no trace
    Returns:
        readings in the order of the lexicon
    """
    amounts = amounts_of(sentence.tree, clause.positions, clause.verb)
    readings = []
    is_measuring = any(asks_for_a_measure(unit) for match in matches for unit in known.units_of(match.verb))
    for match in matches:
        for unit in known.units_of(match.verb):
            frame = known.frames.get(unit.frame_name)
            if frame is None:
                continue
            if lacks_all_required(sentence, unit):
                if trace is not None:
                    write_unit(trace, sentence, match, unit, None, unit.relations)
                continue
            filling = _Filling(sentence, clause, unit, frame, match, amounts, known.without, is_measuring)
            reading = filling.reading()
            if trace is not None:
                if reading is not None:
                    trace.extend(filling.notes)
                write_unit(trace, sentence, match, unit, reading, filling.unfilled())
            if reading is not None:
                readings.append(reading)
    return tuple(readings)


class _Filling:
    """Fills the elements of one unit from one clause."""

    def __init__(
        self,
        sentence: Sentence,
        clause: Clause,
        unit: LexicalUnit,
        frame: SemanticFrame,
        match: VerbMatch,
        amounts: Tuple[Amount, ...],
        without: FrozenSet[str],
        is_measuring: bool,
    ) -> None:
        self._without = without
        self._sentence = sentence
        self._clause = clause
        self._unit = unit
        self._frame = frame
        self._match = match
        self._amounts = amounts
        self._is_measuring = is_measuring
        #: How well a phrase fits the types of the relation that it fills, by element.
        self._fits: Dict[str, Fit] = {}
        self._heads: Dict[str, int] = {}
        self._listed: Dict[str, FrozenSet[int]] = {}
        measured = measured_elements(sentence, unit, frame, match.positions, amounts, clause.positions)
        self._amount_of = measured.amount_of
        self._unread = measured.unread
        #: Words of phrases without a noun; the framer asks for the elements that these phrases began.
        self._unfinished: FrozenSet[int] = frozenset()
        #: Numbers of several words, by element, in units of 2012.
        self._numeral_of: Dict[str, Amount] = {}
        self._subject = clause.subject or shared_subject(sentence.tree, clause.verb)
        #: Objects of the verb, and phrases without a preposition, each with whether it is the direct object.
        self._nouns = tuple(
            (noun, relation == "dobj")
            for relation in ("dobj", "iobj", "obl", "tmod")
            for noun in sentence.dependents(clause.verb, relation)
        )
        # In "let go of the rope", "go" governs the rope.
        self._verbs = [clause.verb] + [index for index in match.positions[1:] if sentence.word(index).upos == "VERB"]
        self._moved: Set[int] = set()
        #: Trace lines for phrases that rules moved or left out.
        self.notes: List[TraceLine] = []

    def reading(self) -> Optional[Reading]:
        """Return the reading; None if a required relation does not match."""
        # What the unit cannot do without takes its words first.
        for relation in sorted(self._unit.relations, key=lambda relation: not self._is_first(relation)):
            if not self._is_taken(relation.name) and relation.name not in self._unread:
                self._take_phrase(relation)
        if any(relation.is_required and not self._is_taken(relation.name) for relation in self._unit.relations):
            return None
        typed = with_types(self._arguments(), self._frame, self._sentence.types)
        arguments = typed.arguments
        names = {argument.name for argument in arguments}
        missing = tuple(
            element
            for element in self._frame.frame_elements
            if (element.is_core or element.name in self._unread) and element.name not in names
        )
        left_over, coverage = self._coverage(arguments)
        return Reading(
            unit=self._unit,
            verb=self._match.verb,
            verb_positions=self._match.positions,
            arguments=arguments,
            missing=missing,
            left_over=left_over,
            coverage=coverage,
            listed=frozenset().union(*self._listed.values()),
            unread=tuple(dict.fromkeys(amount for amounts in self._unread.values() for amount in amounts)),
            wrong_types=typed.wrong,
            doubtful_types=len(
                {name for name, fit in self._fits.items() if fit is not Fit.LIKELY}.union(typed.doubtful)
            ),
        )

    def _is_first(self, relation: ElementRelation) -> bool:
        return relation.is_required or relation.is_wanted or relation.is_limited or self._is_core(relation.name)

    def _note(self, rule: str, positions: Iterable[int], what: str) -> None:
        words = frozenset(positions)
        self.notes.append(TraceLine(rule, tuple(sorted(words)), self._sentence.text(sorted(words)), "", what))

    def unfilled(self) -> Tuple[ElementRelation, ...]:
        """Return the relations that found nothing."""
        return tuple(relation for relation in self._unit.relations if not self._is_taken(relation.name))

    def _is_taken(self, name: str) -> bool:
        return name in self._heads or name in self._amount_of or name in self._numeral_of

    def _take_phrase(self, relation: ElementRelation) -> None:
        if not any(may_have(self._sentence, path) for path in relation.relations):
            return
        is_wanted = relation.is_required or relation.is_wanted or self._is_core(relation.name)
        # "Put it on the bench in the kitchen": the first place is meant, and the others describe it.
        static = [path for path in relation.relations if path.preposition.split("_")[0] in _PLACE_PREPOSITIONS]
        places = places_said(self._sentence.tree, (head for path in static for head in self._follow(path, is_wanted)))
        if relation.after_place:
            places = [
                head for head in places if set(places_before(self._sentence.tree, head)) & set(relation.after_place)
            ]
        for path in relation.relations:
            heads = self._follow(path, is_wanted) if path not in static else places if path == static[0] else []
            for head in heads:
                if head in self._heads.values() or head in self._match.positions or not self._is_in_clause(head):
                    continue
                is_later = is_later_item(self._sentence.tree, head, [*heads, *self._heads.values()])
                if is_later or is_no_place(self._sentence, head, self._frame):
                    continue
                # "Until you are at the door": the door is no place of the verb.
                if path.steps[-1].startswith("prep_") and self._sentence.word(head).deprel == "advcl":
                    continue
                if not relation.words and is_unfinished(self._sentence.tree, head):
                    self._unread[relation.name] = ()
                    self._unfinished |= self._sentence.subtree(head)
                    self._note("unfinished", self._sentence.subtree(head), f"no noun for {relation.name}")
                    return
                listed = listed_words(self._sentence.tree, head, relation.words)
                fit = fit_of_relation(self._sentence.types, head, relation) if not listed else Fit.LIKELY
                if fit is Fit.WRONG:
                    continue
                listed = listed or frozenset([head] if relation.is_limited and fit is Fit.LIKELY else [])
                is_adverb = relation.argument is ArgumentForm.PHRASE and self._is_only_an_adverb(head, path.steps)
                numeral = numeral_at(head, path, self._amounts) if not relation.words else None
                if numeral is not None:
                    if numeral.is_doubtful:
                        self._unread[relation.name] = (numeral,)
                    else:
                        self._numeral_of[relation.name] = numeral
                    return
                is_measure = self._is_in_a_measure(head) and not is_setting(self._frame, relation, head, self._amounts)
                if not relation.words and (is_measure or is_adverb):
                    continue
                self._heads[relation.name] = head
                self._listed[relation.name] = listed
                self._fits[relation.name] = fit
                self._note_where_from(relation.name, head)
                return

    def _note_where_from(self, name: str, head: int) -> None:
        if head == self._subject and not self._clause.subject:
            self._note("shared_subject", [head], f"{name} of this clause too")
        elif head in self._moved:
            governor = self._sentence.word(self._sentence.word(head).head).form
            self._note("reattached", self._sentence.subtree(head), f"{name} of the verb, not part of {governor}")

    def _is_in_a_measure(self, head: int) -> bool:
        return any(head in amount.positions for amount in self._amount_of.values()) or (
            not measures_as_in_2012(self._unit)
            and is_in_a_measure(self._sentence, head, self._amounts, is_measuring=self._is_measuring)
        )

    def _is_core(self, name: str) -> bool:
        element = self._frame.element(name)
        return element is not None and element.is_core

    def _is_in_clause(self, head: int) -> bool:
        return head in self._clause.positions or head == self._subject

    def _is_only_an_adverb(self, head: int, steps: Tuple[str, ...]) -> bool:
        """Whether a word is an adverb of manner ("slowly", "forward") and so neither a thing nor a place."""
        return steps[-1] in ("advmod", "prt") and self._sentence.word(head).form.lower() not in _DESTINATION_ADVERBS

    def _follow(self, path: RelationPath, is_core: bool) -> List[int]:
        """Return the words at the end of a chain of relations that starts at the verb."""
        governors = self._verbs
        for number, step in enumerate(path.steps):
            if step == MEASURE:
                return []
            found: List[int] = []
            for governor in governors:
                found += self._sentence.dependents(governor, step)
                if number == 0:
                    found += objects_elsewhere(self._sentence.tree, self._match.positions) if step == "dobj" else []
                    found += self._reattached(path.preposition, is_core)
                    goals = self._sentence.goals if step in TOWARDS else ()
                    if goals and any(one.is_core and one.framenet in THINGS for one in self._frame.frame_elements):
                        found += [index for index in goals if self._sentence.word(index).head == governor]
                    if step == "nsubj" and self._subject and not self._clause.subject:
                        found.append(self._subject)
            governors = list(dict.fromkeys(found))
        return [head for head in governors if not are_contents(self._sentence.tree, head)]

    def _reattached(self, preposition: str, is_core: bool) -> List[int]:
        """Return the phrases that the parser attached to an object although the unit asks for them at the verb."""
        if not preposition or not (is_core or preposition in DIRECTIONAL) or "reattached" in self._without:
            return []
        found: List[int] = []
        for noun, is_object in self._nouns:
            if not (is_core and is_all_at_first_of_two_places(self._sentence.tree, noun)):
                found += self._sentence.dependents(noun, f"prep_{preposition}")
            # "Bring the plant on the shelf near the window": the window is the goal, not part of the shelf.
            for inner in self._sentence.children(noun) if is_object else ():
                below = self._sentence.dependents(inner.index, f"prep_{preposition}")
                if inner.deprel == "nmod" and inner.index > noun:
                    found += below
                if inner.deprel == "acl":
                    found += persons_behind(self._sentence.tree, inner.index, preposition, is_needed=is_core)
                    found += behind_description(self._sentence.tree, inner.index, below)
        if not found:
            return found
        particle = [
            index for index in self._match.positions[1:] if self._sentence.word(index).form.lower() == preposition
        ]
        heads = [
            head
            for head in found
            if head not in particle
            and head not in self._sentence.described
            and not tells_which(self._sentence.tree, head)
            and not self._sentence.word(head).deprel.startswith("acl")  # "which is on the bed"
        ]
        self._moved.update(heads)
        return heads

    def _arguments(self) -> Tuple[TypedArgument, ...]:
        verb_words = frozenset(self._match.positions)
        amount_words = frozenset(position for amount in self._amount_of.values() for position in amount.positions)
        amount_words |= frozenset(
            position
            for amount in self._numeral_of.values()
            for position in amount.positions
            if position != amount.unit_position
        )
        found: List[TypedArgument] = []
        for element in self._frame.frame_elements:
            if element.name in self._amount_of:
                amount = self._amount_of[element.name]
                is_unit = any(other.unit_element == element.name for other in self._frame.frame_elements)
                found.append(
                    unit_argument(self._sentence.tree, element.name, amount)
                    if is_unit
                    else amount_argument(self._sentence.tree, element.name, amount, is_whole=not element.unit_element)
                )
                hedges = words_before_amount(self._sentence.tree, min(amount.positions))
                if not is_unit:
                    found[-1] = replace(found[-1], positions=tuple(sorted(hedges)) + found[-1].positions)
            elif element.name in self._numeral_of:
                numeral = self._numeral_of[element.name]
                found.append(amount_argument(self._sentence.tree, element.name, numeral, is_whole=False))
            elif element.name in self._heads:
                head = self._heads[element.name]
                others = [
                    subtree
                    for name, other in self._heads.items()
                    if name != element.name and other != head
                    for subtree in [self._sentence.subtree(other)]
                    if head not in subtree
                ]
                left_out = verb_words | amount_words | frozenset().union(*others) | self._outside(head)
                relation = next(relation for relation in self._unit.relations if relation.name == element.name)
                behind = self._places_behind(head, element, left_out)
                before = self._words_before(head, left_out)
                for rule, positions in (("places_behind", behind), ("words_before", before)):
                    if positions:
                        self._note(rule, positions, f'part of the {element.name} "{self._sentence.word(head).form}"')
                attached = (self._listed[element.name] - {head}) | behind | before
                found.append(self._sentence.phrases.argument(element.name, head, relation.argument, left_out, attached))
            elif (
                particle := listed_particle(self._sentence.tree, self._unit, element.name, self._match.positions)
            ) > 0:
                found.append(argument_of(self._sentence, element.name, [particle]))
            elif element.name in self._unit.values:
                found.append(value_of_verb(element.name, self._unit.values[element.name]))
            elif element.default and not self._is_said_otherwise(element):
                found.append(default_argument(element.name, element.default))
            elif element.default:
                self._note("no_default", (), f"something else is said for {element.name} than {element.default}")
        return tuple(found)

    def _is_said_otherwise(self, element: FrameElement) -> bool:
        understood = frozenset(self._match.positions).union(*map(self._sentence.subtree, self._heads.values()))
        return is_said_otherwise(
            self._sentence, self._clause, self._frame, element, unread=self._unread, understood=understood
        )

    def _places_behind(self, head: int, element: FrameElement, left_out: FrozenSet[int]) -> FrozenSet[int]:
        """Return the place phrases directly after a noun that fill no element: "the mug on the table"."""
        noun = self._sentence.subtree(head) - left_out
        if not noun or "places_behind" in self._without or not has_postmodifiers(self._sentence.tree, head):
            return frozenset()
        # "Say hello in the kitchen" says where to say it; "the name of the man in the kitchen" says which man is meant.
        if element.framenet == MESSAGE and not is_of_something(self._sentence.tree, head):
            return frozenset()
        taken = frozenset(self._heads.values())
        found: FrozenSet[int] = frozenset()
        # "Turn *to face* the cup on the floor" has a verb of several words.
        for phrase in (child for index in self._match.positions for child in self._sentence.children(index)):
            inner = [other for other in taken if other in self._sentence.subtree(phrase.index) - {phrase.index}]
            positions = self._sentence.subtree(phrase.index).difference(*map(self._sentence.subtree, inner))
            # "The door *directly* in front of you": the parser attaches the adverb to the verb.
            positions |= words_before(
                self._sentence.tree, head, min(positions), self._clause.positions - left_out - taken
            )
            if (
                is_right_behind(self._sentence.tree, positions, noun | found)
                and phrase.index not in self._sentence.goals
                and is_postmodifier_of(self._sentence.tree, phrase.index, head, element.framenet in DESCRIBED)
                and not positions & (taken | left_out)
                and positions <= self._clause.positions | self._sentence.tree.abandoned
                and not self._is_in_a_measure(phrase.index)
            ):
                found |= positions & self._clause.positions
        return found

    def _words_before(self, head: int, left_out: FrozenSet[int]) -> FrozenSet[int]:
        """Return the adverb before the preposition of a phrase: "close" in "close to the door"."""
        phrase = self._sentence.subtree(head) - left_out if "words_before" not in self._without else frozenset()
        free = self._clause.positions - left_out - frozenset(self._heads.values())
        return words_before(self._sentence.tree, self._clause.verb, min(phrase), free) if phrase else frozenset()

    def _outside(self, head: int) -> FrozenSet[int]:
        """Return the words below a head that belong to other clauses or to a condition."""
        return frozenset(self._sentence.subtree(head) - self._clause.positions - {self._subject}) | (
            self._clause.condition_positions if head not in self._clause.condition_positions else frozenset()
        )

    def _coverage(self, arguments: Tuple[TypedArgument, ...]) -> Tuple[Tuple[int, ...], float]:
        used: Set[int] = set(self._match.positions) | self._unfinished
        for argument in arguments:
            used.update(argument.positions)
        # Neither the verb nor that of a wrapped request around it ("I want you to ...") is left over.
        content = [
            index
            for index in sorted(self._clause.positions)
            if self._sentence.is_content(index) and self._clause.verb not in self._sentence.subtree(index)
        ]
        lost = lost_directions(self._sentence.tree, self._frame, arguments) - frozenset(self._heads.values())
        left_over = tuple(
            index
            for index in content
            if index in lost
            or (
                index not in used
                and index != self._subject
                and not is_part_of_used_name(self._sentence.tree, index, used)
                and not is_of_one_direction(self._sentence.tree, index, used)
            )
        )
        unread = [amount for amounts in self._unread.values() for amount in amounts]
        unread += [amount for amount in self._amounts if amount.is_doubtful]
        said = {index for amount in unread for index in amount.positions if self._sentence.word(index).upos != "PUNCT"}
        left_over = tuple(sorted((said - used).union(left_over)))
        return left_over, 1.0 - len(left_over) / (len(content) + 1)
