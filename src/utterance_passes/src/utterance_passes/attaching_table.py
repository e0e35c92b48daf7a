"""Lists the passes that attach phrases where they can belong, in the order of running; ``table`` has all passes."""

from typing import Tuple

from utterance_passes import (
    additions,
    attached_phrases,
    avoided_places,
    awaited_deeds,
    compass,
    contrasts,
    correct_parse,
    hearers,
    items_in_order,
    names,
    objects_behind,
    participles,
    places_ahead,
    places_told,
)
from utterance_passes.utterance_pass import Example, Stage, TreeMeaning, TreePass, TreeRepair
from utterance_passes.vocabulary import Speech, Verbs

#: Attach words where they can belong in a command; the words stay the same.
ATTACHING_PASSES: Tuple[TreePass, ...] = (
    TreeRepair(
        "hands_at_verbs",
        "Attach the robot's own hand to the verb, not to the object.",
        Example(
            "take|VERB|0|root cups|NOUN|1|obj with|ADP|5|case your|PRON|5|nmod:poss hand|NOUN|2|nmod",
            ("hand: nmod(cups) -> obl(take)",),
        ),
        Stage.FRAMER,
        attached_phrases.with_hands_at_verbs,
    ),
    TreeRepair(
        "there_at_things",
        'Attach "there" to the thing that somebody gets: "bring me that over there".',
        Example(
            "bring|VERB|0|root me|PRON|1|iobj that|DET|4|det cup|NOUN|1|obj there|ADV|1|advmod",
            ("there: advmod(bring) -> advmod(cup)",),
        ),
        Stage.FRAMER,
        attached_phrases.with_there_at_things,
    ),
    TreeRepair(
        "phrases_of_what_is_asked",
        'Attach a phrase to the noun that it follows, not to "what".',
        Example(
            "what|PRON|0|root is|AUX|1|cop size|NOUN|1|nsubj of|ADP|5|case cups|NOUN|3|nmod "
            "on|ADP|7|case shelf|NOUN|1|obl",
            ("shelf: obl(what) -> nmod(cups)",),
        ),
        Stage.FRAMER,
        attached_phrases.with_phrases_of_what_is_asked,
    ),
    TreeRepair(
        "upside_down",
        'Make an adverb of "upside down".',
        Example(
            "turn|VERB|0|root boxes|NOUN|3|compound upside|NOUN|1|obj down|ADV|1|advmod",
            ("boxes: compound(upside) -> obj(turn)", "upside: obj(turn) NOUN/upside -> advmod(down) ADV/upside"),
        ),
        Stage.FRAMER,
        attached_phrases.with_upside_down,
    ),
    TreeRepair(
        "places_in_a_row",
        "Attach the side from which things are counted to the thing.",
        Example(
            "take|VERB|0|root second|ADJ|3|amod bottle|NOUN|1|obj from|ADP|5|case left|NOUN|1|obl",
            ("left: obl(take) -> nmod(bottle)",),
        ),
        Stage.FRAMER,
        attached_phrases.with_places_in_a_row,
    ),
    TreeRepair(
        "ways_at_verbs",
        'Attach a source and the goal behind it to the verb: "from the table to the hall".',
        Example(
            "go|VERB|0|root from|ADP|3|case table|NOUN|1|obl to|ADP|5|case hall|NOUN|3|nmod",
            ("hall: nmod(table) -> obl(go)",),
        ),
        Stage.FRAMER,
        attached_phrases.with_ways_at_verbs,
    ),
    TreeRepair(
        "wholes_at_pronouns",
        'Attach "all" or "both" to the pronoun before it.',
        Example(
            "bring|VERB|0|root them|PRON|1|iobj all|DET|1|obj",
            ("them: iobj(bring) -> obj(bring)", "all: obj(bring) -> det(them)"),
        ),
        Stage.FRAMER,
        attached_phrases.with_wholes_at_pronouns,
    ),
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
        "things_named_again",
        'Make one thing of a thing and the words that describe it: "that mug, the small one".',
        Example(
            "take|VERB|0|root mugs|NOUN|1|obj ,|PUNCT|6|punct the|DET|6|det small|ADJ|6|amod one|NOUN|2|conj",
            ("one: conj(mugs) -> appos(mugs)",),
        ),
        Stage.FRAMER,
        attached_phrases.with_things_named_again,
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
    TreeRepair(
        "sides_in_order",
        'Attach "then" to the side right behind it, and each side to the verb.',
        Example(
            "turn|VERB|0|root left|ADV|1|advmod then|ADV|6|advmod right|ADV|6|advmod then|ADV|6|advmod "
            "left|ADV|1|advmod",
            ("then: advmod(left-6) -> advmod(right)", "right: advmod(left-6) -> advmod(turn)"),
        ),
        Stage.FRAMER,
        items_in_order.with_sides_in_order,
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
    TreeRepair(
        "speeds_together",
        "Attach the time of a speed to its length.",
        Example(
            "go|VERB|0|root two|NUM|3|nummod metres|NOUN|1|obl per|ADP|5|case second|NOUN|1|obl",
            ("second: obl(go) -> nmod(metres)",),
        ),
        Stage.FRAMER,
        correct_parse.with_speeds_together,
    ),
    TreeRepair(
        "superlatives_at_nouns",
        "Attach a superlative of place and the phrase behind it to the noun before it.",
        Example(
            "take|VERB|0|root chairs|NOUN|1|obj closest|ADV|1|advmod to|ADP|5|case doors|NOUN|1|obl",
            ("closest: advmod(take) ADV/closest -> amod(chairs) ADJ/closest", "doors: obl(take) -> obl(closest)"),
        ),
        Stage.FRAMER,
        places_ahead.with_superlatives_at_nouns,
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
    TreeRepair(
        "places_of_all",
        'Attach a place to "everything" or a similar word before it.',
        Example(
            "take|VERB|0|root all|PRON|1|obj in|ADP|4|case boxes|NOUN|1|obl",
            ("boxes: obl(take) -> nmod(all)",),
        ),
        Stage.FRAMER,
        correct_parse.with_places_of_all,
    ),
    TreeRepair(
        "measured_turns",
        'Turn the verb "turn" after a number or a fraction into a noun.',
        Example(
            "turn|VERB|0|root quarter|NOUN|1|obj turn|VERB|1|xcomp left|ADV|3|advmod",
            (
                "quarter: obj(turn-1) -> compound(turn-3)",
                "turn: xcomp(turn-1) VERB/turn -> obl:unmarked(turn-1) NOUN/turn",
                "left: advmod(turn-3) -> advmod(turn-1)",
            ),
        ),
        Stage.FRAMER,
        correct_parse.with_measured_turns,
    ),
    TreeRepair(
        "sides_apart",
        "Attach a side and the measure after it separately to the verb.",
        Example(
            "turn|VERB|0|root left|ADJ|4|amod two|NUM|4|nummod degrees|NOUN|1|obj",
            ("left: amod(degrees) ADJ/left -> advmod(turn) ADV/left",),
        ),
        Stage.FRAMER,
        correct_parse.with_sides_apart,
    ),
    TreeRepair(
        "compass_apart",
        "Attach a direction of the compass to the verb.",
        Example(
            "move|VERB|0|root north|ADJ|4|amod two|NUM|4|nummod metres|NOUN|1|obl:unmarked",
            ("north: amod(metres) ADJ/north -> advmod(move) ADV/north",),
        ),
        Stage.FRAMER,
        compass.with_compass_directions_apart,
    ),
    TreeRepair(
        "around_apart",
        'Turn "around" between a verb of turning and a measure into an adverb.',
        Example(
            "turn|VERB|0|root around|ADP|4|case two|NUM|4|nummod degrees|NOUN|1|obl",
            ("around: case(degrees) ADP/around -> advmod(turn) ADV/around",),
        ),
        Stage.FRAMER,
        correct_parse.with_around_apart,
    ),
    TreeRepair(
        "degrees",
        'Attach "a bit" and "a little" to the verb, not to the noun before them.',
        Example(
            "open|VERB|0|root windows|NOUN|1|obj a|DET|4|det bit|NOUN|2|nmod:unmarked",
            ("bit: nmod:unmarked(windows) -> obl:unmarked(open)",),
        ),
        Stage.FRAMER,
        correct_parse.with_degrees,
    ),
    TreeRepair(
        "objects_of_vocatives",
        "Turn a false vocative back into the end of the object.",
        Example(
            "push|VERB|0|root the|DET|3|det blue|ADJ|1|obj robot|NOUN|1|vocative",
            ("the: det(blue) -> det(robot)", "blue: obj(push) -> amod(robot)", "robot: vocative(push) -> obj(push)"),
        ),
        Stage.FRAMER,
        correct_parse.with_objects_of_vocatives,
    ),
    TreeRepair(
        "names_behind_nouns",
        "Attach a name, a letter or a number to the noun or the name in front of it.",
        Example(
            "go|VERB|0|root to|ADP|3|case room|NOUN|1|obl C|PROPN|1|vocative",
            ("C: vocative(go) -> flat(room)",),
        ),
        Stage.FRAMER,
        names.with_names_behind_nouns,
    ),
    TreeRepair(
        "participles",
        "Attach a participle directly behind a person or a thing to it.",
        Example(
            "greet|VERB|0|root men|NOUN|1|obj|man|NNS wearing|VERB|1|advcl|wear|VBG hats|NOUN|3|obj",
            ("wearing: advcl(greet) -> acl(men)",),
        ),
        Stage.FRAMER,
        participles.with_participles_at_nouns,
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
    TreeRepair(
        "things_added",
        'Join a thing behind "and" to the object, not to the person or the place before it.',
        Example(
            "bring|VERB|0|root cups|NOUN|1|obj|cup to|ADP|4|case Bob|PROPN|1|obl and|CCONJ|6|cc forks|NOUN|4|conj|fork",
            ("forks: conj(Bob) -> conj(cups)",),
        ),
        Stage.FRAMER,
        additions.with_things_added,
    ),
    TreeRepair(
        "objects_behind",
        "Attach an object behind other phrases to the verb.",
        Example(
            "bring|VERB|0|root to|ADP|3|case Bob|PROPN|1|obl the|DET|5|det dish|NOUN|3|conj",
            ("dish: conj(Bob) -> obj(bring)",),
        ),
        Stage.FRAMER,
        objects_behind.with_objects_behind,
    ),
    TreeRepair(
        "inverted_places",
        'Make a place before "is" the predicate: "behind the robot is a door".',
        Example(
            "behind|ADP|2|case robots|NOUN|4|obl are|AUX|4|cop|be doors|NOUN|0|root",
            (
                "robots: obl(doors) -> root",
                "are: cop(doors) -> cop(robots)",
                "doors: root -> nsubj(robots)",
            ),
        ),
        Stage.FRAMER,
        places_told.with_inverted_places,
    ),
    TreeRepair(
        "places_described",
        'Attach a clause to the place that it describes: "the room where Anna is".',
        Example(
            "go|VERB|0|root to|ADP|3|case rooms|NOUN|1|obl where|ADV|1|parataxis Anna|PROPN|4|nsubj is|AUX|4|cop|be",
            ("where: parataxis(go) -> acl:relcl(rooms)",),
        ),
        Stage.FRAMER,
        places_told.with_places_described,
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
    TreeRepair(
        "durations_at_verbs",
        "Attach how long to the verb, not to a place.",
        Example(
            "go|VERB|0|root to|ADP|3|case halls|NOUN|1|obl for|ADP|6|case five|NUM|6|nummod minutes|NOUN|3|nmod",
            ("minutes: nmod(halls) -> obl(go)",),
        ),
        Stage.FRAMER,
        attached_phrases.with_durations_at_verbs,
    ),
)
