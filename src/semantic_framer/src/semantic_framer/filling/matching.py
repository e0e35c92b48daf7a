"""Matches lexical units against a clause: finds the words that fill each frame element."""

from typing import Optional, Sequence, Tuple

from semantic_framer.filling.attachment import (
    is_later_item,
    places_before,
    places_said,
)
from semantic_framer.filling.default_values import is_no_place
from semantic_framer.filling.element_arguments import ElementArguments
from semantic_framer.filling.measured_elements import (
    asks_for_a_measure,
    is_setting,
    numeral_at,
)
from semantic_framer.filling.relation_paths import RelationFollower
from semantic_framer.filling.tried_unit import TriedUnit
from semantic_framer.filling.unit_trace import write_unit
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.required_relations import lacks_all_required, may_have
from semantic_framer.units.type_fits import fit_of_relation, with_types
from semantic_framer.units.word_patterns import listed_words
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from semantic_framer.values.things import is_unfinished
from semantic_frames.lexical_unit import ArgumentForm, ElementRelation
from semantic_types import Fit
from utterance_passes.engine.trace import Trace
from utterance_passes.phrases.clauses import Clause
from utterance_passes.phrases.measures import amounts_of
from utterance_passes.phrases.verb_matching import VerbMatch
from word_classes import word_class

_DESTINATION_ADVERBS = word_class("place_adverbs")
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
            tried = TriedUnit(sentence, clause, unit, frame, match, amounts, known.without, is_measuring)
            filling = _Filling(tried)
            reading = filling.reading()
            if trace is not None:
                if reading is not None:
                    trace.extend(tried.notes)
                write_unit(trace, sentence, match, unit, reading, filling.unfilled())
            if reading is not None:
                readings.append(reading)
    return tuple(readings)


class _Filling:
    """Fills the elements of one unit from one clause."""

    def __init__(self, tried: TriedUnit) -> None:
        self._tried = tried
        self._sentence = tried.sentence
        self._tree = tried.sentence.tree
        self._clause = tried.clause
        self._frame = tried.frame
        self._match = tried.match
        self._paths = RelationFollower(tried)

    def reading(self) -> Optional[Reading]:
        """Return the reading; None if a required relation does not match."""
        # What the unit cannot do without takes its words first.
        for relation in sorted(self._tried.unit.relations, key=lambda relation: not self._is_first(relation)):
            if not self._tried.is_taken(relation.name) and relation.name not in self._tried.unread:
                self._take_phrase(relation)
        if any(
            relation.is_required and not self._tried.is_taken(relation.name) for relation in self._tried.unit.relations
        ):
            return None
        words = ElementArguments(self._tried)
        typed = with_types(words.arguments(), self._frame, self._sentence.types)
        arguments = typed.arguments
        names = {argument.name for argument in arguments}
        missing = tuple(
            element
            for element in self._frame.frame_elements
            if (element.is_core or element.name in self._tried.unread) and element.name not in names
        )
        left_over, coverage = words.coverage(arguments)
        return Reading(
            unit=self._tried.unit,
            verb=self._match.verb,
            verb_positions=self._match.positions,
            arguments=arguments,
            missing=missing,
            left_over=left_over,
            coverage=coverage,
            listed=frozenset().union(*self._tried.listed.values()),
            unread=tuple(dict.fromkeys(amount for amounts in self._tried.unread.values() for amount in amounts)),
            wrong_types=typed.wrong,
            doubtful_types=len(
                {name for name, fit in self._tried.fits.items() if fit is not Fit.LIKELY}.union(typed.doubtful)
            ),
        )

    def _is_first(self, relation: ElementRelation) -> bool:
        return relation.is_required or relation.is_wanted or relation.is_limited or self._tried.is_core(relation.name)

    def unfilled(self) -> Tuple[ElementRelation, ...]:
        """Return the relations that found nothing."""
        return tuple(relation for relation in self._tried.unit.relations if not self._tried.is_taken(relation.name))

    def _take_phrase(self, relation: ElementRelation) -> None:
        if not any(may_have(self._sentence, path) for path in relation.relations):
            return
        is_wanted = relation.is_required or relation.is_wanted or self._tried.is_core(relation.name)
        # "Put it on the bench in the kitchen": the first place is meant, and the others describe it.
        static = [path for path in relation.relations if path.preposition.split("_")[0] in _PLACE_PREPOSITIONS]
        places = places_said(self._tree, (head for path in static for head in self._paths.follow(path, is_wanted)))
        if relation.after_place:
            places = [head for head in places if set(places_before(self._tree, head)) & set(relation.after_place)]
        for path in relation.relations:
            heads = self._paths.follow(path, is_wanted) if path not in static else places if path == static[0] else []
            for head in heads:
                if head in self._tried.heads.values() or head in self._match.positions or not self._is_in_clause(head):
                    continue
                is_later = is_later_item(self._tree, head, [*heads, *self._tried.heads.values()])
                if is_later or is_no_place(self._sentence, head, self._frame):
                    continue
                # "Until you are at the door": the door is no place of the verb.
                if path.steps[-1].startswith("prep_") and self._sentence.word(head).deprel == "advcl":
                    continue
                if not relation.words and is_unfinished(self._tree, head):
                    self._tried.unread[relation.name] = ()
                    self._tried.unfinished |= self._sentence.subtree(head)
                    self._tried.note("unfinished", self._sentence.subtree(head), f"no noun for {relation.name}")
                    return
                listed = listed_words(self._tree, head, relation.words)
                fit = fit_of_relation(self._sentence.types, head, relation) if not listed else Fit.LIKELY
                if fit is Fit.WRONG:
                    continue
                listed = listed or frozenset([head] if relation.is_limited and fit is Fit.LIKELY else [])
                is_adverb = relation.argument is ArgumentForm.PHRASE and self._is_only_an_adverb(head, path.steps)
                numeral = numeral_at(head, path, self._tried.amounts) if not relation.words else None
                if numeral is not None:
                    if numeral.is_doubtful:
                        self._tried.unread[relation.name] = (numeral,)
                    else:
                        self._tried.numeral_of[relation.name] = numeral
                    return
                is_measure = self._tried.is_in_a_measure(head) and not is_setting(
                    self._frame, relation, head, self._tried.amounts
                )
                if not relation.words and (is_measure or is_adverb):
                    continue
                self._tried.heads[relation.name] = head
                self._tried.listed[relation.name] = listed
                self._tried.fits[relation.name] = fit
                self._note_where_from(relation.name, head)
                return

    def _note_where_from(self, name: str, head: int) -> None:
        if head == self._tried.subject and not self._clause.subject:
            self._tried.note("shared_subject", [head], f"{name} of this clause too")
        elif head in self._paths.moved:
            governor = self._sentence.tree.governor(self._sentence.word(head)).form
            self._tried.note("reattached", self._sentence.subtree(head), f"{name} of the verb, not part of {governor}")

    def _is_in_clause(self, head: int) -> bool:
        return head in self._clause.positions or head == self._tried.subject

    def _is_only_an_adverb(self, head: int, steps: Tuple[str, ...]) -> bool:
        """Whether a word is an adverb of manner ("slowly", "forward") and so neither a thing nor a place."""
        return steps[-1] in ("advmod", "prt") and self._sentence.word(head).said not in _DESTINATION_ADVERBS
