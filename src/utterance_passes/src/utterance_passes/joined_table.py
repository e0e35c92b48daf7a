"""Lists the passes that correct how the parser joins what stands side by side; ``table`` has the order of all."""

from typing import Tuple

from utterance_passes import (
    attached_phrases,
    joined,
    places_told,
    questions_for_others,
    specified_items,
    turns_in_place,
    words_set_off,
)
from utterance_passes.utterance_pass import Example, Stage, TreeMeaning, TreePass, TreePolicy, TreeRepair
from utterance_passes.vocabulary import Speech, Verbs

_SAYING = Verbs(frozenset(["say", "wave"]), speech={"say": Speech.SAID})

#: They run before the passes that attach words where they can belong in a command.
JOINING_PASSES: Tuple[TreePass, ...] = (
    TreeRepair(
        "emphatic_do",
        'Make "do" before a bare verb its auxiliary.',
        Example(
            "do|VERB|0|root shut|VERB|1|xcomp|shut|VB doors|NOUN|2|obj",
            ("do: root VERB/do -> aux(shut) AUX/do", "shut: xcomp(do) -> root"),
        ),
        Stage.FRAMER,
        joined.with_emphatic_do,
    ),
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
    TreeRepair(
        "particles_at_verbs",
        "Attach a particle before a conjunction to its verb.",
        Example(
            "stand|VERB|0|root by|ADP|5|mark until|SCONJ|5|mark Bob|PROPN|5|nsubj comes|VERB|1|advcl|come|VBZ",
            ("by: mark(comes) -> compound:prt(stand)",),
        ),
        Stage.FRAMER,
        joined.with_particles_at_verbs,
    ),
    TreeRepair(
        "numbers_at_verbs",
        "Attach a number to the verb before it that the parser gives to a noun of another deed.",
        Example(
            "go|VERB|0|root to|ADP|3|case halls|NOUN|1|obl ,|PUNCT|5|punct turn|VERB|1|conj 45|NUM|3|nummod",
            ("45: nummod(halls) -> obl:unmarked(turn)",),
        ),
        Stage.FRAMER,
        joined.with_numbers_at_verbs,
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
    TreeRepair(
        "conditions_of_hearers",
        "Attach when the hearer does something to the command, not to a clause in it.",
        Example(
            "check|VERB|0|root if|SCONJ|4|mark it|PRON|4|nsubj rains|VERB|1|ccomp before|SCONJ|7|mark you|PRON|7|nsubj "
            "go|VERB|4|advcl",
            ("go: advcl(rains) -> advcl(check)",),
        ),
        Stage.FRAMER,
        joined.with_conditions_of_hearers,
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
    TreeRepair(
        "phrases_behind_joints",
        "Attach a phrase between a conjunction and a verb to that verb.",
        Example(
            "sing|VERB|0|root and|CCONJ|5|cc after|ADP|4|case that|PRON|1|obl dance|VERB|1|conj",
            ("that: obl(sing) -> obl(dance)",),
        ),
        Stage.FRAMER,
        joined.with_phrases_behind_joints,
    ),
    TreeRepair(
        "deeds_joined",
        "Join a bare verb behind a comma to the deed before it, not as what goes on meanwhile.",
        Example(
            "find|VERB|0|root Anna|PROPN|1|obj ,|PUNCT|4|punct find|VERB|1|advcl Bob|PROPN|4|obj",
            ("find: advcl(find-1) -> conj(find-1)",),
            Verbs(frozenset(["find"])),
        ),
        Stage.FRAMER,
        joined.with_deeds_joined,
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
    TreeRepair(
        "remarks_joined",
        "Set a remark apart that no conjunction joins to the command.",
        Example(
            "guide|VERB|0|root Bob|PROPN|1|obj ,|PUNCT|6|punct he|PRON|6|nsubj is|AUX|6|cop|be here|ADV|1|advcl",
            ("here: advcl(guide) -> parataxis(guide)",),
        ),
        Stage.FRAMER,
        joined.with_remarks_joined,
    ),
    TreeRepair(
        "copulas_at_question_words",
        'Attach "is" behind a question word to it, not to the subject.',
        Example(
            "who|PRON|0|root|who|WP is|AUX|3|cop|be Bob|PROPN|1|nsubj",
            ("is: cop(Bob) -> cop(who)",),
        ),
        Stage.FRAMER,
        joined.with_copulas_at_question_words,
    ),
    TreeRepair(
        "prepositions_of_nouns",
        'Make "to" before a noun a preposition.',
        Example(
            "say|VERB|0|root hello|INTJ|1|obj to|PART|4|mark Bob|PROPN|1|obl",
            ("to: mark(Bob) PART/to -> case(Bob) ADP/to",),
        ),
        Stage.FRAMER,
        joined.with_prepositions_of_nouns,
    ),
    TreeRepair(
        "words_said",
        "Make what somebody says the object of saying.",
        Example(
            "wave|VERB|0|root until|SCONJ|4|mark I|PRON|4|nsubj say|VERB|5|advcl stop|VERB|1|conj",
            ("say: advcl(stop) -> advcl(wave)", "stop: conj(wave) -> ccomp(say)"),
            _SAYING,
        ),
        Stage.FRAMER,
        joined.with_words_said,
    ),
    TreeRepair(
        "phrases_in_a_row",
        "Attach the last of three phrases with one preposition to the verb.",
        Example(
            "go|VERB|0|root to|ADP|3|case Bob|PROPN|1|obl to|ADP|5|case Anna|PROPN|1|obl "
            "to|ADP|7|case Ben|PROPN|5|conj",
            ("Ben: conj(Anna) -> conj(go)",),
        ),
        Stage.FRAMER,
        joined.with_phrases_in_a_row,
    ),
    TreeRepair(
        "places_of_what_fails",
        "Attach a place to the object of what the speaker cannot do.",
        Example(
            "I|PRON|4|nsubj can|AUX|4|aux|can|MD not|PART|4|advmod reach|VERB|0|root cups|NOUN|4|obj on|ADP|7|case "
            "shelves|NOUN|4|obl",
            ("shelves: obl(reach) -> nmod(cups)",),
        ),
        Stage.FRAMER,
        joined.with_places_of_what_fails,
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
    TreeRepair(
        "places_over_here",
        'Attach an adverb of way to "here" or "there" behind it.',
        Example(
            "pull|VERB|0|root carts|NOUN|1|obj over|ADV|1|advmod here|ADV|1|advmod",
            ("over: advmod(pull) -> advmod(here)",),
        ),
        Stage.FRAMER,
        joined.with_places_over_here,
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
    TreeRepair(
        "clothes_at_persons",
        "Attach what a person wears to the person.",
        Example(
            "find|VERB|0|root men|NOUN|1|obj|man in|ADP|4|case shirts|NOUN|1|obl|shirt",
            ("shirts: obl(find) -> nmod(men)",),
        ),
        Stage.FRAMER,
        joined.with_clothes_at_persons,
    ),
    TreeRepair(
        "words_set_off",
        "Separate a bare noun behind a comma from the phrase before it.",
        Example(
            "go|VERB|0|root to|ADP|4|case the|DET|4|det wall|NOUN|1|obl ,|PUNCT|6|punct photo|NOUN|4|conj",
            ("photo: conj(wall) -> parataxis(go)",),
        ),
        Stage.FRAMER,
        words_set_off.with_words_set_off,
    ),
    TreeRepair(
        "deeds_behind_questions",
        "Join a deed that names what a question asks for to the verb of the command.",
        Example(
            "ask|VERB|0|root Bob|PROPN|1|iobj what|PRON|5|obj|what|WP he|PRON|5|nsubj wants|VERB|1|ccomp|want|VBZ "
            "and|CCONJ|7|cc bring|VERB|5|conj it|PRON|7|obj",
            ("bring: conj(wants) -> conj(ask)",),
            Verbs(frozenset(["ask", "bring"])),
        ),
        Stage.FRAMER,
        questions_for_others.with_deeds_behind_questions,
    ),
    TreeRepair(
        "things_put_down",
        "Make a place of the object of a deed that puts down what the deed before took.",
        Example(
            "take|VERB|0|root bowls|NOUN|1|obj|bowl and|CCONJ|4|cc place|VERB|1|conj on|ADP|4|compound:prt "
            "tables|NOUN|4|obj|table",
            ("on: compound:prt(place) -> case(tables)", "tables: obj(place) -> obl(place)"),
        ),
        Stage.FRAMER,
        joined.with_things_put_down,
    ),
    TreeRepair(
        "states_before_places",
        "Make the predicate of a state of a device in front of a place.",
        Example(
            "check|VERB|0|root if|SCONJ|7|mark lights|NOUN|7|nsubj|light are|AUX|7|cop|be on|ADP|1|ccomp in|ADP|7|case "
            "halls|NOUN|1|ccomp|hall",
            (
                "if: mark(halls) -> mark(on)",
                "lights: nsubj(halls) -> nsubj(on)",
                "are: cop(halls) -> cop(on)",
                "on: ADP/on -> ADJ/on",
                "halls: ccomp(check) -> obl(on)",
            ),
        ),
        Stage.FRAMER,
        places_told.with_states_before_places,
    ),
    TreeRepair(
        "sides_of_goals",
        "Attach a side to what is reached or seen in a condition.",
        Example(
            "go|VERB|0|root until|SCONJ|3|mark reach|VERB|1|advcl doors|NOUN|3|obj|door on|ADP|6|case left|NOUN|3|obl",
            ("left: obl(reach) -> nmod(doors)",),
        ),
        Stage.FRAMER,
        attached_phrases.with_sides_of_goals,
    ),
    TreeRepair(
        "places_of_whom_is_told",
        "Attach a place to the person of whom something is told to somebody.",
        Example(
            "say|VERB|0|root names|NOUN|1|obj|name of|ADP|4|case men|NOUN|2|nmod|man at|ADP|6|case bars|NOUN|1|obl|bar "
            "to|ADP|8|case Anna|PROPN|1|obl",
            ("bars: obl(say) -> nmod(men)",),
            _SAYING,
        ),
        Stage.FRAMER,
        attached_phrases.with_places_of_whom_is_told,
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
    TreeRepair(
        "subjects_of_descriptions",
        "Give a deed that describes a thing its subject.",
        Example(
            "take|VERB|0|root cups|NOUN|1|obj|cup Bob|PROPN|1|vocative washed|VERB|2|acl|wash|VBN",
            ("Bob: vocative(take) -> nsubj(washed)", "washed: acl(cups) -> acl:relcl(cups)"),
        ),
        Stage.FRAMER,
        attached_phrases.with_subjects_of_descriptions,
    ),
)
