"""Lists the passes that correct how the parser joins what stands side by side; ``table`` has the order of all."""

from typing import Tuple

from utterance_passes import (
    joined,
    specified_items,
    turns_in_place,
)
from utterance_passes.utterance_pass import Example, Stage, TreeMeaning, TreePass, TreePolicy
from utterance_passes.vocabulary import Speech, Verbs

#: They run before the passes that attach words where they can belong in a command.
JOINING_PASSES: Tuple[TreePass, ...] = (
    TreeMeaning(
        "places_of_turns",
        "Set aside that a turn leaves the robot where it is.",
        Example(
            "spin|VERB|0|root in|ADP|3|case place|NOUN|1|obl",
            ("in: case(place) -> discourse:aside(spin)", "place: obl(spin) -> discourse:aside(spin)"),
        ),
        Stage.FRAMER,
        turns_in_place.without_places_of_turns,
    ),
    TreeMeaning(
        "manners_joined",
        "Attach a manner to its verb that is joined like a deed.",
        Example(
            "follow|VERB|0|root me|PRON|1|obj ,|PUNCT|5|punct but|CCONJ|5|cc slowly|ADV|1|conj",
            ("but: cc(slowly) -> discourse:aside(follow)", "slowly: conj(follow) -> advmod(follow)"),
        ),
        Stage.FRAMER,
        joined.with_manners_joined,
    ),
    TreeMeaning(
        "conditions_joined",
        "Make a condition of a clause that is joined to the command.",
        Example(
            "bring|VERB|0|root cups|NOUN|1|obj but|CCONJ|6|cc if|SCONJ|6|mark it|PRON|6|nsubj rains|VERB|1|conj",
            ("rains: conj(bring) -> advcl(bring)",),
        ),
        Stage.FRAMER,
        joined.with_conditions_joined,
    ),
    TreeMeaning(
        "bounds_of_messages",
        "Leave how long somebody else is to do something in what that person is told.",
        Example(
            "tell|VERB|0|root Bob|PROPN|1|iobj to|PART|4|mark wait|VERB|1|xcomp until|SCONJ|6|mark noon|NOUN|4|advcl",
            ("until: mark(noon) -> flat:quoted(wait)", "noon: advcl(wait) -> flat:quoted(wait)"),
            Verbs(frozenset(["tell"]), speech={"tell": Speech.TOLD}),
        ),
        Stage.FRAMER,
        joined.with_bounds_of_messages,
    ),
    TreeMeaning(
        "deadlines_joined",
        'Make a clause of the command of what describes "the time": "by the time Bob comes".',
        Example(
            "go|VERB|0|root by|ADP|4|case the|DET|4|det time|NOUN|1|obl Bob|PROPN|6|nsubj comes|VERB|4|acl:relcl",
            ("by: case(time) -> fixed(time)", "time: obl(go) -> mark(comes)", "comes: acl:relcl(time) -> advcl(go)"),
        ),
        Stage.FRAMER,
        joined.with_deadlines_joined,
    ),
    TreeMeaning(
        "places_of_what_there_is",
        "Attach a place behind what there is to the verb.",
        Example(
            "there|PRON|2|expl is|VERB|0|root|be tea|NOUN|2|nsubj on|ADP|5|case tables|NOUN|3|nmod",
            ("tables: nmod(tea) -> obl(is)",),
        ),
        Stage.FRAMER,
        joined.with_places_of_what_there_is,
    ),
    TreeMeaning(
        "shared_nouns",
        'Make the noun of two described things the head of both: "the red and the blue cup".',
        Example(
            "take|VERB|0|root the|DET|3|det red|ADJ|1|obj|red|JJ and|CCONJ|7|cc the|DET|7|det blue|ADJ|7|amod "
            "cup|NOUN|3|conj",
            ("red: obj(take) -> conj(cup)", "and: cc(cup) -> cc(red)", "cup: conj(red) -> obj(take)"),
        ),
        Stage.FRAMER,
        joined.with_shared_nouns,
    ),
    TreeMeaning(
        "specified_items",
        "Take what specifies counted things for these things, and not for further ones.",
        Example(
            "take|VERB|0|root two|NUM|3|nummod cups|NOUN|1|obj|cup ,|PUNCT|6|punct big|ADJ|6|amod one|NOUN|3|conj "
            "and|CCONJ|9|cc small|ADJ|9|amod one|NOUN|3|conj",
            (
                "two: nummod(cups) -> discourse:aside(cup-6)",
                "cups: obj(take) -> discourse:aside(cup-6)",
                "one: conj(cups) NOUN/one one -> obj(take) NOUN/cup cup",
                "one: conj(cups) NOUN/one one -> conj(cup-6) NOUN/cup cup",
            ),
        ),
        Stage.FRAMER,
        specified_items.with_specified_items,
    ),
    TreePolicy(
        "owned_things_apart",
        "Part what somebody owns from who gets it.",
        Example(
            "give|VERB|0|root Bob|PROPN|1|iobj cups|NOUN|1|obj|cup and|CCONJ|6|cc Anna|PROPN|6|compound "
            "hers|NOUN|3|conj",
            ("hers: conj(cups) -> dep(give)",),
        ),
        Stage.FRAMER,
        joined.with_owned_things_apart,
    ),
)
