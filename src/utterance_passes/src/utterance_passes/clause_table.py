"""Lists the passes that correct nouns, counts and clauses of a parse, in the order of running; ``table`` has all."""

from typing import Tuple

from utterance_passes import (
    additions,
    attached_phrases,
    bounded_counts,
    correct_parse,
    hearers,
    places_told,
    purposes,
    questions_for_others,
    relations,
    wished_results,
)
from utterance_passes.utterance_pass import Example, Stage, TreeMeaning, TreePass, TreeRepair
from utterance_passes.vocabulary import Speech, Verbs

#: Make nouns, counts and clauses of what the parser takes for something else.
CLAUSE_PASSES: Tuple[TreePass, ...] = (
    TreeRepair(
        "modals_as_nouns",
        "Turn a modal after a noun into a noun if it helps no verb.",
        Example(
            "take|VERB|0|root corn|NOUN|1|obj can|AUX|1|aux|can|MD",
            ("corn: obj(take) -> compound(can)", "can: aux(take) AUX/can -> obj(take) NOUN/can"),
        ),
        Stage.FRAMER,
        correct_parse.with_modals_as_nouns,
    ),
    TreeRepair(
        "as_well_as",
        'Make "and" of "as well as".',
        Example(
            "take|VERB|0|root cups|NOUN|1|obj as|ADV|6|cc well|ADV|3|fixed as|ADP|6|case plates|NOUN|1|obl",
            (
                "well: fixed(as-3) -> cc(plates)",
                "as: case(plates) -> cc(plates)",
                "plates: obl(take) -> conj(cups)",
            ),
        ),
        Stage.FRAMER,
        additions.with_as_well_as,
    ),
    TreeMeaning(
        "not_only",
        'Set "not only" aside before "but".',
        Example(
            "take|VERB|0|root not|PART|1|advmod only|ADV|4|advmod cups|NOUN|1|obj but|CCONJ|6|cc plates|NOUN|4|conj",
            ("not: advmod(take) -> discourse:aside(take)", "only: advmod(cups) -> discourse:aside(take)"),
        ),
        Stage.FRAMER,
        additions.without_not_only,
    ),
    TreeRepair(
        "bounded_counts",
        'Attach a bound to its number: "up to three apples".',
        Example(
            "bring|VERB|0|root up|ADP|1|compound:prt to|ADP|5|case three|NUM|5|nummod apples|NOUN|1|obl",
            (
                "up: compound:prt(bring) ADP/up -> advmod(three) ADV/up",
                "to: case(apples) -> fixed(up)",
                "apples: obl(bring) -> obj(bring)",
            ),
        ),
        Stage.FRAMER,
        bounded_counts.with_bounded_counts,
    ),
    TreeRepair(
        "commands_behind_statements",
        "Make a clause of its own of a command behind a statement.",
        Example(
            "Bob|PROPN|2|nsubj needs|VERB|0|root|need|VBZ air|NOUN|2|obj ,|PUNCT|5|punct open|VERB|2|conj|open|VB "
            "doors|NOUN|5|obj",
            ("open: conj(needs) -> parataxis(needs)",),
            Verbs(frozenset(["open"])),
        ),
        Stage.FRAMER,
        relations.with_commands_behind_statements,
    ),
    TreeMeaning(
        "wished_results",
        "Make a request for a deed of the wish for its result.",
        Example(
            "I|PRON|2|nsubj want|VERB|0|root the|DET|4|det door|NOUN|2|obj closed|VERB|4|acl|close|VBN",
            ("door: obj(want) -> obj(closed)", "closed: acl(door) -> xcomp(want)"),
            Verbs(frozenset(["close"])),
        ),
        Stage.FRAMER,
        wished_results.with_wished_results,
    ),
    TreeRepair(
        "remarks",
        "Make a clause of its own of a whole sentence behind a noun.",
        Example(
            "bring|VERB|0|root water|NOUN|1|obj I|PRON|5|nsubj am|AUX|5|cop thirsty|ADJ|2|acl:relcl",
            ("thirsty: acl:relcl(water) -> parataxis(bring)",),
        ),
        Stage.FRAMER,
        relations.with_remarks_apart,
    ),
    TreeRepair(
        "prepositions_at_names",
        "Attach a preposition to the noun right behind it.",
        Example(
            "look|VERB|0|root for|ADP|5|case Adam|PROPN|1|obl at|ADP|5|case doors|NOUN|1|obl",
            ("for: case(doors) -> case(Adam)",),
        ),
        Stage.FRAMER,
        relations.with_prepositions_at_names,
    ),
    TreeRepair(
        "asked_clauses",
        "Make a clause behind the person who is asked a question, not a condition.",
        Example(
            "ask|VERB|0|root Bob|PROPN|1|obj if|SCONJ|5|mark he|PRON|5|nsubj|he sees|VERB|1|advcl",
            ("Bob: obj(ask) -> iobj(ask)", "sees: advcl(ask) -> ccomp(ask)"),
        ),
        Stage.FRAMER,
        questions_for_others.with_asked_clauses,
    ),
    TreeRepair(
        "told_predicates",
        "Make a clause of a predicate behind the question that is to be told.",
        Example(
            "tell|VERB|0|root what|DET|3|det day|NOUN|1|obj is|AUX|1|cop|be Monday|PROPN|1|obl:unmarked",
            (
                "day: obj(tell) -> nsubj(Monday)",
                "is: cop(tell) -> cop(Monday)",
                "Monday: obl:unmarked(tell) -> ccomp(tell)",
            ),
            Verbs(frozenset(["tell"]), speech={"tell": Speech.TOLD}),
        ),
        Stage.FRAMER,
        relations.with_told_predicates,
    ),
    TreeRepair(
        "words_before_nouns",
        'Attach an article or an owner to the object right behind it: "tell *the* kids dinner is ready".',
        Example(
            "tell|VERB|0|root the|DET|4|det kids|NOUN|1|iobj dinner|NOUN|5|nsubj waits|VERB|1|ccomp",
            ("the: det(dinner) -> det(kids)",),
        ),
        Stage.FRAMER,
        attached_phrases.with_words_before_nouns,
    ),
    TreeRepair(
        "hearers_joined",
        'Join a person behind "and" to the hearer before it, not to what the hearer is told.',
        Example(
            "tell|VERB|0|root him|PRON|1|iobj and|CCONJ|7|cc Bob|PROPN|7|nsubj where|ADV|7|advmod you|PRON|7|nsubj "
            "live|VERB|1|ccomp",
            ("and: cc(live) -> cc(Bob)", "Bob: nsubj(live) -> conj(him)"),
            Verbs(frozenset(["tell"]), speech={"tell": Speech.TOLD}),
        ),
        Stage.FRAMER,
        hearers.with_hearers_joined,
    ),
    TreeRepair(
        "deeds_of_hearers",
        "Join a deed that is not the robot's to what a hearer is to do.",
        Example(
            "tell|VERB|0|root Anna|PROPN|1|iobj to|PART|4|mark sit|VERB|1|xcomp|sit|VB and|CCONJ|7|cc to|PART|7|mark "
            "rest|VERB|1|conj|rest|VB",
            ("rest: conj(tell) -> conj(sit)",),
            Verbs(frozenset(["tell", "rest"]), speech={"tell": Speech.TOLD}),
        ),
        Stage.FRAMER,
        hearers.with_deeds_of_hearers,
    ),
    TreeRepair(
        "messages_behind_clauses",
        "Make what follows the description of a hearer what the hearer is told.",
        Example(
            "tell|VERB|0|root men|NOUN|1|obj who|PRON|4|nsubj wait|VERB|2|acl:relcl that|SCONJ|8|mark "
            "lunch|NOUN|8|nsubj is|AUX|8|cop ready|ADJ|4|advcl",
            ("men: obj(tell) -> iobj(tell)", "ready: advcl(wait) -> ccomp(tell)"),
            Verbs(frozenset(["tell"]), speech={"tell": Speech.TOLD}),
        ),
        Stage.FRAMER,
        hearers.with_messages_behind_clauses,
    ),
    TreeRepair(
        "requests_behind_clauses",
        "Attach what somebody is asked for to the verb, not to the description of the person.",
        Example(
            "ask|VERB|0|root Bob|PROPN|1|iobj sitting|VERB|2|acl there|ADV|3|advmod for|ADP|6|case cups|NOUN|3|obl",
            ("cups: obl(sitting) -> obl(ask)",),
        ),
        Stage.FRAMER,
        hearers.with_requests_behind_clauses,
    ),
    TreeRepair(
        "things_named_by_clauses",
        'Make "what" the thing that a clause describes: "bring me what I left there".',
        Example(
            "take|VERB|0|root what|PRON|4|obj|what|WP you|PRON|4|nsubj need|VERB|1|ccomp",
            ("what: obj(need) -> obj(take)", "need: ccomp(take) -> acl:relcl(what)"),
        ),
        Stage.FRAMER,
        relations.with_things_named_by_clauses,
    ),
    TreeRepair(
        "goals_behind_clauses",
        "Attach the goal behind the description of a thing to the verb.",
        Example(
            "bring|VERB|0|root cups|NOUN|1|obj I|PRON|4|nsubj put|VERB|2|acl:relcl on|ADP|6|case shelves|NOUN|4|obl "
            "to|ADP|8|case Anna|PROPN|4|obl",
            ("Anna: obl(put) -> obl(bring)",),
        ),
        Stage.FRAMER,
        relations.with_goals_behind_clauses,
    ),
    TreeRepair(
        "predicates_as_clauses",
        "Make a clause of an object that has a subject and a copula.",
        Example(
            "tell|VERB|0|root what|DET|3|det time|NOUN|1|obj it|PRON|3|nsubj is|AUX|3|cop",
            ("time: obj(tell) -> ccomp(tell)",),
        ),
        Stage.FRAMER,
        relations.with_predicates_as_clauses,
    ),
    TreeRepair(
        "purposes_of_things",
        'Make a clause of what something is for: "something to drink".',
        Example(
            "bring|VERB|0|root something|PRON|1|obj to|ADP|4|case drink|NOUN|1|obl",
            (
                "to: case(drink) ADP/to -> mark(drink) PART/to",
                "drink: obl(bring) NOUN/drink -> acl(something) VERB/drink",
            ),
        ),
        Stage.FRAMER,
        purposes.with_purposes_of_things,
    ),
    TreeRepair(
        "purposes_of_deeds",
        "Attach a purpose behind a certain thing to the deed.",
        Example(
            "open|VERB|0|root the|DET|3|det window|NOUN|1|obj to|PART|5|mark air|VERB|3|acl room|NOUN|5|obj",
            ("air: acl(window) -> advcl(open)",),
        ),
        Stage.FRAMER,
        purposes.with_purposes_of_deeds,
    ),
    TreeRepair(
        "steps_taken",
        "Make an amount right behind a verb that means little alone its object.",
        Example(
            "take|VERB|0|root three|NUM|3|nummod steps|NOUN|1|obl:unmarked|step|NNS back|ADV|1|advmod",
            ("steps: obl:unmarked(take) -> obj(take)",),
        ),
        Stage.FRAMER,
        correct_parse.with_steps_taken,
    ),
    TreeRepair(
        "places_of_subjects",
        "Attach a place to the thing before it in a question about its state.",
        Example(
            "is|AUX|6|cop|be cups|NOUN|6|nsubj on|ADP|5|case the|DET|5|det table|NOUN|6|obl red|ADJ|0|root",
            ("table: obl(red) -> nmod(cups)",),
        ),
        Stage.FRAMER,
        places_told.with_places_of_subjects,
    ),
    TreeRepair(
        "topics_at_nouns",
        "Attach what something is about to it.",
        Example(
            "tell|VERB|0|root me|PRON|1|iobj stories|NOUN|1|obj about|ADP|5|case robots|NOUN|1|obl",
            ("robots: obl(tell) -> nmod(stories)",),
        ),
        Stage.FRAMER,
        attached_phrases.with_topics_at_nouns,
    ),
)
