"""Lists the rules of the framer that can be switched off, beside the passes, to see what each of them does."""

from typing import Mapping

from semantic_framer.asking.nearest_meanings import RULE as NEAREST_MEANING
from semantic_framer.asking.other_trees import RULE as OTHER_GOVERNOR
from semantic_framer.asking.tree_doubts import DOUBTS
from semantic_framer.judging.sentence_verdicts import REST_VERDICTS, SENTENCE_VERDICTS
from semantic_framer.judging.verdicts import CLAUSE_VERDICTS, DOMINATED, PLAUSIBILITY, READING_VERDICTS
from semantic_framer.sentences.teaching import RULE as TEACHING

#: Verdicts that only say why nothing can be done; without them there would be no reading and no refusal.
_ALWAYS_ON = frozenset(["no_verb", "unknown_verb", "nothing_fits"])

#: What each rule says, by its name in the trace.
RULES: Mapping[str, str] = {
    "reattached": 'A phrase below an object fills an element of the verb: "put the cup on the table".',
    "places_behind": 'A place right behind a noun, and in no element, says which one: "the mug on the table".',
    "words_before": 'The adverb before a preposition belongs to its phrase: "close to the door".',
    "attached_by_world": "What the robot knows says whether a place belongs to a thing or to what is done with it.",
    "shared_object": 'A verb without an object has that of the next verb: "open and close the door".',
    "verb_at_the_front": 'A known verb at the front makes a clause where the parser found none: "High five!".',
    "fragment": 'A fragment changes or repeats the last command: "ten feet", "again".',
    "things_asked_for": 'A thing alone is asked for: "the red cup, please".',
    NEAREST_MEANING: "It is asked whether the nearest thing that the robot can do is meant.",
    TEACHING: "It is asked whether to keep what a person teaches in words, which is known by heart then.",
    OTHER_GOVERNOR: "A word hangs on another of its likely governors, where the first shows that it is wrong.",
    **{name: doubt.reason for name, doubt in DOUBTS.items()},
    "mixed_lists": "The items of a list are done one by one where they are handled in different ways.",
    **{
        verdict.name: verdict.reason
        for verdicts in (
            SENTENCE_VERDICTS,
            REST_VERDICTS,
            CLAUSE_VERDICTS,
            PLAUSIBILITY,
            DOMINATED,
            READING_VERDICTS,
        )
        for verdict in verdicts
        if verdict.name not in _ALWAYS_ON
    },
}
