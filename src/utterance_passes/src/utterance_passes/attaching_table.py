"""Lists the passes that attach phrases where they can belong, in the order of running; ``table`` has all passes."""

from typing import Tuple

from utterance_passes import (
    attached_phrases,
    avoided_places,
    awaited_deeds,
    contrasts,
    correct_parse,
    hearers,
    items_in_order,
    places_ahead,
    places_told,
)
from utterance_passes.utterance_pass import Example, Stage, TreeMeaning, TreePass, TreeRepair
from utterance_passes.vocabulary import Speech, Verbs

#: Attach words where they can belong in a command; the words stay the same.
ATTACHING_PASSES: Tuple[TreePass, ...] = (
    TreeMeaning(
        "exceptions",
        'Take out of things what is not meant: "anything but beer", "a beer, not a warm one".',
        Example(
            "bring|VERB|0|root anything|PRON|1|obj but|CCONJ|4|cc beer|NOUN|2|conj",
            ("but: cc(beer) CCONJ/but -> case(beer) ADP/but", "beer: conj(anything) -> nmod(anything)"),
        ),
        Stage.FRAMER,
        contrasts.with_exceptions,
    ),
    TreeMeaning(
        "meant_instead",
        'Put what stands behind "but" in the place of what is denied: "not the hall but the office".',
        Example(
            "take|VERB|0|root not|PART|3|advmod cups|NOUN|1|obj but|CCONJ|5|cc plates|NOUN|3|conj",
            (
                "not: advmod(cups) -> discourse:aside(plates)",
                "cups: obj(take) -> discourse:aside(plates)",
                "but: cc(plates) -> discourse:aside(plates)",
                "plates: conj(cups) -> obj(take)",
            ),
        ),
        Stage.FRAMER,
        contrasts.with_what_is_meant,
    ),
    TreeRepair(
        "ways_behind_particles",
        'Make a way of what stands behind "down" and before the goal.',
        Example(
            "go|VERB|0|root down|ADP|1|compound:prt halls|NOUN|1|obj to|ADP|5|case Bob|PROPN|1|obl",
            ("down: compound:prt(go) -> case(halls)", "halls: obj(go) -> obl(go)"),
        ),
        Stage.FRAMER,
        attached_phrases.with_ways_behind_particles,
    ),
    TreeMeaning(
        "avoided_places",
        'Make a preposition of what says where not to go: "go to Bob avoiding halls".',
        Example(
            "go|VERB|0|root to|ADP|3|case Bob|PROPN|1|obl avoiding|VERB|1|advcl|avoid|VBG halls|NOUN|4|obj",
            ("avoiding: advcl(go) VERB/avoid -> case(halls) ADP/avoiding", "halls: obj(avoiding) -> obl(go)"),
        ),
        Stage.FRAMER,
        avoided_places.with_avoided_places,
    ),
    TreeMeaning(
        "awaited_deeds",
        'Make a condition of what somebody else is to do: "wait for Bob to come".',
        Example(
            "wait|VERB|0|root for|ADP|3|case Bob|PROPN|1|obl to|PART|5|mark come|VERB|1|advcl|come|VB",
            (
                "for: case(Bob) ADP/for for -> mark(come) SCONJ/until until",
                "Bob: obl(wait) -> nsubj(come)",
                "to: mark(come) -> discourse:aside(come)",
            ),
        ),
        Stage.FRAMER,
        awaited_deeds.with_awaited_deeds,
    ),
    TreeMeaning(
        "items_in_order",
        'Set aside words of order before an item of a list: "visit the hall, then the office".',
        Example(
            "visit|VERB|0|root halls|NOUN|1|obj ,|PUNCT|5|punct then|ADV|5|advmod offices|NOUN|1|parataxis",
            ("then: advmod(offices) -> discourse:aside(offices)", "offices: parataxis(visit) -> conj(halls)"),
        ),
        Stage.FRAMER,
        items_in_order.with_items_in_order,
    ),
    TreeMeaning(
        "contrasts",
        'Set aside what is not wanted: "tea instead of coffee".',
        Example(
            "bring|VERB|0|root tea|NOUN|1|obj instead|ADV|5|case of|ADP|5|case coffee|NOUN|1|obl",
            (
                "instead: case(coffee) -> discourse:aside(bring)",
                "of: case(coffee) -> discourse:aside(bring)",
                "coffee: obl(bring) -> discourse:aside(bring)",
            ),
        ),
        Stage.FRAMER,
        contrasts.without_contrasts,
    ),
    TreeMeaning(
        "particles_on_the_way",
        'Turn a particle right before "to" or a similar preposition into an adverb.',
        Example(
            "go|VERB|0|root up|ADP|1|compound:prt to|ADP|4|case Bob|PROPN|1|obl",
            ("up: compound:prt(go) -> advmod(go)",),
        ),
        Stage.FRAMER,
        correct_parse.with_particles_on_the_way,
    ),
    TreeMeaning(
        "ahead_of",
        'Turn "ahead of" into one preposition.',
        Example(
            "open|VERB|0|root doors|NOUN|1|obj ahead|ADV|1|advmod of|ADP|5|case Bob|PROPN|3|obl",
            (
                "ahead: advmod(open) ADV/ahead -> case(Bob) ADP/ahead",
                "of: case(Bob) -> fixed(ahead)",
                "Bob: obl(ahead) -> obl(open)",
            ),
        ),
        Stage.FRAMER,
        places_ahead.with_ahead_as_preposition,
    ),
    TreeMeaning(
        "places_of_devices",
        'Attach a place after "on" or "off" to the object before it.',
        Example(
            "turn|VERB|0|root lights|NOUN|1|obj off|ADP|1|compound:prt in|ADP|5|case rooms|NOUN|1|obl",
            ("rooms: obl(turn) -> nmod(lights)",),
        ),
        Stage.FRAMER,
        correct_parse.with_places_of_devices,
    ),
    TreeMeaning(
        "persons_told",
        "Make a person the hearer who is the only object of a verb of telling.",
        Example(
            "tell|VERB|0|root Bob|PROPN|1|obj",
            ("Bob: obj(tell) -> iobj(tell)",),
            Verbs(frozenset(["tell"]), speech={"tell": Speech.TOLD}),
        ),
        Stage.FRAMER,
        hearers.with_persons_told,
    ),
    TreeMeaning(
        "places_shown",
        "Make the place that somebody asks to be shown a goal.",
        Example(
            "show|VERB|0|root Bob|PROPN|1|iobj where|ADV|1|ccomp it|PRON|3|nsubj is|AUX|3|cop|be",
            (
                "where: ccomp(show) ADV/where -> case(it) ADP/where",
                "it: nsubj(where) -> obl(show)",
                "is: cop(where) -> discourse:aside(show)",
            ),
        ),
        Stage.FRAMER,
        places_told.with_places_shown,
    ),
    TreeMeaning(
        "places_told",
        'Replace "you will find her at the desk" beside a command by "she is at the desk".',
        Example(
            "go|VERB|0|root ,|PUNCT|5|punct you|PRON|5|nsubj will|AUX|5|aux find|VERB|1|parataxis her|PRON|5|obj "
            "at|ADP|8|case desks|NOUN|5|obl",
            (
                ",: punct(find) -> punct(desks)",
                "you: nsubj(find) PRON/you you -> nsubj(desks) PRON/she she",
                "will: aux(find) -> discourse:aside(desks)",
                "find: parataxis(go) VERB/find find -> cop(desks) AUX/be is",
                "her: obj(find) -> discourse:aside(desks)",
                "desks: obl(find) -> parataxis(go)",
            ),
        ),
        Stage.FRAMER,
        places_told.with_places_told,
    ),
)
