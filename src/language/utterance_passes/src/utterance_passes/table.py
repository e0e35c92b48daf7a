"""Names every pass from the text to the tree that the framer reads, in the order of running. No pass calls another.

Each pass stands at its function, in the module of its subject.
"""

from typing import Mapping, Tuple

from utterance_passes.asides import comparisons, contrasts, formulas, objections, reasons, turns_in_place
from utterance_passes.deeds import (
    aspectual_verbs,
    avoided_places,
    awaited_deeds,
    deeds_at_times,
    light_verbs,
    wished_results,
)
from utterance_passes.engine.utterance_pass import CutPass, Pass, SurroundingsPass, TextPass, TreePass, WordPass
from utterance_passes.messages import mentioned_words, quotations
from utterance_passes.repairs import hearers, joined, particles, places_told
from utterance_passes.sharing import argument_clusters, items_in_order, shared_verbs, specified_items
from utterance_passes.slips import corrections, hesitation, restatements
from utterance_passes.wording import run_ons, surroundings, typos, written_signs

#: Rewrite the text alone.
TEXT_PASSES: Tuple[TextPass, ...] = (
    written_signs.transcribers_marks,
    written_signs.apostrophes,
    written_signs.quotation_marks,
    written_signs.dashes,
    written_signs.fraction_signs,
    written_signs.fraction_slash,
    written_signs.degree_sign,
    written_signs.units,
    written_signs.minus_sign,
    written_signs.negative_sign,
    written_signs.ratios,
    hesitation.false_starts,
    hesitation.repeated_starts,
    restatements.half_phrases,
    hesitation.hesitation,
    restatements.shares,
    written_signs.contractions,
    written_signs.blanks,
    written_signs.ends,
)

#: Rewrite words that the robot does not know.
WORD_PASSES: Tuple[WordPass, ...] = (
    typos.typos,
    restatements.less_precise,
)

#: Find words that the parser leaves out, and adds to the tree of the command later.
SURROUNDINGS_PASSES: Tuple[SurroundingsPass, ...] = (surroundings.surroundings,)

#: Find the places where the parser cuts a text, to parse each part alone.
CUT_PASSES: Tuple[CutPass, ...] = (run_ons.run_ons,)


#: Remove the words that a person takes back; they run before all other passes of the framer.
CORRECTION_PASSES: Tuple[TreePass, ...] = (
    mentioned_words.mentioned_words,
    objections.objection,
    corrections.restarts,
    corrections.corrections,
)

#: Correct the parse; they run on trees that other programs learn from, too.
PARSE_CORRECTING_PASSES: Tuple[TreePass, ...] = (
    contrasts.not_only,
    wished_results.wished_results,
    contrasts.exceptions,
    contrasts.meant_instead,
    avoided_places.avoided_places,
    awaited_deeds.awaited_deeds,
    items_in_order.items_in_order,
    contrasts.contrasts,
    particles.particles_on_the_way,
    particles.ahead_of,
    particles.places_of_devices,
    hearers.persons_told,
    places_told.places_shown,
    places_told.places_told,
)

#: Correct the parse, replace or set aside phrases of the speaker, and mark clauses and times.
REPHRASING_PASSES: Tuple[TreePass, ...] = (
    turns_in_place.places_of_turns,
    joined.manners_joined,
    joined.conditions_joined,
    joined.bounds_of_messages,
    joined.deadlines_joined,
    joined.places_of_what_there_is,
    joined.shared_nouns,
    specified_items.specified_items,
    joined.owned_things_apart,
    *PARSE_CORRECTING_PASSES,
    aspectual_verbs.aspectual_verbs,
    light_verbs.light_verbs,
    quotations.quotations,
    comparisons.comparisons,
    formulas.formulas,
    reasons.reasons,
    argument_clusters.argument_clusters,
    shared_verbs.shared_verbs,
    deeds_at_times.times,
)

#: Passes on the tree that the parser publishes.
FRAMER_TREE_PASSES: Tuple[TreePass, ...] = CORRECTION_PASSES + REPHRASING_PASSES

_BY_NODE: Mapping[str, Tuple[Pass, ...]] = {
    "stanford_parser_ros": TEXT_PASSES + WORD_PASSES + SURROUNDINGS_PASSES + CUT_PASSES,
    "semantic_framer": FRAMER_TREE_PASSES,
}
#: All passes in order, from the text to the tree that the framer reads.
PASSES: Tuple[Pass, ...] = tuple(one for passes in _BY_NODE.values() for one in passes)
#: The node that runs each pass, by the name of the pass.
NODES: Mapping[str, str] = {one.name: node for node, passes in _BY_NODE.items() for one in passes}
